// Shapes with flat faces and sharp edges: the box, shapes built of blocks, and the spiral wall.

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "common/shapes/corner_grid.h"
#include "common/shapes/shapes.h"

namespace kerf::core::shapes {
namespace {

// The planes of a lattice of blocks along the three axes, ascending.
using Lattice = std::array<std::vector<double>, 3>;

// `cells` equal cells from -size/2 to size/2.
std::vector<double> even_planes(double size, std::uint32_t cells)
{
    std::vector<double> planes;
    for (std::uint32_t i = 0; i <= cells; ++i) planes.push_back(size * (double(i) / double(cells) - 0.5));
    return planes;
}

// The surface of the blocks for which `filled(cell)` holds: two triangles for each face between a filled and an empty
// cell, so faces of neighbours meet edge to edge. Corners of faces with the same direction share their vertices. The
// surface is manifold if no two blocks touch in a mere edge or corner.
template <class Filled>
TriangleSoup surface_of_blocks(const Lattice& planes, Filled filled)
{
    glm::uvec3 cells;
    for (int axis = 0; axis < 3; ++axis) cells[axis] = std::uint32_t(planes[std::size_t(axis)].size()) - 1;
    std::vector<std::array<std::uint32_t, 6>> index(std::size_t(cells.x + 1) * (cells.y + 1) * (cells.z + 1));
    constexpr std::uint32_t kUnused = ~0u;
    for (auto& six : index) six.fill(kUnused);
    TriangleSoup soup;

    const auto plane = [&](int axis, std::uint32_t i) { return planes[std::size_t(axis)][i]; };
    const auto vertex = [&](const glm::uvec3& point, int axis, bool plus) {
        const std::size_t place = (std::size_t(point.z) * (cells.y + 1) + point.y) * (cells.x + 1) + point.x;
        std::uint32_t& slot = index[place][2 * std::size_t(axis) + (plus ? 0u : 1u)];
        if (slot == kUnused) {
            slot = std::uint32_t(soup.vertices.size());
            const int u = (axis + 1) % 3, v = (axis + 2) % 3;
            glm::dvec3 normal(0.0);
            normal[axis] = plus ? 1.0 : -1.0;
            soup.vertices.push_back(make_vertex({plane(0, point.x), plane(1, point.y), plane(2, point.z)}, normal,
                                                {plane(u, point[u]), plane(v, point[v])}));
        }
        return slot;
    };
    const auto is_filled = [&](const glm::uvec3& cell) {
        // A step below 0 wraps around and is out of range as well.
        return cell.x < cells.x && cell.y < cells.y && cell.z < cells.z && filled(cell);
    };
    glm::uvec3 cell;
    for (cell.z = 0; cell.z < cells.z; ++cell.z) {
        for (cell.y = 0; cell.y < cells.y; ++cell.y) {
            for (cell.x = 0; cell.x < cells.x; ++cell.x) {
                if (!filled(cell)) continue;
                for (int side = 0; side < 6; ++side) {
                    const int axis = side / 2;
                    const bool plus = side % 2 == 0;
                    glm::uvec3 neighbour = cell;
                    neighbour[axis] += plus ? 1u : ~0u;
                    if (is_filled(neighbour)) continue;
                    const int u = plus ? (axis + 1) % 3 : (axis + 2) % 3, v = plus ? (axis + 2) % 3 : (axis + 1) % 3;
                    glm::uvec3 a = cell;
                    a[axis] += plus ? 1u : 0u;
                    glm::uvec3 b = a, c = a, d = a;
                    ++b[u], ++c[u], ++c[v], ++d[v];
                    const std::uint32_t ia = vertex(a, axis, plus), ib = vertex(b, axis, plus);
                    const std::uint32_t ic = vertex(c, axis, plus), id = vertex(d, axis, plus);
                    soup.triangles.push_back({ia, ib, ic});
                    soup.triangles.push_back({ia, ic, id});
                }
            }
        }
    }
    return soup;
}

}  // namespace

TriangleSoup box(const glm::vec3& size, const glm::uvec3& cells)
{
    TriangleSoup soup;
    const glm::dvec3 half = glm::dvec3(size) * 0.5;
    add_box_grid(soup, cells,
                 [&](const BoxPoint& point) { return make_vertex(point.cube * half, point.normal, point.face_uv); });
    return soup;
}

TriangleSoup comb(std::uint32_t teeth)
{
    require_room(24.0 * double(teeth));
    const std::uint32_t columns = 2 * std::max(teeth, 1u) - 1;
    const Lattice lattice{even_planes(0.2 * columns, columns), std::vector{-0.5, -0.2, 0.5}, even_planes(0.2, 1)};
    return surface_of_blocks(lattice, [](const glm::uvec3& cell) { return cell.y == 0 || cell.x % 2 == 0; });
}

TriangleSoup l_step(std::uint32_t cells)
{
    cells = std::max(cells, 1u);
    require_room(28.0 * double(cells) * double(cells));
    const Lattice lattice{even_planes(2.0, 2 * cells), even_planes(1.0, cells), even_planes(2.0, 2 * cells)};
    return surface_of_blocks(lattice, [=](const glm::uvec3& cell) { return cell.x < cells || cell.z < cells; });
}

TriangleSoup two_legs(std::uint32_t cells)
{
    cells = std::max(cells, 1u);
    require_room(44.0 * double(cells) * double(cells));
    const Lattice lattice{even_planes(3.0, 3 * cells), even_planes(1.0, cells), even_planes(2.0, 2 * cells)};
    return surface_of_blocks(lattice, [=](const glm::uvec3& cell) { return cell.z >= cells || cell.x / cells != 1; });
}

TriangleSoup tray(std::uint32_t cells)
{
    cells = std::max(cells, 1u);
    require_room(92.0 * double(cells) * double(cells));
    const Lattice lattice{even_planes(3.0, 3 * cells), even_planes(3.0, 3 * cells), even_planes(2.0, 2 * cells)};
    return surface_of_blocks(
        lattice, [=](const glm::uvec3& cell) { return cell.z < cells || cell.x / cells != 1 || cell.y / cells != 1; });
}

TriangleSoup menger_sponge(std::uint32_t level)
{
    constexpr std::uint32_t kFinestLevel = 4;
    level = std::min(level, kFinestLevel);
    std::uint32_t side = 1;
    for (std::uint32_t i = 0; i < level; ++i) side *= 3;
    const std::vector<double> planes = even_planes(1.0, side);
    return surface_of_blocks({planes, planes, planes}, [=](glm::uvec3 cell) {
        // A cell is cut out if at any scale it is in the middle along two axes or three.
        for (std::uint32_t i = 0; i < level; ++i, cell /= 3u) {
            if ((cell.x % 3 == 1) + (cell.y % 3 == 1) + (cell.z % 3 == 1) >= 2) return false;
        }
        return true;
    });
}

TriangleSoup spiral_wall(float turns, std::uint32_t segments_per_turn)
{
    constexpr double kFirstRadius = 0.2, kPitch = 0.2, kHalfThickness = 0.04, kHalfHeight = 0.25;
    segments_per_turn = std::max(segments_per_turn, 3u);
    const double whole_segments = std::max(1.0, std::round(double(turns) * double(segments_per_turn)));
    require_room(8.0 * whole_segments);
    const auto segments = std::uint32_t(whole_segments);
    struct Station
    {
        glm::dvec3 inner, outer, outwards;
        double u;
    };
    std::vector<Station> stations;
    for (std::uint32_t i = 0; i <= segments; ++i) {
        const double angle = 2.0 * std::numbers::pi * double(i) / double(segments_per_turn);
        const double r = kFirstRadius + kPitch * angle / (2.0 * std::numbers::pi);
        const glm::dvec3 radial{std::cos(angle), std::sin(angle), 0.0}, along{-radial.y, radial.x, 0.0};
        // Perpendicular to the centre line's direction of travel, on its right.
        const glm::dvec3 outwards = glm::normalize(r * radial - kPitch / (2.0 * std::numbers::pi) * along);
        stations.push_back({r * radial - kHalfThickness * outwards, r * radial + kHalfThickness * outwards, outwards,
                            double(i) / double(segments)});
    }
    const glm::dvec3 up{0.0, 0.0, kHalfHeight};
    TriangleSoup soup;
    // A band of quads from station to station; (left, right) as seen from outside with the next station above.
    const auto add_band = [&](auto left, auto right, auto normal) {
        const auto first = std::uint32_t(soup.vertices.size());
        for (const Station& s : stations) {
            soup.vertices.push_back(make_vertex(left(s), normal(s), {0.0, s.u}));
            soup.vertices.push_back(make_vertex(right(s), normal(s), {1.0, s.u}));
        }
        for (std::uint32_t i = first; i < first + 2 * segments; i += 2) {
            soup.triangles.push_back({i, i + 1, i + 3});
            soup.triangles.push_back({i, i + 3, i + 2});
        }
    };
    const auto inner_low = [&](const Station& s) { return s.inner - up; };
    const auto inner_high = [&](const Station& s) { return s.inner + up; };
    const auto outer_low = [&](const Station& s) { return s.outer - up; };
    const auto outer_high = [&](const Station& s) { return s.outer + up; };
    add_band(outer_high, outer_low, [](const Station& s) { return s.outwards; });
    add_band(inner_low, inner_high, [](const Station& s) { return -s.outwards; });
    add_band(inner_high, outer_high, [](const Station&) { return glm::dvec3(0, 0, 1); });
    add_band(outer_low, inner_low, [](const Station&) { return glm::dvec3(0, 0, -1); });
    const auto add_end = [&](const Station& s, bool first) {
        const auto base = std::uint32_t(soup.vertices.size());
        const glm::dvec3 along = glm::dvec3(-s.outwards.y, s.outwards.x, 0.0) * (first ? -1.0 : 1.0);
        soup.vertices.push_back(make_vertex(inner_low(s), along, {0, 0}));
        soup.vertices.push_back(make_vertex(outer_low(s), along, {1, 0}));
        soup.vertices.push_back(make_vertex(outer_high(s), along, {1, 1}));
        soup.vertices.push_back(make_vertex(inner_high(s), along, {0, 1}));
        for (const Triangle& t : {Triangle{0, 1, 2}, Triangle{0, 2, 3}}) {
            soup.triangles.push_back(first ? Triangle{base + t[0], base + t[1], base + t[2]}
                                           : Triangle{base + t[0], base + t[2], base + t[1]});
        }
    };
    add_end(stations.front(), true);
    add_end(stations.back(), false);
    return soup;
}

}  // namespace kerf::core::shapes
