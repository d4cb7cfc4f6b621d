#include "halfedge/cut/cut_plan.h"

#include <limits>

#include "halfedge/cut/cap.h"
#include "halfedge/cut/components.h"
#include "halfedge/cut/rebuild.h"
#include "halfedge/cut/stitch.h"

namespace kerf::halfedge {

CutScratch::CutScratch()
    : cap_planner(std::make_unique<CapPlanner>()),
      components(std::make_unique<Components>()),
      stitcher(std::make_unique<Stitcher>()),
      rebuilder(std::make_unique<Rebuilder>())
{
}

CutScratch::~CutScratch() = default;

namespace {

template <class T>
void reserve_touched(std::vector<T>& vector, std::size_t count)
{
    if (vector.capacity() >= count) return;
    vector.resize(count);
    vector.clear();
}

}  // namespace

void CutScratch::reserve(std::size_t k)
{
    // Leaves that the plane meets hold about sixteen triangles for each one that crosses.
    reserve_touched(ops, 3 * k);
    reserve_touched(entries, 20 * k);
    crossings.reserve(k);
    reserve_touched(stack, 128);
    reserve_touched(cut_points, k);
    reserve_touched(cut_point_is_shared, k);
    reserve_touched(chain, k);
    reserve_touched(loop_edges, k);
    reserve_touched(loop_points, k);
    reserve_touched(caps, k);
    reserve_touched(cap_order, k);
    reserve_touched(cap_piece_shell, k);
}

void CutScratch::begin(Universe& u)
{
    // Stamps of earlier cuts lie below the base. Starting again from 1 once in 2^31 crossing triangles costs O(n).
    u.stamp_base += stamps_used();
    if (u.stamp_base >= std::numeric_limits<Index>::max() / 2) {
        std::fill(u.stamp_of_face.begin(), u.stamp_of_face.end(), Index(0));
        u.stamp_base = 1;
    }
    clear();
}

void CutScratch::clear()
{
    ops.clear();
    entries.clear();
    crossings.clear();
    in_plane.clear();
    flush.clear();
    cut_shells.clear();
    nodes_visited = 0;
    triangles_read = 0;
    extra_stamps = 0;
    cut_points.clear();
    boundary_cuts.clear();
    new_vertices = 0;
    irregular = collapsed = meets_boundary = false;
    outline.clear();
    outline_points.clear();
    cut_point_is_shared.clear();
    any_shared = false;
    loop_edges.clear();
    loop_points.clear();
    loops.clear();
    cancelled.clear();
    caps.clear();
    cap_sets.clear();
    cap_order.clear();
    targets.clear();
    piece_shells.clear();
    cap_piece_shell.clear();
}

}  // namespace kerf::halfedge
