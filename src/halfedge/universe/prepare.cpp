#include <algorithm>
#include <span>
#include <vector>

#include "common/mesh/mass_moments.h"
#include "common/mesh/mass_properties.h"
#include "common/mesh/plane.h"
#include "common/mesh/plane_noise.h"
#include "halfedge/universe/cut_reserve.h"
#include "halfedge/universe/spatial_order.h"
#include "halfedge/universe/universe.h"

namespace kerf::core::halfedge {

namespace {

/// Fills the groups, in the order in which they are drawn, and returns the group of each triangle.
std::vector<Index> sort_groups(const IndexedMesh& mesh, std::vector<DrawGroup>& groups)
{
    for (const TriangleGroup& g : mesh.groups) groups.push_back({g.material, g.solid, g.kind});
    std::sort(groups.begin(), groups.end(), draws_before);
    const auto is_alike = [](const DrawGroup& a, const DrawGroup& b) {
        return !draws_before(a, b) && !draws_before(b, a);
    };
    groups.erase(std::unique(groups.begin(), groups.end(), is_alike), groups.end());
    std::vector<Index> group_of(mesh.triangles.size());
    for (const TriangleGroup& g : mesh.groups) {
        const DrawGroup wanted{g.material, g.solid, g.kind};
        const auto found = std::lower_bound(groups.begin(), groups.end(), wanted, draws_before);
        std::fill_n(group_of.begin() + g.first, g.count, static_cast<Index>(found - groups.begin()));
    }
    return group_of;
}

/// Builds connectivity without a search: faces, edges in the order of their first half-edge, the linked boundary.
void build_connectivity(Universe& u, const std::vector<Triangle>& points, std::span<const Index> opposites)
{
    SurfaceMesh& mesh = u.mesh;
    std::vector<HalfedgeId> of_corner(opposites.size());
    int edges = 0;
    for (Index c = 0; c < opposites.size(); ++c) {
        if (opposites[c] != kNone && opposites[c] < c) {
            of_corner[c] = opposite(of_corner[opposites[c]]);
        } else {
            of_corner[c] = first_halfedge(EdgeId(edges++));
        }
    }
    const auto point_at = [&](std::size_t triangle, std::size_t corner) {
        return PointId(int(points[triangle][corner % 3]));
    };
    for (std::size_t f = 0; f < points.size(); ++f) {
        const HalfedgeId* h = &of_corner[3 * f];
        mesh.set_triangle(FaceId(int(f)), h[0], h[1], h[2]);
        for (std::size_t c = 0; c < 3; ++c) {
            mesh.set_to(h[c], point_at(f, c + 1));
            mesh.set_halfedge_of(point_at(f, c), h[c]);
        }
    }
    std::vector<HalfedgeId> boundary;
    for (std::size_t c = 0; c < opposites.size(); ++c) {
        if (opposites[c] != kNone) continue;
        const HalfedgeId outer = opposite(of_corner[c]);
        mesh.set_to(outer, point_at(c / 3, c));
        mesh.set_halfedge_of(mesh.to(of_corner[c]), outer);
        boundary.push_back(outer);
    }
    for (const HalfedgeId h : boundary) mesh.link(h, mesh.halfedge_of(mesh.to(h)));
}

/// Vertices and points, numbered in the order of their first use.
struct Numbering
{
    std::vector<Index> old_vertex;        ///< of each vertex
    std::vector<Triangle> corner_points;  ///< of each triangle
    Index point_count = 0;
};

/// Writes the triangles to `slots`, which is empty.
Numbering number_by_first_use(const IndexedMesh& mesh, std::span<const Index> order,
                              AppendBuffer<Triangle, SlotId>& slots)
{
    Numbering numbering;
    std::vector<Index> new_vertex(mesh.vertices.size(), kNone), new_point(mesh.point_count, kNone);
    numbering.old_vertex.reserve(mesh.vertices.size());
    numbering.corner_points.resize(order.size());
    slots.reserve(order.size());
    slots.set_size(order.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        const Triangle& t = mesh.triangles[order[i]];
        for (std::size_t c = 0; c < 3; ++c) {
            if (new_vertex[t[c]] == kNone) {
                new_vertex[t[c]] = static_cast<Index>(numbering.old_vertex.size());
                numbering.old_vertex.push_back(t[c]);
            }
            slots[SlotId(Index(i))][c] = new_vertex[t[c]];
            Index& point = new_point[mesh.points[t[c]]];
            if (point == kNone) point = numbering.point_count++;
            numbering.corner_points[i][c] = point;
        }
    }
    return numbering;
}

/// Copies vertices with their streams; there is room for them.
void copy_vertices(const IndexedMesh& mesh, std::span<const Index> old_vertex, Universe& u)
{
    u.vertices.set_size(old_vertex.size());
    for (std::size_t v = 0; v < old_vertex.size(); ++v) u.vertices[v] = mesh.vertices[old_vertex[v]];
    for (std::size_t s = 0; s < mesh.streams.size(); ++s) {
        const VertexStream& stream = mesh.streams[s];
        AppendBuffer<float>& values = u.streams[s].values;
        values.set_size(old_vertex.size() * stream.width);
        for (std::size_t v = 0; v < old_vertex.size(); ++v) {
            const std::size_t from = std::size_t{old_vertex[v]} * stream.width;
            std::copy_n(&stream.values[from], stream.width, &values[v * stream.width]);
        }
    }
}

/// Copies the data of faces and the positions of points; there is room for them.
void copy_faces(const IndexedMesh& mesh, std::span<const Index> order, std::span<const Triangle> corner_points,
                Universe& u)
{
    u.face_of_slot.set_size(order.size());
    u.source_of_face.set_size(order.size());
    u.stamp_of_face.set_size(order.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        const SlotId slot(static_cast<Index>(i));
        const FaceId face(static_cast<int>(i));
        u.face_of_slot[slot] = face;
        u.source_of_face[face] = mesh.sources[order[i]];
        for (std::size_t c = 0; c < 3; ++c)
            u.mesh.set_position(PointId(int(corner_points[i][c])), u.vertices[u.slots[slot][c]].position);
    }
}

/// Triangles of one group and shell that follow one another.
struct Run
{
    Index first, count, group, shell;
};

std::vector<Run> find_runs(std::span<const Index> order, std::span<const Index> group_of,
                           std::span<const Index> shell_of)
{
    std::vector<Run> runs;
    for (Index i = 0; i < order.size(); ++i) {
        const Index group = group_of[order[i]], shell = shell_of[order[i]];
        if (runs.empty() || runs.back().group != group || runs.back().shell != shell)
            runs.push_back({i, 0, group, shell});
        ++runs.back().count;
    }
    return runs;
}

/// One subtree for each run; the runs of a shell meet at its root.
std::vector<ShellRoot> plant_trees(std::span<const Run> runs, Index shell_count, Universe& u)
{
    std::vector<ShellRoot> roots(shell_count);
    for (const Run& run : runs) {
        ShellRoot& shell = roots[run.shell];
        const SlotId first(run.first);
        shell.root = u.tree.join(shell.root, u.tree.make_run(u.geometry(), first, run.count, GroupId(run.group)));
        shell.solid = u.groups[run.group].solid;
    }
    return roots;
}

}  // namespace

std::vector<ShellRoot> prepare_universe(const ProvenMesh& proven, Universe& u, const Progress& progress)
{
    const IndexedMesh& mesh = proven;
    const Adjacency& adjacency = proven.adjacency();
    const std::size_t n = mesh.triangles.size();
    const Box& bounds = proven.bounds();
    u.reference = mass_reference(bounds);
    u.noise = plane_noise(bounds.largest_coordinate());
    u.set_materials(mesh.materials);
    for (const VertexStream& stream : mesh.streams) u.streams.push_back({stream.name, stream.width, {}});

    // The shares are those that the steps have of the time, about.
    progress.at(0.0);
    const std::vector<Index> group_of = sort_groups(mesh, u.groups);
    progress.at(0.01);
    const Buffer<Index> order = spatial_order(proven, group_of, u.groups.size());
    progress.at(0.13);
    const std::vector<Run> runs = find_runs(order, group_of, adjacency.shell);
    const Numbering numbering = number_by_first_use(mesh, order, u.slots);
    progress.at(0.26);
    const auto boundary =
        static_cast<std::size_t>(std::count(adjacency.opposite.begin(), adjacency.opposite.end(), kNone));
    u.has_boundary = boundary > 0;

    UniverseSize size{numbering.point_count, (3 * n + boundary) / 2, n, numbering.old_vertex.size(), 0};
    // All leaves but the last of a run are full.
    for (const Run& run : runs) size.nodes += 2 * (std::size_t{run.count - 1} / kLeafTriangles + 1);
    reserve(u, size, reserved_crossings(n), {progress, 0.26, 0.78});
    u.mesh.resize(size.points, size.edges, size.triangles);
    progress.at(0.79);
    const auto opposites = opposite_in_order(adjacency.opposite, order);
    progress.at(0.83);
    build_connectivity(u, numbering.corner_points, opposites);
    progress.at(0.9);
    copy_vertices(mesh, numbering.old_vertex, u);
    progress.at(0.91);
    copy_faces(mesh, order, numbering.corner_points, u);
    progress.at(0.94);
    return plant_trees(runs, adjacency.shell_count, u);
}

}  // namespace kerf::core::halfedge
