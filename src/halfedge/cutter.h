#pragma once

#include <memory>
#include <vector>

#include "common/cutting/cut.h"
#include "halfedge/piece_plan.h"
#include "halfedge/universe.h"

namespace kerf::halfedge {

class Fragment;

/// One cut of one object, from FIND to the fragments.
class Cutter
{
public:
    /// @param universe        locked by the caller, until the cutter has ended
    /// @param material_count  of the object: the first of the universe's materials
    Cutter(const std::shared_ptr<Universe>& universe, const std::vector<Shell>& shells, std::size_t material_count)
        : universe_(universe), shells_(shells), material_count_(material_count)
    {
    }

    CutResult cut(const Plane& plane, const CutOptions& options);

private:
    bool misses(const Plane& plane, std::uint64_t& nodes_visited) const;
    void find_shells(const Plane& plane);
    /// Whether a side gets any triangle, once the crossing triangles are split: asked before targets are made.
    bool keeps_triangles(Side side) const;
    /// Names the groups of the caps, those that are to be added included, and makes room for them.
    void plan_cap_groups(const CutOptions& options);
    /// Adds the cap material and groups; can't fail.
    void add_cap_groups();
    void make_fragments();

    const std::shared_ptr<Universe>& universe_;
    const std::vector<Shell>& shells_;
    std::array<std::vector<Shell>, 2> whole_;  ///< shells that the plane does not cut, by side
    PiecePlan pieces_;
    std::size_t material_count_;  ///< of the object; from plan_cap_groups() on that of the fragments
    bool adds_cap_material_ = false;
    std::vector<Group> new_groups_;
    std::array<std::vector<std::unique_ptr<Fragment>>, 2> fragments_;
};

}  // namespace kerf::halfedge
