#pragma once

#include <unordered_map>
#include <vector>

#include "common/geometry/disjoint_sets.h"
#include "halfedge/cut/section.h"

namespace kerf::core::halfedge {

/// Classes of coinciding points: union-find over cut points and, as they turn up, points of the half-edge mesh.
class CoincidingPoints
{
public:
    /// What split_triangle() found to coincide is one class.
    CoincidingPoints(const Universe& universe, const Found& found, const Section& section)
        : u_(universe), position_(section.cut_points), classes_(static_cast<Index>(position_.size()))
    {
        for (const Crossing& c : found.crossings) {
            if (c.n_cut_point().is_valid()) classes_.unite(c.n_cut_point().number(), of_code(c, c.split.next_code));
            if (c.p_cut_point().is_valid()) classes_.unite(c.p_cut_point().number(), of_code(c, c.split.previous_code));
        }
    }

    Index of_point(PointId point)
    {
        const auto [entry, is_new] = of_point_.try_emplace(point, classes_.size());
        if (is_new) {
            classes_.add();
            position_.push_back(u_.mesh.position(point));
        }
        return entry->second;
    }

    /// The element at a corner of a crossing triangle.
    Index of_code(const Crossing& c, std::uint8_t code)
    {
        if (code == TriangleSplit::kCutNext) return c.n_cut_point().number();
        if (code == TriangleSplit::kCutPrevious) return c.p_cut_point().number();
        return of_point(c.point[code]);
    }

    Index find(Index i) { return classes_.find(i); }

    std::size_t size() const { return classes_.size(); }
    const glm::vec3& position(Index i) const { return position_[i]; }

private:
    const Universe& u_;
    std::vector<glm::vec3> position_;
    DisjointSets classes_;
    std::unordered_map<PointId, Index> of_point_;
};

}  // namespace kerf::core::halfedge
