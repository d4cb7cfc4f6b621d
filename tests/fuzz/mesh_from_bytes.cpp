#include "fuzz/mesh_from_bytes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <set>
#include <utility>

#include "common/shapes/shapes.h"
#include "support/open_soups.h"

namespace kerf::core::fuzz {

namespace {

/// Largest coordinates, as powers of two: most inputs stay where rounding is the same everywhere.
constexpr int kUsualExponent = 20, kExtremeExponent = 126;

/// Meshes of many sheets and holes are too much for bytes to describe: a number names one.
constexpr std::uint32_t kOpenSoupTriangles = 100;

bool is_open_soup(std::uint8_t kind)
{
    return kind >= 0xD0 && kind < 0xF0;
}

glm::vec3 position_from(ByteReader& bytes, int largest_exponent)
{
    glm::vec3 p;
    for (int axis = 0; axis < 3; ++axis) p[axis] = bytes.coordinate(largest_exponent);
    return p;
}

TriangleSoup shape_from(ByteReader& bytes, int largest_exponent)
{
    const auto& names = shapes::names();
    const std::uint32_t name = bytes.below(static_cast<std::uint32_t>(names.size()));
    const std::uint32_t triangles = 4 + bytes.below(64);
    TriangleSoup soup = *shapes::make(names[name], triangles, bytes.byte());
    // Vertices are moved point by point: what was closed stays closed, but may fall together and pass through itself.
    const std::uint32_t moves = bytes.below(12);
    for (std::uint32_t i = 0; i < moves; ++i) {
        const glm::vec3 from = soup.vertices[bytes.below(static_cast<std::uint32_t>(soup.vertices.size()))].position;
        const std::uint8_t kind = bytes.byte();
        const glm::vec3 to = kind < 0x80
                                 ? soup.vertices[bytes.below(static_cast<std::uint32_t>(soup.vertices.size()))].position
                                 : position_from(bytes, largest_exponent);
        for (Vertex& v : soup.vertices)
            if (v.position == from) {
                if (kind % 4 == 0)
                    v.position = to;
                else
                    v.position[kind % 4 - 1] = to[kind % 4 - 1];
            }
    }
    return soup;
}

TriangleSoup triangles_from(ByteReader& bytes, int largest_exponent)
{
    TriangleSoup soup;
    const std::uint32_t points = 3 + bytes.below(30), triangles = 1 + bytes.below(60);
    for (std::uint32_t i = 0; i < points; ++i)
        soup.vertices.push_back({position_from(bytes, largest_exponent), {0.0f, 0.0f, 1.0f}, {0.0f, 0.0f}});
    for (std::uint32_t i = 0; i < triangles && !bytes.empty(); ++i) {
        const auto corner = [&] { return bytes.below(points); };
        soup.triangles.push_back({corner(), corner(), corner()});
    }
    // Four faces over the first four points: some inputs have something closed in them.
    if (points >= 4)
        for (const Triangle& t : std::array<Triangle, 4>{{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}})
            soup.triangles.push_back(t);
    soup.has_normals = false;
    return soup;
}

void decorate(TriangleSoup& soup, ByteReader& bytes)
{
    const std::uint8_t what = bytes.byte();
    if ((what & 1) != 0) {
        soup.materials = {{"skin", glm::vec4(1.0f), ""}, {"cap", glm::vec4(1.0f), ""}};
        for (std::size_t t = 0; t < soup.triangles.size(); ++t) soup.triangle_materials.push_back(t % 3 == 0 ? 1u : 0u);
    }
    if ((what & 2) != 0) {
        soup.streams.push_back({"heat", 2, {}});
        for (std::size_t i = 0; i < 2 * soup.vertices.size(); ++i)
            soup.streams.back().values.push_back(static_cast<float>(i) / 7.0f);
    }
    if ((what & 4) != 0) {
        // Every corner its own vertex: seams everywhere.
        TriangleSoup apart;
        std::swap(apart.triangle_materials, soup.triangle_materials);
        std::swap(apart.materials, soup.materials);
        for (const Triangle& t : soup.triangles) {
            const auto first = static_cast<std::uint32_t>(apart.vertices.size());
            for (std::size_t k = 0; k < 3; ++k) {
                apart.vertices.push_back(soup.vertices[t[k]]);
                apart.vertices.back().uv = {static_cast<float>(k), static_cast<float>(first)};
            }
            apart.triangles.push_back({first, first + 1, first + 2});
        }
        apart.has_normals = soup.has_normals;
        soup = std::move(apart);
    }
    if ((what & 8) != 0) {
        // A power of two changes no digit of a coordinate.
        const float scale = std::ldexp(1.0f, static_cast<int>(bytes.below(41)) - 20);
        for (Vertex& v : soup.vertices) v.position *= scale;
    }
    if ((what & 16) != 0) {
        constexpr std::array<float, 4> kOffsets{1.0f, 1000.0f, 3e4f, 1e6f};
        const glm::vec3 offset(kOffsets[bytes.below(4)], -kOffsets[bytes.below(4)], 0.0f);
        for (Vertex& v : soup.vertices) v.position += offset;
    }
    for (Vertex& v : soup.vertices)
        for (int axis = 0; axis < 3; ++axis)
            if (!std::isfinite(v.position[axis])) v.position[axis] = 0.0f;
}

}  // namespace

TriangleSoup soup_from(ByteReader& bytes)
{
    const std::uint8_t kind = bytes.byte();
    const int largest_exponent = kind >= 0xF0 ? kExtremeExponent : kUsualExponent;
    TriangleSoup soup = is_open_soup(kind) ? test::open_soup(bytes.word(), kOpenSoupTriangles).soup
                        : kind % 2 == 0    ? shape_from(bytes, largest_exponent)
                                           : triangles_from(bytes, largest_exponent);
    decorate(soup, bytes);
    return soup;
}

Plane plane_from(ByteReader& bytes, const IndexedMesh& mesh)
{
    const auto vertex = [&] {
        return glm::dvec3(mesh.vertices[bytes.below(static_cast<std::uint32_t>(mesh.vertices.size()))].position);
    };
    const auto small = [&] { return static_cast<double>(static_cast<int>(bytes.byte() % 9) - 4); };
    std::optional<Plane> plane;
    switch (bytes.below(6)) {
        case 0: {  // across an axis, through a vertex
            const std::uint32_t axis = bytes.below(6);
            glm::dvec3 normal(0.0);
            normal[static_cast<int>(axis % 3)] = axis < 3 ? 1.0 : -1.0;
            plane = Plane::through(vertex(), normal);
            break;
        }
        case 1: {  // through three vertices
            const glm::dvec3 a = vertex(), b = vertex(), c = vertex();
            plane = Plane::through(a, glm::cross(b - a, c - a));
            break;
        }
        case 2: {  // in a face
            const Triangle& t = mesh.triangles[bytes.below(static_cast<std::uint32_t>(mesh.triangles.size()))];
            const glm::dvec3 a(mesh.vertices[t[0]].position), b(mesh.vertices[t[1]].position),
                c(mesh.vertices[t[2]].position);
            plane = Plane::through(a, glm::cross(b - a, c - a));
            break;
        }
        case 3:  // through a vertex
            plane = Plane::through(vertex(), {small(), small(), small()});
            break;
        case 4:  // between two vertices
            plane = Plane::through((vertex() + vertex()) * 0.5, {small(), small(), small()});
            break;
        default:  // anywhere
            plane = Plane::through({double(bytes.coordinate(20)), double(bytes.coordinate(20)), 0.0},
                                   {double(bytes.coordinate(20)), double(bytes.coordinate(20)), 0.5});
            break;
    }
    // Across the middle of the bounds where the numbers give no plane.
    if (!plane) plane = Plane::through(glm::dvec3(mesh.bounds().centre()), {1.0, 0.0, 0.0});
    return plane.value_or(Plane{});
}

bool is_manifold(const IndexedMesh& mesh)
{
    std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> fan_after;  // point and next point: third corner
    std::map<std::uint32_t, std::size_t> corners;
    for (const Triangle& t : mesh.triangles)
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint32_t a = mesh.points[t[i]], b = mesh.points[t[(i + 1) % 3]], c = mesh.points[t[(i + 2) % 3]];
            if (!edges.emplace(a, b).second) return false;
            fan_after[{a, b}] = c;
            ++corners[a];
        }
    for (const auto& [point, count] : corners) {
        // To the start of the fan, or once around, and then along it.
        std::map<std::uint32_t, std::uint32_t> before;
        const auto first = fan_after.lower_bound({point, 0});
        for (auto it = first; it != fan_after.end() && it->first.first == point; ++it)
            before[it->second] = it->first.second;
        std::uint32_t start = first->first.second;
        for (std::size_t i = 0; i < count && before.count(start) != 0; ++i) start = before[start];
        std::size_t met = 0;
        for (std::uint32_t next = start; met < count; ++met) {
            const auto triangle = fan_after.find({point, next});
            if (triangle == fan_after.end() || (met > 0 && next == start)) break;
            next = triangle->second;
        }
        if (met != count) return false;
    }
    return true;
}

}  // namespace kerf::core::fuzz
