#include "common/repair/shells.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "common/mesh/coordinate_grain.h"
#include "common/mesh/index.h"
#include "common/mesh/tolerances.h"
#include "common/repair/adjacency.h"

namespace kerf::core {

namespace {

Shells label(const LinkedSurface& surface)
{
    Shells result;
    result.shells.resize(label_shells(surface.opposite, result.shell));
    return result;
}

/// Calls visit(shell, first, last) for each run of triangles of one shell.
template <class Visit>
void for_each_run(Shells& shells, Visit&& visit)
{
    for (std::size_t first = 0; first < shells.shell.size();) {
        std::size_t last = first + 1;
        while (last < shells.shell.size() && shells.shell[last] == shells.shell[first]) ++last;
        visit(shells.shells[shells.shell[first]], first, last);
        first = last;
    }
}

/// 6 times the volume of the tetrahedron (o, a, b, c).
double volume6(const glm::dvec3& o, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c)
{
    return glm::dot(a - o, glm::cross(b - o, c - o));
}

double area(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c)
{
    return 0.5 * glm::length(glm::cross(b - a, c - a));
}

/// Adds the volume behind fans over the boundary loops, or sets the volume to 0 if the fans are too large.
void close_holes(Shells& shells, const LinkedSurface& surface, const VertexFans& fans,
                 std::span<const glm::vec3> positions)
{
    std::vector<double> shell_area(shells.shells.size(), 0.0), hole_area(shells.shells.size(), 0.0);
    Buffer<std::uint32_t> boundary_from(fans.count, kNone);  // the boundary half-edge that leaves each fan
    for (std::uint32_t h = 0; h < surface.opposite.size(); ++h)
        if (surface.opposite[h] == kNone) boundary_from[fans.fan[h]] = h;
    for (std::uint32_t t = 0; t < surface.corners.size(); ++t) {
        const auto& [a, b, c] = surface.corners[t];
        if (const std::uint32_t s = shells.shell[t]; !shells.shells[s].closed)
            shell_area[s] += area(positions[a], positions[b], positions[c]);
    }

    std::vector<std::uint32_t> loop;
    for (std::uint32_t f = 0; f < fans.count; ++f) {
        loop.clear();
        glm::dvec3 centre{0.0};
        for (std::uint32_t fan = f; boundary_from[fan] != kNone;) {
            const std::uint32_t h = std::exchange(boundary_from[fan], kNone);
            loop.push_back(h);
            centre += glm::dvec3(positions[surface.start(h)]);
            fan = fans.fan[next_halfedge(h)];
        }
        if (loop.empty()) continue;
        centre /= static_cast<double>(loop.size());
        const std::uint32_t s = shells.shell[loop.front() / 3];
        ConnectedShell& shell = shells.shells[s];
        for (const std::uint32_t h : loop) {
            const glm::dvec3 a = positions[surface.start(h)], b = positions[surface.end(h)];
            shell.volume6 += volume6(shell.apex, b, a, centre);
            hole_area[s] += area(a, b, centre);
        }
    }
    for (std::size_t s = 0; s < shells.shells.size(); ++s)
        if (!shells.shells[s].closed && hole_area[s] > kLargestHole * shell_area[s]) shells.shells[s].volume6 = 0.0;
}

}  // namespace

Shells find_shells(const LinkedSurface& surface, const VertexFans& fans, std::span<const glm::vec3> positions)
{
    Shells result = label(surface);
    ShortestEdge shortest;
    const auto has_neighbours = [&](std::size_t t) {
        const std::uint32_t* const across = &surface.opposite[3 * t];
        return (across[0] != kNone) & (across[1] != kNone) & (across[2] != kNone);
    };
    // One pass, because fetching the corners costs more than all that is done with them.
    for_each_run(result, [&](ConnectedShell& shell, std::size_t first, std::size_t last) {
        if (shell.box.empty()) shell.apex = positions[surface.corners[first][0]];
        const glm::dvec3 apex = shell.apex;
        Box a, b, c;  // one for each corner, so that the next triangle need not wait for three additions
        double sum = 0.0;
        bool closed = true;
        for (std::size_t t = first; t < last; ++t) {
            closed &= has_neighbours(t);
            const glm::vec3 &i = positions[surface.corners[t][0]], &j = positions[surface.corners[t][1]],
                            &k = positions[surface.corners[t][2]];
            a.add(i);
            b.add(j);
            c.add(k);
            const glm::dvec3 p(i), q(j), r(k);
            sum += volume6(apex, p, q, r);
            shortest.add(p, q, r);
        }
        for (const Box& box : {a, b, c}) shell.box.add(box);
        shell.volume6 += sum;
        shell.closed = shell.closed && closed;
        shell.triangle_count += static_cast<std::uint32_t>(last - first);
    });
    result.shortest_edge = shortest.length();
    if (!result.closed()) close_holes(result, surface, fans, positions);
    return result;
}

}  // namespace kerf::core
