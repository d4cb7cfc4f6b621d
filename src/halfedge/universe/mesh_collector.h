#pragma once

#include <map>
#include <span>
#include <utility>
#include <vector>

#include "halfedge/universe/number_table.h"
#include "halfedge/universe/universe.h"

namespace kerf::core::halfedge {

/// Puts a mesh together from slots: vertices and points are numbered in the order of their first use.
class MeshCollector
{
public:
    /// Both stay as long as this, and grow meanwhile at most. Gives the mesh the universe's materials and streams.
    ///
    /// @param triangles  that will be added, about
    MeshCollector(const Universe& universe, IndexedMesh& mesh, std::size_t triangles);

    /// The group of the slots to come.
    void begin_group(GroupId group);
    void add(SlotId slot);

    /// What vertices and points of the mesh are in the universe.
    std::span<const Index> old_vertices() const { return old_vertices_; }
    std::span<const PointId> old_points() const { return old_points_; }

private:
    Index vertex_at(Index vertex, PointId point);
    Index add_vertex(Index vertex, Index point);

    const Universe& u_;
    IndexedMesh& mesh_;
    GroupId group_;
    NumberTable new_vertex_, new_point_;
    /// A vertex at which the surface fell apart belongs to several points: one copy for each.
    std::map<std::pair<Index, Index>, Index> copies_;
    std::vector<Index> old_vertices_;
    std::vector<PointId> old_points_;
};

}  // namespace kerf::core::halfedge
