#include "bench/timed_shapes.h"

#include <kerf/shapes.h>

#include <numeric>
#include <utility>

#include "bench/checked_cut.h"
#include "bench/objects.h"
#include "common/support/random.h"

namespace kerf::bench {

namespace {

/// A random order of 0 .. n-1 (Fisher and Yates).
std::vector<std::uint32_t> random_order(std::size_t n, core::Random& random)
{
    std::vector<std::uint32_t> order(n);
    std::iota(order.begin(), order.end(), 0u);
    for (std::size_t i = n; i > 1; --i) std::swap(order[i - 1], order[random.below(std::uint32_t(i))]);
    return order;
}

/// The same triangles in a random order with randomly numbered vertices: a bad case for the caches of a linear cutter.
Mesh shuffled(const Mesh& mesh, std::uint64_t seed)
{
    core::Random random(seed);
    const MeshArrays from = mesh.arrays();
    const std::vector<std::uint32_t> old_vertex = random_order(from.positions.size(), random);
    const std::vector<std::uint32_t> old_triangle = random_order(from.kinds.size(), random);

    std::vector<std::uint32_t> new_vertex(old_vertex.size()), indices;
    std::vector<Vec3f> positions, normals;
    std::vector<Vec2f> uvs;
    for (std::size_t i = 0; i < old_vertex.size(); ++i) {
        new_vertex[old_vertex[i]] = std::uint32_t(i);
        positions.push_back(from.positions[old_vertex[i]]);
        normals.push_back(from.normals[old_vertex[i]]);
        uvs.push_back(from.uvs[old_vertex[i]]);
    }
    for (const std::size_t t : old_triangle)
        for (std::size_t i = 0; i < 3; ++i) indices.push_back(new_vertex[from.indices[3 * t + i]]);

    MeshInput input;
    input.positions = &positions[0].x;
    input.vertex_count = positions.size();
    input.normals = &normals[0].x;
    input.uvs = &uvs[0].x;
    input.indices = indices.data();
    input.triangle_count = old_triangle.size();
    return value_of(Mesh::make(input));
}

}  // namespace

std::vector<Plane> planes_of_shape(const Mesh& shape)
{
    constexpr std::uint64_t kPlaneSeed = 99;
    constexpr std::uint32_t kPlanes = 5;
    return planes_through_the_middle(shape.bounds(), kPlanes, kPlaneSeed);
}

const Mesh& timed_shape(const std::string& name, std::uint64_t triangles)
{
    constexpr std::uint64_t kSeed = 1;
    static std::pair<std::string, std::uint64_t> key;
    static Mesh mesh;
    if (key != std::pair{name, triangles}) {
        mesh = {};
        ShapeOptions options;
        options.seed = kSeed;
        mesh = value_of(make_shape("asteroid", triangles, options));
        if (name == "shuffled") mesh = shuffled(mesh, kSeed);
        key = {name, triangles};
    }
    return mesh;
}

}  // namespace kerf::bench
