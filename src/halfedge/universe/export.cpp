#include "halfedge/universe/export.h"

#include <algorithm>
#include <map>

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
    mesh.materials = u.materials;
    mesh.triangles.reserve(triangles);
    mesh.sources.reserve(triangles);
    for (const Stream& stream : u.streams) mesh.streams.push_back({stream.name, stream.width, {}});

    std::vector<Index> new_vertex(u.vertices.size(), kNone), new_point(u.mesh.points(), kNone);
    // A vertex at which the surface fell apart belongs to several points: one copy for each.
    std::map<std::pair<Index, Index>, Index> copies;
    const auto add_vertex = [&](Index vertex, Index point) {
        mesh.vertices.push_back(u.vertices[vertex]);
        mesh.points.push_back(point);
        for (std::size_t i = 0; i < u.streams.size(); ++i) {
            const float* values = u.streams[i].values.data() + std::size_t(vertex) * u.streams[i].width;
            mesh.streams[i].values.insert(mesh.streams[i].values.end(), values, values + u.streams[i].width);
        }
        return static_cast<Index>(mesh.vertices.size() - 1);
    };
    const auto vertex_at = [&](Index vertex, PointId old_point) {
        Index& point = new_point[number_of(old_point)];
        if (point == kNone) point = mesh.point_count++;
        Index& first = new_vertex[vertex];
        if (first == kNone) first = add_vertex(vertex, point);
        if (mesh.points[first] == point) return first;
        const auto [entry, is_new] = copies.try_emplace({vertex, point}, 0);
        if (is_new) entry->second = add_vertex(vertex, point);
        return entry->second;
    };
    for (const Index g : order) {
        const DrawGroup& group = u.groups[g];
        mesh.groups.push_back({static_cast<Index>(mesh.triangles.size()), static_cast<Index>(slots_of_group[g].size()),
                               group.material, group.solid, group.kind});
        for (const SlotId slot : slots_of_group[g]) {
            const FaceId face = u.face_of_slot[slot];
            HalfedgeId h = u.mesh.halfedge_of(face);
            Triangle triangle;
            for (std::size_t c = 0; c < 3; ++c, h = u.mesh.next(h))
                triangle[c] = vertex_at(u.slots[slot][c], u.mesh.from(h));
            mesh.triangles.push_back(triangle);
            mesh.sources.push_back(u.source_of_face[face]);
        }
    }
    return mesh;
}

}  // namespace kerf::core::halfedge
