#include "support/referee.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>
#include <map>
#include <memory>
#include <numeric>
#include <unordered_map>

namespace kerf::core::referee {

namespace {

/// Counts directed edges between keys; returns how many lack a reverse.
std::size_t unmatched(std::vector<std::array<std::uint64_t, 2>> edges)
{
    std::vector<std::array<std::uint64_t, 2>> reversed(edges.size());
    std::transform(edges.begin(), edges.end(), reversed.begin(), [](const auto& e) { return std::array{e[1], e[0]}; });
    std::sort(edges.begin(), edges.end());
    std::sort(reversed.begin(), reversed.end());
    std::vector<std::array<std::uint64_t, 2>> difference;
    std::set_difference(edges.begin(), edges.end(), reversed.begin(), reversed.end(), std::back_inserter(difference));
    return difference.size();
}

template <class Key>
std::size_t open_edges_by(const IndexedMesh& mesh, Key key)
{
    std::vector<std::array<std::uint64_t, 2>> edges;
    edges.reserve(mesh.triangles.size() * 3);
    for (const Triangle& t : mesh.triangles)
        for (std::size_t i = 0; i < 3; ++i) edges.push_back({key(t[i]), key(t[(i + 1) % 3])});
    return unmatched(std::move(edges));
}

std::array<std::uint32_t, 3> bits_of(const glm::vec3& p)
{
    std::array<std::uint32_t, 3> bits;
    std::memcpy(bits.data(), &p, sizeof bits);
    return bits;
}

const glm::vec3& position(const IndexedMesh& mesh, const Triangle& t, std::size_t corner)
{
    return mesh.vertices[t[corner]].position;
}

double area_of(const IndexedMesh& mesh, const Triangle& t)
{
    const glm::dvec3 a(position(mesh, t, 0)), b(position(mesh, t, 1)), c(position(mesh, t, 2));
    return glm::length(glm::cross(b - a, c - a)) / 2;
}

}  // namespace

std::size_t open_edges(const IndexedMesh& mesh)
{
    return open_edges_by(mesh, [&](std::uint32_t v) { return std::uint64_t(mesh.points[v]); });
}

bool is_well_formed(const IndexedMesh& mesh)
{
    constexpr std::uint64_t kIds = std::uint64_t{1} << 32;
    const std::uint64_t vertices = mesh.vertices.size(), triangles = mesh.triangles.size();
    if (triangles == 0 || 3 * triangles > kIds || vertices + 1 >= kIds) return false;
    if (mesh.points.size() != vertices || mesh.sources.size() != triangles) return false;

    constexpr std::uint32_t kExponent = 0x7f800000u, kNegativeZero = 0x80000000u;
    const auto is_number = [](float value) { return (std::bit_cast<std::uint32_t>(value) & kExponent) != kExponent; };
    const auto is_coordinate = [&](float value) {
        return is_number(value) && std::bit_cast<std::uint32_t>(value) != kNegativeZero;
    };
    for (const auto& [p, n, uv] : mesh.vertices) {
        if (!is_coordinate(p.x) || !is_coordinate(p.y) || !is_coordinate(p.z)) return false;
        if (!is_number(n.x) || !is_number(n.y) || !is_number(n.z) || !is_number(uv.x) || !is_number(uv.y)) return false;
    }

    std::map<std::uint32_t, std::array<std::uint32_t, 3>> place_of_point;
    for (std::size_t v = 0; v < vertices; ++v) {
        const auto place = bits_of(mesh.vertices[v].position);
        if (place_of_point.try_emplace(mesh.points[v], place).first->second != place) return false;
    }
    if (place_of_point.size() != mesh.point_count) return false;
    if (!place_of_point.empty() && place_of_point.rbegin()->first + std::uint64_t{1} != mesh.point_count) return false;

    for (const Triangle& triangle : mesh.triangles)
        for (const std::uint32_t v : triangle)
            if (!(v < vertices)) return false;
    if (triangles_with_equal_corners(mesh) != 0) return false;

    std::uint64_t end = 0;
    for (const TriangleGroup& group : mesh.groups) {
        if (group.first != end || group.material >= mesh.materials.size()) return false;
        if (group.kind != TriangleKind::surface && group.kind != TriangleKind::cap) return false;
        end += group.count;
    }
    if (end != triangles) return false;

    return std::all_of(mesh.streams.begin(), mesh.streams.end(), [&](const VertexStream& stream) {
        return stream.width > 0 && stream.values.size() == std::uint64_t{stream.width} * vertices;
    });
}

std::size_t open_edges_by_position(const IndexedMesh& mesh)
{
    std::map<std::array<std::uint32_t, 3>, std::uint64_t> ids;
    std::vector<std::uint64_t> id(mesh.vertices.size());
    for (std::size_t v = 0; v < id.size(); ++v)
        id[v] = ids.try_emplace(bits_of(mesh.vertices[v].position), ids.size()).first->second;
    return open_edges_by(mesh, [&](std::uint32_t v) { return id[v]; });
}

std::size_t triangles_with_equal_corners(const IndexedMesh& mesh)
{
    return static_cast<std::size_t>(std::count_if(mesh.triangles.begin(), mesh.triangles.end(), [&](const Triangle& t) {
        const glm::vec3 &a = position(mesh, t, 0), &b = position(mesh, t, 1), &c = position(mesh, t, 2);
        return a == b || b == c || c == a;
    }));
}

double volume(const IndexedMesh& mesh)
{
    if (mesh.vertices.empty()) return 0;
    const glm::dvec3 origin(mesh.vertices[0].position);
    long double six = 0;
    for (const Triangle& t : mesh.triangles) {
        const glm::dvec3 a = glm::dvec3(position(mesh, t, 0)) - origin, b = glm::dvec3(position(mesh, t, 1)) - origin,
                         c = glm::dvec3(position(mesh, t, 2)) - origin;
        six += static_cast<long double>(glm::dot(a, glm::cross(b, c)));
    }
    return static_cast<double>(six / 6);
}

double volume(const std::vector<std::unique_ptr<Cuttable>>& fragments)
{
    double sum = 0;
    for (const auto& fragment : fragments) sum += volume(fragment->to_indexed_mesh());
    return sum;
}

double area(const IndexedMesh& mesh)
{
    long double sum = 0;
    for (const Triangle& t : mesh.triangles) sum += static_cast<long double>(area_of(mesh, t));
    return static_cast<double>(sum);
}

double area(const IndexedMesh& mesh, TriangleKind kind)
{
    long double sum = 0;
    for (const TriangleGroup& group : mesh.groups) {
        if (group.kind != kind) continue;
        for (std::uint32_t t = group.first; t < group.first + group.count; ++t)
            sum += static_cast<long double>(area_of(mesh, mesh.triangles[t]));
    }
    return static_cast<double>(sum);
}

double cap_area_in_plane(const IndexedMesh& mesh, const glm::dvec3& normal)
{
    double twice = 0;
    for (const TriangleGroup& group : mesh.groups) {
        if (group.kind != TriangleKind::cap) continue;
        for (std::uint32_t t = group.first; t < group.first + group.count; ++t) {
            const auto corner = [&](std::size_t i) { return glm::dvec3(mesh.vertices[mesh.triangles[t][i]].position); };
            twice += std::abs(glm::dot(normal, glm::cross(corner(1) - corner(0), corner(2) - corner(0))));
        }
    }
    return twice / 2;
}

double wound_area(std::span<const SectionLoop> loops, const glm::dvec3& normal)
{
    const glm::dvec3 u = glm::normalize(
                         glm::cross(normal, std::abs(normal.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0))),
                     v = glm::cross(normal, u);
    struct Edge
    {
        double x0, y0, x1, y1;
        int direction;
        double at(double x) const { return y0 + (y1 - y0) * (x - x0) / (x1 - x0); }
    };
    std::vector<Edge> edges;
    std::vector<double> xs;
    for (const SectionLoop& loop : loops) {
        if (!loop.closed) continue;
        for (std::size_t i = 0; i < loop.points.size(); ++i) {
            const glm::dvec3 p(loop.points[i]), q(loop.points[(i + 1) % loop.points.size()]);
            const double px = glm::dot(u, p), qx = glm::dot(u, q), py = glm::dot(v, p), qy = glm::dot(v, q);
            xs.push_back(px);
            if (px < qx) edges.push_back({px, py, qx, qy, 1});
            if (qx < px) edges.push_back({qx, qy, px, py, -1});
        }
    }
    for (std::size_t i = 0; i < edges.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            const Edge &a = edges[i], &b = edges[j];
            const double left = std::max(a.x0, b.x0), right = std::min(a.x1, b.x1);
            if (!(left < right)) continue;
            const double before = a.at(left) - b.at(left), behind = a.at(right) - b.at(right);
            if (before * behind < 0) xs.push_back(left + (right - left) * before / (before - behind));
        }
    std::sort(xs.begin(), xs.end());
    double area = 0;
    for (std::size_t i = 0; i + 1 < xs.size(); ++i) {
        const double middle = (xs[i] + xs[i + 1]) / 2;
        std::vector<std::pair<double, int>> crossed;
        for (const Edge& e : edges)
            if (e.x0 <= xs[i] && xs[i + 1] <= e.x1) crossed.emplace_back(e.at(middle), e.direction);
        std::sort(crossed.begin(), crossed.end());
        int winding = 0;
        for (std::size_t k = 0; k + 1 < crossed.size(); ++k) {
            winding += crossed[k].second;
            area += std::abs(winding) * (crossed[k + 1].first - crossed[k].first) * (xs[i + 1] - xs[i]);
        }
    }
    return area;
}

double overhang(const IndexedMesh& mesh, const Plane& plane, bool positive_side)
{
    double worst = -INFINITY;
    for (const Triangle& t : mesh.triangles)
        for (std::size_t i = 0; i < 3; ++i) {
            const double d = plane.signed_distance(position(mesh, t, i));
            worst = std::max(worst, positive_side ? -d : d);
        }
    return worst;
}

std::size_t edge_components(const IndexedMesh& mesh)
{
    std::vector<std::size_t> parent(mesh.triangles.size());
    std::iota(parent.begin(), parent.end(), std::size_t(0));
    const auto find = [&](std::size_t i) {
        while (parent[i] != i) i = parent[i] = parent[parent[i]];
        return i;
    };
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> triangle_at;
    std::size_t count = parent.size();
    for (std::size_t t = 0; t < parent.size(); ++t)
        for (std::size_t i = 0; i < 3; ++i) {
            const auto [a, b] =
                std::minmax(mesh.points[mesh.triangles[t][i]], mesh.points[mesh.triangles[t][(i + 1) % 3]]);
            const auto [entry, is_new] = triangle_at.try_emplace({a, b}, t);
            if (is_new) continue;
            const std::size_t p = find(entry->second), q = find(t);
            if (p == q) continue;
            parent[p] = q;
            --count;
        }
    return count;
}

std::vector<SurfaceTriangle> canonical_surface(const IndexedMesh& mesh)
{
    std::vector<SurfaceTriangle> result;
    for (const TriangleGroup& group : mesh.groups) {
        if (group.kind != TriangleKind::surface) continue;
        for (std::uint32_t i = group.first; i < group.first + group.count; ++i) {
            std::array<std::vector<std::uint32_t>, 3> corners;
            for (std::size_t k = 0; k < 3; ++k) {
                const std::uint32_t v = mesh.triangles[i][k];
                corners[k].resize(8);
                std::memcpy(corners[k].data(), &mesh.vertices[v], sizeof(Vertex));
                for (const VertexStream& stream : mesh.streams)
                    for (std::uint32_t w = 0; w < stream.width; ++w) {
                        std::uint32_t bits;
                        std::memcpy(&bits, &stream.values[std::size_t(v) * stream.width + w], sizeof bits);
                        corners[k].push_back(bits);
                    }
            }
            std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
            SurfaceTriangle triangle{mesh.sources[i], mesh.materials[group.material].name, {}};
            for (const auto& corner : corners) triangle.bits.insert(triangle.bits.end(), corner.begin(), corner.end());
            result.push_back(std::move(triangle));
        }
    }
    std::sort(result.begin(), result.end());
    return result;
}

std::vector<SurfaceTriangle> canonical_surface(const std::vector<std::unique_ptr<Cuttable>>& fragments)
{
    std::vector<SurfaceTriangle> all;
    for (const auto& fragment : fragments) {
        std::vector<SurfaceTriangle> part = canonical_surface(fragment->to_indexed_mesh());
        std::move(part.begin(), part.end(), std::back_inserter(all));
    }
    std::sort(all.begin(), all.end());
    return all;
}

std::vector<std::vector<SurfaceTriangle>> canonical_pieces(const std::vector<std::unique_ptr<Cuttable>>& fragments)
{
    std::vector<std::vector<SurfaceTriangle>> pieces;
    for (const auto& fragment : fragments) pieces.push_back(canonical_surface(fragment->to_indexed_mesh()));
    std::sort(pieces.begin(), pieces.end());
    return pieces;
}

std::vector<std::uint32_t> bytes_of(const IndexedMesh& mesh)
{
    std::vector<std::uint32_t> bytes;
    const auto add = [&](const void* data, std::size_t size) {
        const std::size_t at = bytes.size();
        bytes.resize(at + size / sizeof(std::uint32_t));
        if (size > 0) std::memcpy(bytes.data() + at, data, size);
    };
    add(mesh.vertices.data(), mesh.vertices.size() * sizeof(Vertex));
    add(mesh.points.data(), mesh.points.size() * sizeof(std::uint32_t));
    add(mesh.triangles.data(), mesh.triangles.size() * sizeof(Triangle));
    add(mesh.sources.data(), mesh.sources.size() * sizeof(std::uint32_t));
    for (const VertexStream& stream : mesh.streams) add(stream.values.data(), stream.values.size() * sizeof(float));
    for (const TriangleGroup& g : mesh.groups)
        for (const std::uint32_t value : {g.first, g.count, g.material, g.solid, std::uint32_t(g.kind)})
            bytes.push_back(value);
    return bytes;
}

}  // namespace kerf::core::referee
