#include "halfedge/universe/export.h"

#include <algorithm>

#include "halfedge/universe/mesh_collector.h"

namespace kerf::core::halfedge {

IndexedMesh export_mesh(const Universe& u, std::span<const ShellRoot> shells)
{
    // Leaves by group, in the order in which groups are drawn; the tree's order within a group.
    std::vector<std::vector<SlotId>> slots_of_group(u.groups.size());
    std::size_t triangles = 0;
    for (const ShellRoot& shell : shells) {
        std::vector<TriangleTree::Run> runs;
        u.tree.append_runs(shell.root, runs);
        for (const TriangleTree::Run& run : runs) {
            for (Index i = 0; i < run.count; ++i) slots_of_group[run.group.number()].push_back(run.first + i);
            triangles += run.count;
        }
    }
    std::vector<Index> order;
    for (Index g = 0; g < u.groups.size(); ++g)
        if (!slots_of_group[g].empty()) order.push_back(g);
    std::stable_sort(order.begin(), order.end(),
                     [&](Index a, Index b) { return draws_before(u.groups[a], u.groups[b]); });

    IndexedMesh mesh;
    mesh.triangles.reserve(triangles);
    mesh.sources.reserve(triangles);
    MeshCollector collector(u, mesh, triangles);
    for (const Index g : order) {
        collector.begin_group(GroupId(g));
        for (const SlotId slot : slots_of_group[g]) collector.add(slot);
    }
    return mesh;
}

}  // namespace kerf::core::halfedge
