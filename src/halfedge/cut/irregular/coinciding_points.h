#pragma once

#include <vector>

#include "common/geometry/disjoint_sets.h"
#include "common/geometry/pair_table.h"
#include "halfedge/cut/section.h"

namespace kerf::core::halfedge {

/// Classes of coinciding points: union-find over cut points and, as they turn up, points of the half-edge mesh. Keeps its
/// memory.
class CoincidingPoints
{
public:
    CoincidingPoints() = default;
    CoincidingPoints(const Universe& universe, const Found& found, const Section& section)
    {
        begin(universe, found, section);
    }

    /// Begins anew: what split_triangle() found to coincide is one class. The universe lives as long as it is asked.
    void begin(const Universe& universe, const Found& found, const Section& section)
    {
        u_ = &universe;
        position_ = section.cut_points;
        classes_.clear();
        for (std::size_t i = 0; i < position_.size(); ++i) classes_.add();
        // Room for all points of crossing triangles and edges in the plane: a table that grows takes memory.
        of_point_.reset(2 * (found.crossings.size() + found.in_plane.size()));
        for (const Crossing& c : found.crossings) {
            if (c.n_cut_point().is_valid()) classes_.unite(c.n_cut_point().number(), of_code(c, c.split.next_code));
            if (c.p_cut_point().is_valid()) classes_.unite(c.p_cut_point().number(), of_code(c, c.split.previous_code));
        }
    }

    Index of_point(PointId point)
    {
        const auto number = static_cast<Index>(point.idx());
        Index& element = of_point_(number, number);
        if (element == kNone) {
            element = classes_.add();
            position_.push_back(u_->mesh.position(point));
        }
        return element;
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
    const Universe* u_ = nullptr;
    std::vector<glm::vec3> position_;
    DisjointSets classes_{0};
    PairTable of_point_;  ///< by a point twice
};

}  // namespace kerf::core::halfedge
