#include <algorithm>
#include <span>
#include <vector>

#include "common/mesh/mass_moments.h"
#include "common/mesh/mass_properties.h"
#include "common/mesh/plane.h"
#include "common/mesh/plane_noise.h"
#include "halfedge/universe/cut_reserve.h"
#include "halfedge/universe/huge_pages.h"
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

/// Writes the triangles of a mesh into a universe whose arrays have their sizes, one after another in their new order:
/// vertices and points are numbered in the order of their first use, edges in that of their first half-edge. A triangle
/// finds the half-edges of its neighbours in a table, so connectivity needs no search, and one pass reads the mesh.
class Writer
{
public:
    Writer(const ProvenMesh& proven, Universe& u)
        : mesh_(proven),
          opposite_(proven.adjacency().opposite),
          u_(u),
          number_of_(filled(mesh_.vertices.size(), Numbers{kNone, kNone})),
          point_number_(filled(mesh_.point_count, kNone)),
          halfedge_of_(filled(3 * mesh_.triangles.size(), HalfedgeId()))
    {
        if (!mesh_.streams.empty()) old_vertex_.reserve(mesh_.vertices.size());
    }

    void write(Index old_triangle)
    {
        const Triangle& t = mesh_.triangles[old_triangle];
        const FaceId face(static_cast<int>(triangles_));
        const SlotId slot(triangles_++);
        std::array<PointId, 3> points;
        std::array<HalfedgeId, 3> h;
        for (std::size_t c = 0; c < 3; ++c) {
            const Numbers& numbers = numbers_of(t[c]);
            u_.slots[slot][c] = numbers.vertex;
            points[c] = PointId(static_cast<int>(numbers.point));
            h[c] = halfedge(std::size_t{3} * old_triangle + c);
        }
        u_.face_of_slot[slot] = face;
        u_.source_of_face[face] = mesh_.sources[old_triangle];
        u_.mesh.set_triangle(face, h[0], h[1], h[2]);
        for (std::size_t c = 0; c < 3; ++c) {
            u_.mesh.set_to(h[c], points[(c + 1) % 3]);
            u_.mesh.set_halfedge_of(points[c], h[c]);
            if (opposite_[std::size_t{3} * old_triangle + c] != kNone) continue;
            u_.mesh.set_to(opposite(h[c]), points[c]);
            boundary_.push_back(opposite(h[c]));
        }
    }

    /// Asks for the memory that write() will read soon. Its branches can't be foretold, so the processor does not read
    /// ahead by itself.
    void prefetch_triangle(Index old_triangle) const
    {
        __builtin_prefetch(&mesh_.triangles[old_triangle]);
        __builtin_prefetch(&mesh_.sources[old_triangle]);
        __builtin_prefetch(&opposite_[std::size_t{3} * old_triangle]);
        __builtin_prefetch(&halfedge_of_[std::size_t{3} * old_triangle]);
    }
    /// The same, for what is known once the triangle itself is there.
    void prefetch_corners(Index old_triangle) const
    {
        for (std::size_t c = 0; c < 3; ++c) {
            const Index vertex = mesh_.triangles[old_triangle][c];
            __builtin_prefetch(&number_of_[vertex]);
            __builtin_prefetch(&mesh_.vertices[vertex]);
            const Index across = opposite_[std::size_t{3} * old_triangle + c];
            if (across != kNone) __builtin_prefetch(&halfedge_of_[across]);
        }
    }

    /// Once all triangles are written: links the half-edges of the boundary, and copies the streams.
    void finish()
    {
        SurfaceMesh& mesh = u_.mesh;
        for (const HalfedgeId h : boundary_) mesh.set_halfedge_of(mesh.from(h), h);
        for (const HalfedgeId h : boundary_) mesh.link(h, mesh.halfedge_of(mesh.to(h)));
        for (std::size_t s = 0; s < mesh_.streams.size(); ++s) {
            const VertexStream& stream = mesh_.streams[s];
            for (std::size_t v = 0; v < old_vertex_.size(); ++v)
                std::copy_n(&stream.values[std::size_t{old_vertex_[v]} * stream.width], stream.width,
                            &u_.streams[s].values[v * stream.width]);
        }
    }

private:
    /// New numbers of a vertex of the mesh and of its point.
    struct Numbers
    {
        Index vertex, point;
    };

