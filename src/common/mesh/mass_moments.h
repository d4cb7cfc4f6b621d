#pragma once

#include <cmath>
#include <glm/vec3.hpp>
#include <limits>
#include <span>

#include "common/mesh/float_rules.h"
#include "common/mesh/indexed_mesh.h"
#include "common/mesh/mass_properties.h"

// The sums that mass properties are made of. For back ends, which add them up over the parts of an object.

namespace kerf::core {

/// Volume integrals of 1, x, y, z and the products, over signed tetrahedra from one reference point. They add up: over
/// triangles, over parts of a mesh, over the nodes of a tree, as long as the reference point is the same.
///
/// Method: Blow and Binstock, "How to find the inertia tensor (or other mass properties) of a 3D solid body represented
/// by a triangle mesh", 2004; tetrahedron integrals as in Tonon, "Explicit exact formulas for the 3-D tetrahedron
/// inertia tensor", 2004, with s s' + p p' + q q' + r r' (s = p + q + r) written as the sum over the three edges,
/// (p+q)(p+q)' + (q+r)(q+r)' + (r+p)(r+p)': the same polynomial with one product less for each entry.
struct MassMoments
{
    double volume6 = 0.0;         ///< 6 * integral of 1
    glm::dvec3 first24{0.0};      ///< 24 * integral of (x, y, z) about the reference point
    glm::dvec3 squares120{0.0};   ///< 120 * integral of (xx, yy, zz)
    glm::dvec3 products120{0.0};  ///< 120 * integral of (yz, zx, xy)

    /// Of a part that was not summed: no part that it is added to is known then, either.
    static MassMoments unknown()
    {
        MassMoments moments;
        moments.volume6 = std::numeric_limits<double>::quiet_NaN();
        return moments;
    }
    bool are_known() const { return !std::isnan(volume6); }

    /// Adds the tetrahedron (reference, a, b, c).
    void add(const glm::dvec3& reference, const glm::vec3& a, const glm::vec3& b, const glm::vec3& c)
    {
        const glm::dvec3 p = glm::dvec3(a) - reference, q = glm::dvec3(b) - reference, r = glm::dvec3(c) - reference;
        const double det =
            p.x * (q.y * r.z - q.z * r.y) + p.y * (q.z * r.x - q.x * r.z) + p.z * (q.x * r.y - q.y * r.x);
        const glm::dvec3 pq = p + q, qr = q + r, rp = r + p;
        volume6 += det;
        first24 += det * (pq + r);
        squares120 += det * (pq * pq + qr * qr + rp * rp);
        const auto product = [](const glm::dvec3& t) { return glm::dvec3(t.y * t.z, t.z * t.x, t.x * t.y); };
        products120 += det * (product(pq) + product(qr) + product(rp));
    }

    void add(const MassMoments& other)
    {
        volume6 += other.volume6;
        first24 += other.first24;
        squares120 += other.squares120;
        products120 += other.products120;
    }

    /// The sums as mass properties; `reference` is the point that they were taken about.
    MassProperties properties(const glm::dvec3& reference) const;
};

/// Sums the moments of triangles about `reference`. For back ends: indices must be in range. It takes four triangles at
/// a time, so the last bits differ from those of one add() after the other; equal inputs give equal bits. Cheapest
/// about the origin. O(triangles).
MassMoments mass_moments(std::span<const Vertex> vertices, std::span<const Triangle> triangles,
                         const glm::dvec3& reference);

/// The same for triangles in several runs, one after another: the same bits as for one run that holds them all.
MassMoments mass_moments(std::span<const Vertex> vertices, std::span<const std::span<const Triangle>> runs,
                         const glm::dvec3& reference);

/// Whether a closed shell has practically no volume: at most the surface area of its box times `noise` (plane_noise()).
/// `volume6` is MassMoments::volume6.
bool has_no_volume(double volume6, const Box& box, double noise);

/// A good reference point for a mesh with these bounds: the centre of the box, or the origin if it is so close to the
/// box that hardly any digits are lost.
glm::dvec3 mass_reference(const Box& bounds);

}  // namespace kerf::core
