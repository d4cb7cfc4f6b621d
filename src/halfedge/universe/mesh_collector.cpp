#include "halfedge/universe/mesh_collector.h"

namespace kerf::core::halfedge {

MeshCollector::MeshCollector(const Universe& universe, IndexedMesh& mesh, std::size_t triangles)
    : u_(universe), mesh_(mesh), new_vertex_(u_.vertices.size(), triangles), new_point_(u_.mesh.points(), triangles)
{
    mesh_.materials = u_.materials;
    for (const Stream& stream : u_.streams) mesh_.streams.push_back({stream.name, stream.width, {}});
}

void MeshCollector::begin_group(GroupId group)
{
    if (group == group_) return;
    group_ = group;
    const DrawGroup& g = u_.group(group);
    mesh_.groups.push_back({static_cast<Index>(mesh_.triangles.size()), 0, g.material, g.solid, g.kind});
}

void MeshCollector::add(SlotId slot)
{
    const FaceId face = u_.face_of_slot[slot];
    HalfedgeId h = u_.mesh.halfedge_of(face);
    Triangle triangle;
    for (std::size_t c = 0; c < 3; ++c, h = u_.mesh.next(h))
        triangle[c] = vertex_at(u_.slots[slot][c], u_.mesh.from(h));
    mesh_.triangles.push_back(triangle);
    mesh_.sources.push_back(u_.source_of_face[face]);
    ++mesh_.groups.back().count;
}

Index MeshCollector::vertex_at(Index vertex, PointId old_point)
{
    Index& point = new_point_(number_of(old_point));
    if (point == kNone) {
        point = mesh_.point_count++;
        old_points_.push_back(old_point);
    }
    Index& first = new_vertex_(vertex);
    if (first == kNone) first = add_vertex(vertex, point);
    if (mesh_.points[first] == point) return first;
    const auto [entry, is_new] = copies_.try_emplace({vertex, point}, 0);
    if (is_new) entry->second = add_vertex(vertex, point);
    return entry->second;
}

Index MeshCollector::add_vertex(Index vertex, Index point)
{
    mesh_.vertices.push_back(u_.vertices[vertex]);
    mesh_.points.push_back(point);
    old_vertices_.push_back(vertex);
    for (std::size_t i = 0; i < u_.streams.size(); ++i) {
        const float* values = u_.streams[i].values.data() + std::size_t(vertex) * u_.streams[i].width;
        mesh_.streams[i].values.insert(mesh_.streams[i].values.end(), values, values + u_.streams[i].width);
    }
    return static_cast<Index>(mesh_.vertices.size() - 1);
}

}  // namespace kerf::core::halfedge