    template <class T>
    static Buffer<T> filled(std::size_t size, T value)
    {
        Buffer<T> table(size);
        prefer_huge_pages(table.data(), size * sizeof(T));
        std::fill(table.begin(), table.end(), value);
        return table;
    }

    const Numbers& numbers_of(Index old_vertex)
    {
        Numbers& numbers = number_of_[old_vertex];
        if (numbers.vertex != kNone) return numbers;
        const Vertex& vertex = mesh_.vertices[old_vertex];
        Index& point = point_number_[mesh_.points[old_vertex]];
        if (point == kNone) {
            point = points_++;
            u_.mesh.set_position(PointId(static_cast<int>(point)), vertex.position);
        }
        numbers = {vertices_++, point};
        u_.vertices[numbers.vertex] = vertex;
        if (!mesh_.streams.empty()) old_vertex_.push_back(old_vertex);
        return numbers;
    }

    /// Half of the edges are met for the first time here: a branch on it could not be foretold.
    HalfedgeId halfedge(std::size_t corner)
    {
        const Index across = opposite_[corner];
        const HalfedgeId other = halfedge_of_[across == kNone ? corner : across];
        const HalfedgeId fresh = first_halfedge(EdgeId(static_cast<int>(edges_)));
        edges_ += other.is_valid() ? 0 : 1;
        return halfedge_of_[corner] = other.is_valid() ? opposite(other) : fresh;
    }

    const IndexedMesh& mesh_;
    std::span<const Index> opposite_;
    Universe& u_;
    Buffer<Numbers> number_of_;         ///< by old vertex
    Buffer<Index> point_number_;        ///< by old point
    Buffer<HalfedgeId> halfedge_of_;    ///< by corner of the mesh; invalid until its triangle is written
    std::vector<HalfedgeId> boundary_;  ///< half-edges without a face
    std::vector<Index> old_vertex_;     ///< by new vertex, if there are streams
    Index triangles_ = 0, vertices_ = 0, points_ = 0, edges_ = 0;
};

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

/// Gives the arrays of vertices, slots and faces their sizes; there is room for them.
void set_sizes(Universe& u, const UniverseSize& size)
{
    u.vertices.set_size(size.vertices);
    for (Stream& stream : u.streams) stream.values.set_size(size.vertices * stream.width);
    u.slots.set_size(size.triangles);
    u.face_of_slot.set_size(size.triangles);
    u.source_of_face.set_size(size.triangles);
    u.stamp_of_face.set_size(size.triangles);
    std::fill(u.stamp_of_face.begin(), u.stamp_of_face.end(), Index(0));
}

/// How often the caller hears of progress while triangles are written.
constexpr std::size_t kParts = 8;
/// How many triangles ahead memory is asked for.
constexpr std::size_t kAhead = 12;

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
    progress.at(0.15);
    const std::vector<Run> runs = find_runs(order, group_of, adjacency.shell);
    const auto boundary =
        static_cast<std::size_t>(std::count(adjacency.opposite.begin(), adjacency.opposite.end(), kNone));
    u.has_boundary = boundary > 0;

    UniverseSize size{mesh.point_count, (3 * n + boundary) / 2, n, mesh.vertices.size(), 0};
    for (const Run& run : runs) size.nodes += TriangleTree::nodes_of_full_leaves(run.count) + 1;
    reserve(u, size, crossings_of_one_cut(n), {progress, 0.15, 0.4});
    set_sizes(u, size);
    Writer writer(proven, u);
    for (std::size_t part = 0; part < kParts; ++part) {
        for (std::size_t i = n * part / kParts; i < n * (part + 1) / kParts; ++i) {
            writer.prefetch_triangle(order[std::min(i + 2 * kAhead, n - 1)]);
            writer.prefetch_corners(order[std::min(i + kAhead, n - 1)]);
            writer.write(order[i]);
        }
        progress.at(0.4 + 0.5 * double(part + 1) / kParts);
    }
    writer.finish();
    return plant_trees(runs, adjacency.shell_count, u);
}

}  // namespace kerf::core::halfedge
