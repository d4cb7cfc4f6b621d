#include <algorithm>
#include <optional>
#include <span>
#include <vector>

#include "common/mesh/mass_moments.h"
#include "common/mesh/mass_properties.h"
#include "common/mesh/plane.h"
#include "common/mesh/plane_noise.h"
#include "halfedge/universe/cut_reserve.h"
#include "halfedge/universe/mesh_writer.h"
#include "halfedge/universe/numbered_chunks.h"
#include "halfedge/universe/numbering.h"
#include "halfedge/universe/side_by_side.h"
#include "halfedge/universe/spatial_order.h"
#include "halfedge/universe/universe.h"

namespace kerf::core::halfedge {

namespace {

/// Fills the groups, in the order in which they are drawn, and returns the group of each triangle; nothing if there is
/// one.
std::vector<Index> sort_groups(const IndexedMesh& mesh, std::vector<DrawGroup>& groups)
{
    for (const TriangleGroup& g : mesh.groups) groups.push_back({g.material, g.solid, g.kind});
    std::sort(groups.begin(), groups.end(), draws_before);
    const auto is_alike = [](const DrawGroup& a, const DrawGroup& b) {
        return !draws_before(a, b) && !draws_before(b, a);
    };
    groups.erase(std::unique(groups.begin(), groups.end(), is_alike), groups.end());
    if (groups.size() == 1) return {};
    std::vector<Index> group_of(mesh.triangles.size());
    for (const TriangleGroup& g : mesh.groups) {
        const DrawGroup wanted{g.material, g.solid, g.kind};
        const auto found = std::lower_bound(groups.begin(), groups.end(), wanted, draws_before);
        std::fill_n(group_of.begin() + g.first, g.count, static_cast<Index>(found - groups.begin()));
    }
    return group_of;
}

/// Triangles of one group and shell that follow one another.
struct Run
{
    Index first, count, group, shell;
};

std::vector<Run> find_runs(std::span<const Index> order, std::span<const Index> group_of, const Adjacency& adjacency)
{
    if (group_of.empty() && adjacency.shell_count == 1) return {{0, static_cast<Index>(order.size()), 0, 0}};
    std::vector<Run> runs;
    for (Index i = 0; i < order.size(); ++i) {
        const Index group = group_of.empty() ? 0 : group_of[order[i]], shell = adjacency.shell[order[i]];
        if (runs.empty() || runs.back().group != group || runs.back().shell != shell)
            runs.push_back({i, 0, group, shell});
        ++runs.back().count;
    }
    return runs;
}

/// One subtree for each run; the runs of a shell meet at its root. `written_to(slot)` is called before the triangles
/// in front of that slot are read.
template <class WrittenTo>
std::vector<ShellRoot> plant_trees(std::span<const Run> runs, Index shell_count, Universe& u, WrittenTo written_to)
{
    std::vector<ShellRoot> roots(shell_count);
    for (const Run& run : runs) {
        ShellRoot& shell = roots[run.shell];
        const SlotId first(run.first);
        shell.root =
            u.tree.join(shell.root, u.tree.make_run(u.geometry(), first, run.count, GroupId(run.group), written_to));
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
}

/// With fewer triangles a second thread costs more than it saves.
constexpr std::size_t kWorthAThread = 20'000;

}  // namespace

std::vector<ShellRoot> prepare_universe(const ProvenMesh& proven, Universe& u, const PrepareOptions& options)
{
    const IndexedMesh& mesh = proven;
    const Adjacency& adjacency = proven.adjacency();
    const Progress& progress = options.progress;
    const std::size_t n = mesh.triangles.size();
    const bool two_threads = options.threads > 1 && n >= kWorthAThread;
    const Box& bounds = proven.bounds();
    u.reference = mass_reference(bounds);
    u.noise = plane_noise(bounds.largest_coordinate());
    u.set_materials(mesh.materials);
    for (const VertexStream& stream : mesh.streams) u.streams.push_back({stream.name, stream.width, {}});

    // The shares are those that the steps have of the time, about.
    progress.at(0.0);
    // Of a closed mesh it is known without asking every half-edge.
    const std::size_t boundary =
        proven.is_closed()
            ? 0
            : static_cast<std::size_t>(std::count(adjacency.opposite.begin(), adjacency.opposite.end(), kNone));
    u.has_boundary = boundary > 0;
    UniverseSize size{mesh.point_count, (3 * n + boundary) / 2, n, mesh.vertices.size(), 0};
    const std::vector<Index> group_of = sort_groups(mesh, u.groups);
    const ScratchArray<Index> order = spatial_order(proven, group_of, u.groups.size(), two_threads);
    const std::size_t crossings = crossings_of_one_cut(n) * std::max<std::size_t>(options.cuts_with_room, 1);
    std::optional<Numbering> made;
    side_by_side(
        two_threads,
        [&] {
            reserve(u, size, crossings);
            set_sizes(u, size);
        },
        [&] { made.emplace(proven, boundary); });
    Numbering& numbering = *made;
    const std::span<const Index> in_order(order.data(), order.size());
    const std::vector<Run> runs = find_runs(in_order, group_of, adjacency);
    progress.at(0.25);
    for (const Run& run : runs) size.nodes += TriangleTree::nodes_of_full_leaves(run.count) + 1;
    reserve_nodes(u, size, crossings);

    numbering.begin(in_order, u);
    NumberedChunks chunks(numbering, two_threads);
    MeshWriter writer(mesh, numbering, u);
    SlotId written(0);
    std::vector<ShellRoot> roots = plant_trees(runs, adjacency.shell_count, u, [&](SlotId end) {
        while (written < end) {
            const NumberedChunk chunk = chunks.next();
            writer.write(chunk);
            written = written + chunk.count;
            progress.at(0.25 + 0.75 * double(written.number()) / double(n));
        }
    });
    writer.finish();
    return roots;
}

}  // namespace kerf::core::halfedge
