#pragma once

#include <span>
#include <vector>

#include "common/cutting/pieces.h"
#include "common/geometry/disjoint_sets.h"
#include "halfedge/cut/cut_plan.h"

namespace kerf::halfedge {

/// The parts of one side: what hangs together by edges. Targets are numbered first, then whole shells.
class PartsOfSide
{
public:
    PartsOfSide(const Universe& universe, const Plane& plane, Side side, const std::vector<ShellRoot>& whole,
                CutScratch& scratch)
        : u_(universe), plane_(plane), side_(side), whole_(whole), s_(scratch)
    {
    }

    /// Numbers the parts. `same` are targets that are one part.
    void list(DisjointSets& same);
    void mark_cut(Index part) { parts_[part].is_cut = true; }
    /// Measures what group_pieces() may ask for: nothing where each solid is in one part.
    void measure();
    /// As group_pieces() asks for it.
    void count_crossings(std::span<const AxisRay> rays, const std::vector<bool>& is_wanted,
                         const AddCrossing& add) const;
    /// Makes a piece shell of the targets of each piece. Fills the fragment of each whole shell and returns how many
    /// fragments there are.
    Index make_piece_shells(const std::vector<std::uint32_t>& piece, CutScratch& s,
                            std::vector<Index>& whole_fragment) const;

    Index of_target(Index target) const { return of_target_[target]; }
    const std::vector<SurfacePart>& parts() const { return parts_; }

private:
    std::uint32_t solid_of(Index target) const { return s_.cut_shells[s_.targets[target].shell].solid; }
    Index add(Index target);
    template <class HasSeveral>
    void mark_far_parts(std::vector<bool>& is_far, HasSeveral has_several) const;

    const Universe& u_;
    const Plane& plane_;
    const Side side_;
    const std::vector<ShellRoot>& whole_;
    CutScratch& s_;
    std::vector<SurfacePart> parts_;
    std::vector<Index> of_target_;
    Index cut_count_ = 0;
};

}  // namespace kerf::halfedge
