#pragma once

#include <cstdint>
#include <glm/geometric.hpp>
#include <string>

#include "common/mesh/indexed_mesh.h"
#include "common/mesh/plane.h"
#include "common/mesh/plane_noise.h"
#include "support/fixtures.h"

// What RapidCheck's properties of cut() are tried on.

namespace kerf::core::test {

/// A mesh somewhere in space and a plane worth cutting it by.
struct Case
{
    std::string name;
    IndexedMesh mesh;
    Plane plane;
    std::uint64_t seed;

    double noise() const { return plane_noise(mesh.bounds().largest_coordinate()); }
};

/// Uniform in [0, bound), whatever size RapidCheck is at.
std::uint32_t below(std::uint32_t bound);

/// A motion of space: a turn, then a shift.
struct Motion
{
    glm::dvec3 x, y, z;  ///< rows of the turn
    glm::dvec3 offset;

    glm::dvec3 turned(const glm::dvec3& v) const { return {glm::dot(x, v), glm::dot(y, v), glm::dot(z, v)}; }
};
/// Any turn, and a shift of up to three units.
Motion any_motion(Random& random);

/// Vertices of one point stay bit-equal, because each position is mapped by itself and rounded.
void move(IndexedMesh& mesh, const Motion& motion);

/// A random plane; most go through vertices, along edges or in faces.
Plane some_plane(const IndexedMesh& mesh, Random& random);

/// A mesh that is left where it is, turned by quarters, or moved anyhow; and some plane.
Case make_case(std::string name, IndexedMesh mesh, std::uint64_t seed);

/// A fixture, or a generated shape with a random number of triangles.
Case any_case();

}  // namespace kerf::core::test
