#include "bench/checked_cut.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "bench/objects.h"
#include "common/support/random.h"

namespace kerf::bench {

namespace {

/// How far from the plane, in units in the last place of the mesh's largest coordinate, a piece may reach
/// (docs/floating-point.md: plane noise).
constexpr double kNoiseInUnits = 4.0;

/// In mesh units, for a mesh with these bounds.
double plane_noise(const Box& bounds)
{
    float largest = 0.0f;
    for (const Vec3f& corner : {bounds.lo, bounds.hi})
        for (const float coordinate : {corner.x, corner.y, corner.z}) largest = std::max(largest, std::abs(coordinate));
    const float above = std::nextafter(largest, std::numeric_limits<float>::infinity());
    return kNoiseInUnits * (double(above) - double(largest));
}

std::array<Vec3f, 3> corners_of(const MeshArrays& mesh, std::size_t triangle)
{
    const auto corner = [&](std::size_t i) { return mesh.positions[mesh.indices[3 * triangle + i]]; };
    return {corner(0), corner(1), corner(2)};
}

double surface_area(const MeshArrays& mesh)
{
    double twice = 0.0;
    for (std::size_t t = 0; t < mesh.kinds.size(); ++t) {
        if (mesh.kinds[t] != TriangleKind::surface) continue;
        const auto [a, b, c] = corners_of(mesh, t);
        twice += glm::length(glm::cross(to_glm(b) - to_glm(a), to_glm(c) - to_glm(a)));
    }
    return twice / 2;
}

bool is_closed(const MeshArrays& mesh)
{
    std::vector<std::uint32_t> corners;
    corners.reserve(mesh.indices.size());
    for (const std::uint32_t vertex : mesh.indices) corners.push_back(mesh.points[vertex]);
    return are_closed(corners);
}

bool has_degenerate_triangle(const MeshArrays& mesh)
{
    for (std::size_t t = 0; t < mesh.kinds.size(); ++t)
        if (const auto [a, b, c] = corners_of(mesh, t); a == b || b == c || c == a) return true;
    return false;
}

/// What is wrong with a piece on this side of the plane; empty if nothing is.
std::string check_side(const MeshArrays& mesh, const Plane& plane, Side side, double noise)
{
    if (mesh.kinds.empty()) return "a side has no triangles";
    if (!is_closed(mesh)) return "a side is not closed";
    if (has_degenerate_triangle(mesh)) return "a triangle has two corners in one place";
    for (const Vec3f& position : mesh.positions) {
        const double distance = plane.distance(position);
        if ((side == Side::positive ? -distance : distance) > noise) return "a vertex is on the wrong side";
    }
    return {};
}

}  // namespace

std::vector<Plane> planes_through_the_middle(const Box& bounds, std::uint32_t count, std::uint64_t seed)
{
    std::vector<Plane> planes;
    core::Random random(seed);
    while (planes.size() < count) {
        // Uniform on the sphere: height and longitude are independent (Archimedes).
        const double z = 2 * random.unit() - 1, angle = 6.283185307179586 * random.unit();
        const double r = std::sqrt(1 - z * z);
        if (const auto plane = Plane::at(Point(centre_of(bounds)), Normal(r * std::cos(angle), r * std::sin(angle), z)))
            planes.push_back(*plane);
    }
    return planes;
}

std::string check_cut(const Object& object, const Plane& plane, CutCounts* counted)
{
    constexpr double kShare = 1e-6;  // of the whole: what rounding cut points to float may change
    const double volume = object.mass_properties().volume, area = surface_area(value_of(object.mesh()).arrays());
    const double noise = plane_noise(object.bounds());
    Cut result = cut(clone_of(object), plane);
    if (result.status != Status::done) return "status " + std::string(text(result.status));
    if (counted) {
        const CutStatistics& s = result.statistics();
        counted->all.crossing_triangles += s.crossing_triangles;
        counted->all.triangles_touched += s.triangles_touched;
        counted->all.nodes_visited += s.nodes_visited;
        counted->all.bytes_to_upload += s.bytes_to_upload;
        counted->report.vertex_comparisons += report_costs(result).vertex_comparisons;
    }
    double volume_sum = 0.0, area_sum = 0.0;
    for (const Side side : {Side::positive, Side::negative})
        for (std::size_t i = 0; const Object* piece = result.piece(side, i); ++i) {
            const Mesh mesh = value_of(piece->mesh());
            const MeshArrays arrays = mesh.arrays();
            if (std::string error = check_side(arrays, plane, side, noise); !error.empty()) return error;
            volume_sum += piece->mass_properties().volume;
            area_sum += surface_area(arrays);
        }
    if (!(std::abs(volume_sum - volume) <= kShare * std::abs(volume))) return "volumes do not add up";
    if (!(std::abs(area_sum - area) <= kShare * area)) return "surface areas do not add up";
    return {};
}

bool are_closed(std::span<const std::uint32_t> corners)
{
    // Edges from the smaller to the larger point, and those that run back.
    std::vector<std::uint64_t> there, back;
    there.reserve(corners.size() / 2);
    back.reserve(corners.size() / 2);
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const std::uint64_t a = corners[i], b = corners[i % 3 == 2 ? i - 2 : i + 1];
        if (a < b) there.push_back(a << 32 | b);
        if (b < a) back.push_back(b << 32 | a);
    }
    if (there.size() != back.size()) return false;
    std::sort(there.begin(), there.end());
    std::sort(back.begin(), back.end());
    return there == back;
}

}  // namespace kerf::bench
