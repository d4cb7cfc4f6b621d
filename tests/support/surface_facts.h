#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <map>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

#include "common/mesh/triangle_soup.h"

// A referee over triangles as they come: welds by position and counts edges and fans. Shares no code with the library.

namespace kerf::core::test {

struct SurfaceFacts
{
    std::size_t points = 0, edges = 0, triangles = 0, shells = 0;
    std::size_t unpaired_edges =
        0;  ///< directed edges without exactly one reverse edge: 0 means closed, oriented, manifold
    std::size_t degenerate = 0;      ///< triangles with two corners at one point
    std::size_t flat = 0;            ///< triangles whose area is 0
    std::size_t pinched_points = 0;  ///< points whose triangles form more than one fan
    std::size_t unused_vertices = 0;
    std::size_t bad_normals = 0;       ///< not unit length within 1e-5, or not finite
    std::size_t backward_normals = 0;  ///< vertex normals that point behind a triangle of theirs
    std::size_t bad_numbers = 0;       ///< positions or uv that are not finite; -0 in a position
    double volume = 0.0, area = 0.0;

    long euler() const { return long(points) - long(edges) + long(triangles); }
    bool closed_and_manifold() const { return unpaired_edges == 0 && degenerate == 0 && pinched_points == 0; }
};

inline SurfaceFacts surface_facts(const TriangleSoup& soup)
{
    SurfaceFacts facts;
    facts.triangles = soup.triangles.size();
    // Points by the bits of the position.
    std::map<std::array<std::uint32_t, 3>, std::uint32_t> point_of;
    std::vector<std::uint32_t> point;
    for (const Vertex& v : soup.vertices) {
        std::array<std::uint32_t, 3> bits;
        std::memcpy(bits.data(), &v.position, sizeof bits);
        point.push_back(point_of.try_emplace(bits, std::uint32_t(point_of.size())).first->second);
        for (const std::uint32_t b : bits) facts.bad_numbers += b == 0x80000000u || (b & 0x7F800000u) == 0x7F800000u;
        facts.bad_numbers += !std::isfinite(v.uv.x) || !std::isfinite(v.uv.y);
        const double length =
            std::sqrt(double(v.normal.x) * double(v.normal.x) + double(v.normal.y) * double(v.normal.y) +
                      double(v.normal.z) * double(v.normal.z));
        facts.bad_normals += !(std::abs(length - 1.0) < 1e-5);
    }
    facts.points = point_of.size();

    std::vector<bool> used(soup.vertices.size());
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> directed;
    // Around each point, for each triangle the edge opposite to it: fans are chains of these.
    std::vector<std::vector<std::pair<std::uint32_t, std::uint32_t>>> around(facts.points);
    std::vector<std::uint32_t> shell(facts.points);
    std::iota(shell.begin(), shell.end(), 0u);
    const auto find = [&](std::uint32_t i) {
        while (shell[i] != i) i = shell[i] = shell[shell[i]];
        return i;
    };
    for (const Triangle& t : soup.triangles) {
        std::array<std::uint32_t, 3> p;
        std::array<std::array<double, 3>, 3> x;
        for (std::size_t k = 0; k < 3; ++k) {
            used.at(t[k]) = true;
            p[k] = point.at(t[k]);
            const glm::vec3& q = soup.vertices[t[k]].position;
            x[k] = {double(q.x), double(q.y), double(q.z)};
        }
        facts.degenerate += p[0] == p[1] || p[1] == p[2] || p[2] == p[0];
        for (std::size_t k = 0; k < 3; ++k) {
            ++directed[{p[k], p[(k + 1) % 3]}];
            around[p[k]].emplace_back(p[(k + 1) % 3], p[(k + 2) % 3]);
            shell[find(p[k])] = find(p[(k + 1) % 3]);
        }
        const auto u = [&](std::size_t k) { return x[1][k] - x[0][k]; };
        const auto v = [&](std::size_t k) { return x[2][k] - x[0][k]; };
        const std::array<double, 3> n{u(1) * v(2) - u(2) * v(1), u(2) * v(0) - u(0) * v(2), u(0) * v(1) - u(1) * v(0)};
        const double twice = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
        facts.area += twice / 2.0;
        facts.flat += twice == 0.0;
        facts.volume += (x[0][0] * n[0] + x[0][1] * n[1] + x[0][2] * n[2]) / 6.0;
        for (std::size_t k = 0; k < 3; ++k) {
            const glm::vec3& m = soup.vertices[t[k]].normal;
            facts.backward_normals += n[0] * double(m.x) + n[1] * double(m.y) + n[2] * double(m.z) <= 0.0;
        }
    }
    for (const auto& [edge, count] : directed) {
        const auto reverse = directed.find({edge.second, edge.first});
        if (count != 1 || reverse == directed.end() || reverse->second != 1) ++facts.unpaired_edges;
        facts.edges += edge.first < edge.second || reverse == directed.end();
    }
    for (const auto& spokes : around) {
        if (spokes.empty()) continue;
        const std::map<std::uint32_t, std::uint32_t> next(spokes.begin(), spokes.end());
        std::size_t steps = 0;
        for (std::uint32_t at = spokes.front().first; steps < spokes.size();) {
            const auto step = next.find(at);
            if (step == next.end()) break;
            at = step->second;
            ++steps;
            if (at == spokes.front().first) break;
        }
        facts.pinched_points += steps != spokes.size();
    }
    std::set<std::uint32_t> roots;
    for (std::uint32_t i = 0; i < facts.points; ++i) roots.insert(find(i));
    facts.shells = roots.size();
    facts.unused_vertices = std::size_t(std::count(used.begin(), used.end(), false));
    return facts;
}

}  // namespace kerf::core::test
