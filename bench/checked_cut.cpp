#include "bench/checked_cut.h"

#include <cmath>

#include "common/mesh_facts.h"

namespace kerf::bench {

namespace {

/// SplitMix64 (Steele, Lea and Flood 2014): the same numbers everywhere.
double next_uniform(std::uint64_t& state)
{
    std::uint64_t z = (state += 0x9e3779b97f4a7c15ull);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
    return double((z ^ (z >> 31)) >> 11) * 0x1p-53;
}

double surface_area(const IndexedMesh& mesh)
{
    double twice = 0.0;
    for (const TriangleGroup& group : mesh.groups) {
        if (group.kind != TriangleKind::surface) continue;
        for (std::uint32_t t = group.first; t < group.first + group.count; ++t) {
            const auto& [a, b, c] = mesh.triangles[t];
            const glm::dvec3 p(mesh.vertices[a].position), q(mesh.vertices[b].position), r(mesh.vertices[c].position);
            twice += glm::length(glm::cross(q - p, r - p));
        }
    }
    return twice / 2;
}

}  // namespace

std::vector<Plane> planes_through_the_middle(const Box& bounds, std::uint32_t count, std::uint64_t seed)
{
    std::vector<Plane> planes;
    while (planes.size() < count) {
        // Uniform on the sphere: height and longitude are independent (Archimedes).
        const double z = 2 * next_uniform(seed) - 1, angle = 6.283185307179586 * next_uniform(seed);
        const double r = std::sqrt(1 - z * z);
        if (const auto plane = Plane::through(bounds.centre(), {r * std::cos(angle), r * std::sin(angle), z}))
            planes.push_back(*plane);
    }
    return planes;
}

std::string check_cut(const Cuttable& object, const Plane& plane)
{
    constexpr double kShare = 1e-6;  // of the whole: what rounding cut points to float may change
    const double volume = object.mass_properties().volume, area = surface_area(object.to_indexed_mesh());
    const CutResult result = cut(object.clone(), plane);
    if (result.status != Status::cut) return "status " + std::string(name_of(result.status));
    double volume_sum = 0.0, area_sum = 0.0;
    for (const auto* side : {&result.positive, &result.negative})
        for (const auto& fragment : *side) {
            const IndexedMesh mesh = fragment->to_indexed_mesh();
            if (!measure(mesh).closed()) return "a side is not closed";
            volume_sum += fragment->mass_properties().volume;
            area_sum += surface_area(mesh);
        }
    if (!(std::abs(volume_sum - volume) <= kShare * std::abs(volume))) return "volumes do not add up";
    if (!(std::abs(area_sum - area) <= kShare * area)) return "surface areas do not add up";
    return {};
}

}  // namespace kerf::bench
