#pragma once

#include <array>
#include <optional>
#include <vector>

#include "common/cutting/cut.h"
#include "common/support/stopwatch.h"
#include "halfedge/cut/workspace.h"
#include "halfedge/universe/universe.h"

// A cut of the half-edge back end, from beginning to end: FIND, SPLIT, WALK, the parts and pieces, the caps (planned by
// plan(), which changes no result), STITCH, REBUILD (carried out by carry_out()). Each has a header of its own.

namespace kerf::core::halfedge {

/// A fragment to be.
struct PlannedFragment
{
    std::size_t shells = 0;          ///< that it gets, at most
    std::vector<SectionLoop> loops;  ///< that bound it
};

/// One cut of one object. plan() may fail and changes nothing; carry_out() changes the universe and can't fail.
class Cutter
{
public:
    /// @param universe        locked by the caller, until the cutter has ended
    /// @param workspace       in which the cut is planned; no other cut uses it meanwhile
    /// @param material_count  of the object: the first of the universe's materials
    Cutter(Universe& universe, CutWorkspace& workspace, const std::vector<ShellRoot>& shells,
           std::size_t material_count)
        : u_(universe), w_(workspace), shells_(shells), material_count_(material_count)
    {
    }
    ~Cutter() { w_.end(u_); }
    Cutter(const Cutter&) = delete;
    Cutter& operator=(const Cutter&) = delete;

    /// Does all steps from FIND to the caps, and makes room for the rest. Returns false if the plane misses; `result`
    /// then has only the cost of finding that out. May throw std::bad_alloc.
    bool plan(const Plane& plane, const CutOptions& options, CutResult& result);

    /// The fragments of a side, once the cut is planned.
    std::vector<PlannedFragment> planned_fragments(Side side) const;
    std::size_t material_count() const { return material_count_; }

    /// STITCH and REBUILD; completes the statistics of `result`.
    void carry_out(CutResult& result) noexcept;

    /// Calls visit(side, fragment, shell) for each shell of the fragments, once the cut is carried out.
    template <class Visit>
    void for_each_shell(Visit visit) const
    {
        for (const Side side : kSides)
            for (std::size_t i = 0; i < w_.found.whole[side].size(); ++i)
                visit(side, w_.pieces.whole_fragment[side][i], w_.found.whole[side][i]);
        for (const PieceShell& shell : w_.pieces.shells)
            if (shell.root.is_valid())
                visit(shell.side, shell.fragment, ShellRoot{shell.root, shell.solid, shell.connected});
    }

private:
    /// Fills the result of a miss. Returns false, as plan() does then.
    static bool misses(Side side_of_object, CutResult& result);
    void make_room_for_vertices(CutResult& result);
    /// For CutOptions::only: finds what the whole cut would find, and of that what is cut. The numbers of the crossing
    /// triangles are new then, and the pieces are planned. Returns false if that does not part the object.
    bool keep_the_rest(const CutOptions& options, Coincidences& coincidences, CutResult& result);
    /// Finds the parts and the pieces, if they are not planned yet, and the loops that are closed together.
    void find_pieces(const CutOptions& options, CutResult& result);
    void count_paths(CutResult& result);
    void close_section(CapQuality quality, CutResult& result);
    /// Names the groups of the caps, those that are to be added included, and makes room for them.
    void plan_cap_groups(const CutOptions& options);
    /// Adds the cap material and groups; can't fail.
    void add_cap_groups();
    /// Adds the time since the last call to a phase.
    void done(Phase phase, CutResult& result);

    Universe& u_;
    CutWorkspace& w_;
    const std::vector<ShellRoot>& shells_;
    std::size_t material_count_;  ///< of the object; from plan_cap_groups() on that of the fragments
    bool adds_cap_material_ = false;
    std::vector<DrawGroup> new_groups_;
    bool leaves_open_ = false;  ///< some fragment may be open afterwards
    Plane plane_;
    Stopwatch watch_;
    double cap_uv_scale_ = 1.0;
};

}  // namespace kerf::core::halfedge
