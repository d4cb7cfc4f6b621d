#include "tools/cap_facts.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <map>
#include <utility>

#include "tools/section_facts.h"

namespace kerf::tools {

namespace {

/// Two unit vectors in the plane that make a right-handed frame with its normal.
struct Frame
{
    glm::dvec3 u, v;

    explicit Frame(const glm::dvec3& normal)
    {
        const glm::dvec3 size = glm::abs(normal);
        glm::dvec3 axis{0.0};
        axis[size.x <= size.y && size.x <= size.z ? 0 : (size.y <= size.z ? 1 : 2)] = 1.0;
        u = glm::normalize(glm::cross(axis, normal));
        v = glm::cross(normal, u);
    }

    glm::dvec2 operator()(const glm::dvec3& p) const { return {glm::dot(u, p), glm::dot(v, p)}; }
};

double twice_signed_area(const FlatCap& cap, const Triangle& t)
{
    const glm::dvec2 p = cap.points[t[1]] - cap.points[t[0]], q = cap.points[t[2]] - cap.points[t[0]];
    return p.x * q.y - p.y * q.x;
}

}  // namespace

FlatCap flat_cap(const FlatMesh& mesh, std::uint32_t material, const glm::dvec3& normal)
{
    const Frame frame(normal);
    FlatCap cap;
    std::map<std::uint32_t, std::uint32_t> flat_index;
    for (const TriangleGroup& group : mesh.groups) {
        if (group.kind != TriangleKind::cap || group.material != material) continue;
        for (std::uint32_t t = group.first; t < group.first + group.count; ++t) {
            Triangle flat{};
            for (std::size_t i = 0; i < 3; ++i) {
                const std::uint32_t vertex = mesh.triangles[t][i];
                const auto [place, is_new] = flat_index.emplace(vertex, static_cast<std::uint32_t>(cap.points.size()));
                if (is_new) cap.points.push_back(frame(glm::dvec3(mesh.vertices[vertex].position)));
                flat[i] = place->second;
            }
            cap.triangles.push_back(flat);
        }
    }
    return cap;
}

std::vector<std::vector<glm::dvec2>> flat_loops(std::span<const Outline> loops, const glm::dvec3& normal)
{
    const Frame frame(normal);
    std::vector<std::vector<glm::dvec2>> flat;
    for (const Outline& loop : loops) {
        if (!loop.closed) continue;
        auto& points = flat.emplace_back();
        for (const glm::vec3& p : loop.points) points.push_back(frame(glm::dvec3(p)));
    }
    return flat;
}

double unsigned_area(const FlatCap& cap)
{
    double twice = 0.0;
    for (const Triangle& t : cap.triangles) twice += std::abs(twice_signed_area(cap, t));
    return 0.5 * twice;
}

double least_angle(const FlatCap& cap)
{
    constexpr double kPi = 3.14159265358979323846;
    double least = kPi;
    for (const Triangle& t : cap.triangles)
        for (std::size_t i = 0; i < 3; ++i) {
            const glm::dvec2 corner = cap.points[t[i]], p = cap.points[t[(i + 1) % 3]] - corner,
                             q = cap.points[t[(i + 2) % 3]] - corner;
            least = std::min(least, std::atan2(std::abs(p.x * q.y - p.y * q.x), glm::dot(p, q)));
        }
    return least * 180.0 / kPi;
}

double overlap_area(const FlatCap& cap)
{
    if (cap.triangles.size() > kMostForOverlap) return std::numeric_limits<double>::quiet_NaN();
    // Each triangle as a loop of its own, all in one direction: they wind around a place as often as it is covered.
    std::vector<Outline> loops;
    for (const Triangle& t : cap.triangles) {
        Outline loop;
        for (const std::uint32_t corner : t) loop.points.emplace_back(glm::vec2(cap.points[corner]), 0.0f);
        if (twice_signed_area(cap, t) < 0.0) std::swap(loop.points[1], loop.points[2]);
        loops.push_back(std::move(loop));
    }
    const std::optional<WindingFacts> winding = measure_winding(steps_of(loops), {0.0, 0.0, 1.0});
    return winding ? winding->multiple : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace kerf::tools
