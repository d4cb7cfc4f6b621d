// Shapes by name, and operations on whole shapes.

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <vector>

#include "common/shapes/shapes.h"
#include "common/support/random.h"

namespace kerf::core::shapes {
namespace {

// Nearest whole number to x, at least `least`.
std::uint32_t whole(double x, std::uint32_t least)
{
    return x <= double(least) ? least : std::uint32_t(std::lround(x));
}

// A parameter n of a shape with `factor` * n * n triangles.
std::uint32_t root(double triangles, double factor)
{
    return whole(std::sqrt(triangles / factor), 1);
}

struct Entry
{
    std::string name;
    TriangleSoup (*make)(double triangles, std::uint64_t seed);
};

TriangleSoup make_uv_sphere(double n, std::uint64_t)
{
    const std::uint32_t rings = whole(0.5 + std::sqrt(n / 4.0), 2);
    return uv_sphere(1.0f, whole(n / (2.0 * (rings - 1)), 3), rings);
}

TriangleSoup make_cylinder(double n, std::uint64_t)
{
    const std::uint32_t stacks = whole(std::sqrt(n / 6.0) - 1.0, 1);
    return cylinder(0.5f, 1.0f, whole(n / (2.0 * (stacks + 1)), 3), stacks);
}

TriangleSoup make_torus(double n, std::uint64_t)
{
    const std::uint32_t minor = whole(std::sqrt(n / 5.0), 3);
    return torus(1.0f, 0.4f, whole(n / (2.0 * minor), 3), minor);
}

TriangleSoup make_pipe(double n, std::uint64_t)
{
    const std::uint32_t stacks = whole(std::sqrt(n / 12.0) - 1.0, 1);
    return pipe(0.5f, 0.3f, 1.0f, whole(n / (4.0 * (stacks + 1)), 3), stacks);
}

TriangleSoup make_bowl(double n, std::uint64_t)
{
    const std::uint32_t rings = whole(std::sqrt(n / 16.0), 1);
    return bowl(1.0f, 0.2f, whole(n / (4.0 * rings), 3), rings);
}

TriangleSoup make_menger_sponge(double n, std::uint64_t)
{
    // 4 * 20^level + 8 * 8^level triangles; each level has about 18 times as many as the one before.
    std::uint32_t level = 0;
    for (double count = 12.0; level < 4 && n > count * std::sqrt(18.0); ++level) {
        count = 4.0 * std::pow(20.0, level + 1) + 8.0 * std::pow(8.0, level + 1);
    }
    return menger_sponge(level);
}

TriangleSoup make_spiral_wall(double n, std::uint64_t)
{
    constexpr double kTurns = 4.0;
    return spiral_wall(float(kTurns), whole((n - 4.0) / (8.0 * kTurns), 8));
}

const std::vector<Entry>& entries()
{
    static const std::vector<Entry> all{
        {"asteroid", [](double n, std::uint64_t seed) { return asteroid(std::uint64_t(n), seed); }},
        {"bowl", make_bowl},
        {"box", [](double n, std::uint64_t) { return box(glm::vec3(1.0f), glm::uvec3(root(n, 12.0))); }},
        {"comb", [](double n, std::uint64_t) { return comb(whole((n + 4.0) / 24.0, 2)); }},
        {"cone", [](double n, std::uint64_t) { return cone(0.5f, 1.0f, whole(n / 2.0, 3)); }},
        {"cylinder", make_cylinder},
        {"icosphere", [](double n, std::uint64_t) { return icosphere(1.0f, root(n, 20.0)); }},
        {"l_step", [](double n, std::uint64_t) { return l_step(root(n, 28.0)); }},
        {"menger_sponge", make_menger_sponge},
        {"nested_spheres",
         [](double n, std::uint64_t) {
             return nested_spheres(std::array{1.0f, 0.7f, 0.4f}, root(n, 60.0));
         }},
        {"overlapping_spheres", [](double n, std::uint64_t) { return overlapping_spheres(1.0f, 1.0f, root(n, 40.0)); }},
        {"pipe", make_pipe},
        {"sphere_in_sphere", [](double n, std::uint64_t) { return sphere_in_sphere(1.0f, 0.6f, root(n, 40.0)); }},
        {"spiral_wall", make_spiral_wall},
        {"torus", make_torus},
        {"tray", [](double n, std::uint64_t) { return tray(root(n, 92.0)); }},
        {"two_legs", [](double n, std::uint64_t) { return two_legs(root(n, 44.0)); }},
        {"uv_sphere", make_uv_sphere},
    };
    return all;
}

// Whether indices are in range and lists are as long as they must be.
bool is_whole(const TriangleSoup& soup)
{
    const std::size_t materials = soup.triangle_materials.size();
    return are_in_range(soup.triangles, soup.vertices.size()) &&
           (materials == 0 || materials == soup.triangles.size()) &&
           std::all_of(soup.streams.begin(), soup.streams.end(), [&](const VertexStream& stream) {
               return stream.values.size() == soup.vertices.size() * stream.width;
           });
}

// A random order of 0 .. n-1 (Fisher and Yates).
std::vector<std::uint32_t> random_order(std::size_t n, Random& random)
{
    std::vector<std::uint32_t> order(n);
    std::iota(order.begin(), order.end(), 0u);
    for (std::size_t i = n; i > 1; --i) std::swap(order[i - 1], order[random.below(std::uint32_t(i))]);
    return order;
}

}  // namespace

TriangleSoup shuffled(TriangleSoup soup, std::uint64_t seed)
{
    if (!is_whole(soup)) return soup;
    Random random(seed);
    const std::vector<std::uint32_t> old_vertex = random_order(soup.vertices.size(), random);
    const std::vector<std::uint32_t> old_triangle = random_order(soup.triangles.size(), random);
    TriangleSoup result;
    result.materials = soup.materials;
    result.has_normals = soup.has_normals;

    std::vector<std::uint32_t> new_vertex(old_vertex.size());
    result.vertices.resize(soup.vertices.size());
    for (std::size_t i = 0; i < old_vertex.size(); ++i) {
        new_vertex[old_vertex[i]] = std::uint32_t(i);
        result.vertices[i] = soup.vertices[old_vertex[i]];
    }
    for (const VertexStream& stream : soup.streams) {
        VertexStream moved{stream.name, stream.width, Buffer<float>(stream.values.size())};
        for (std::size_t i = 0; i < old_vertex.size(); ++i) {
            std::copy_n(&stream.values[std::size_t(old_vertex[i]) * stream.width], stream.width,
                        &moved.values[i * stream.width]);
        }
        result.streams.push_back(std::move(moved));
    }
    result.triangles.reserve(soup.triangles.size());
    for (const std::uint32_t i : old_triangle) {
        const Triangle& t = soup.triangles[i];
        result.triangles.push_back({new_vertex[t[0]], new_vertex[t[1]], new_vertex[t[2]]});
        if (!soup.triangle_materials.empty()) result.triangle_materials.push_back(soup.triangle_materials[i]);
    }
    return result;
}

const std::vector<std::string>& names()
{
    static const std::vector<std::string> all = [] {
        std::vector<std::string> list;
        for (const Entry& entry : entries()) list.push_back(entry.name);
        return list;
    }();
    return all;
}

std::optional<TriangleSoup> make(std::string_view name, std::uint64_t triangles, std::uint64_t seed)
{
    const auto found = std::find_if(entries().begin(), entries().end(), [&](const Entry& e) { return e.name == name; });
    if (found == entries().end()) return std::nullopt;
    return found->make(double(std::min(triangles, kMostTriangles)), seed);
}

}  // namespace kerf::core::shapes
