#pragma once

#include <span>
#include <vector>

#include "common/cutting/group_pieces.h"
#include "common/geometry/disjoint_sets.h"
#include "halfedge/cut/planned_pieces.h"

namespace kerf::core::halfedge {

/// The parts of one side: triangles that are connected by edges. Targets are numbered first, then whole shells.
class PartsOfSide
{
public:
    PartsOfSide(const Universe& universe, const Plane& plane, Side side, Found& found, const Pieces& pieces)
        : u_(universe), plane_(plane), side_(side), whole_(found.whole[side]), found_(found), pieces_(pieces)
    {
    }

    /// Numbers the parts. Targets in one set of `same` are one part.
    void list(DisjointSets& same);
    void mark_cut(Index part) { parts_[part].is_cut = true; }
    /// Measures the parts for group_pieces(), except those of solids that are in one part.
    void measure();
    /// As group_pieces() asks for it.
    void count_crossings(std::span<const AxisRay> rays, const std::vector<bool>& is_wanted,
                         const AddCrossing& add) const;
    /// Makes a piece shell of the targets of each piece, and says which fragments there are.
    void make_piece_shells(const std::vector<std::uint32_t>& piece, Pieces& pieces) const;

    Index of_target(TargetId target) const { return of_target_[target.number()]; }
    const std::vector<SurfacePart>& parts() const { return parts_; }

private:
    std::uint32_t solid_of(TargetId target) const { return found_.shells[pieces_.target(target).shell].solid; }
    Index add(TargetId target);
    template <class HasSeveral>
    void mark_far_parts(std::vector<bool>& is_far, HasSeveral has_several) const;

    const Universe& u_;
    const Plane& plane_;
    const Side side_;
    const std::vector<ShellRoot>& whole_;
    Found& found_;
    const Pieces& pieces_;
    std::vector<SurfacePart> parts_;
    std::vector<Index> of_target_;
    Index cut_count_ = 0;
};

}  // namespace kerf::core::halfedge
