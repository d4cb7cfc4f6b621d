#include "halfedge/cut/cutter.h"

#include <algorithm>
#include <vector>

#include "common/cutting/back_end_helpers.h"
#include "common/mesh/plane_frame.h"
#include "common/mesh/plane_noise.h"
#include "halfedge/cut/crossing_numbers.h"
#include "halfedge/cut/partial_cut.h"
#include "halfedge/cut/piece_plan.h"
#include "halfedge/cut/split.h"
#include "halfedge/cut/stitch.h"

namespace kerf::core::halfedge {

void Cutter::done(Phase phase, CutResult& result)
{
    result.statistics.phases[phase] += watch_.lap();
}

bool Cutter::plan(const Plane& plane, const CutOptions& options, CutResult& result)
{
    plane_ = plane;
    cap_uv_scale_ = options.cap_uv_scale;
    for (const ShellRoot& shell : shells_) result.statistics.triangles += u_.tree.nodes[shell.root].count;

    if (const std::optional<Side> side =
            missed_side(u_, shells_, plane, w_.waiting_nodes, result.statistics.nodes_visited)) {
        done(Phase::find, result);
        return misses(*side, result);
    }
    w_.begin(u_);
    FaceStamps numbers(u_);
    w_.finder.run(u_, shells_, plane, numbers, w_.found);
    done(Phase::find, result);
    make_room_for_vertices(result);
    Coincidences coincidences = split_crossings(u_, numbers, w_.found);
    done(Phase::split, result);
    // All of a side can vanish: a spike so thin that its cut points are one.
    for (const Side side : kSides)
        if (!w_.found.keeps_triangles(side)) return misses(opposite(side), result);
    if (options.only && !keep_the_rest(options, coincidences, result)) return false;
    w_.walker.run(u_, plane, coincidences, w_.outline_linker, w_.found, w_.section);
    done(Phase::walk, result);

    find_pieces(options, result);
    if (options.build_caps) close_section(options.cap_quality, result);
    done(Phase::cap, result);
    hand_out_caps(w_.found, w_.section, w_.caps, w_.pieces);
    if (options.split_components) divide_piece_shells(w_.found, w_.section, w_.caps, w_.pieces);
    plan_cap_groups(options);
    for (const Side side : kSides)
        if (w_.pieces.fragment_count[side] == 0) return misses(opposite(side), result);
    done(Phase::components, result);

    const std::size_t grown = plan_stitch(u_, w_.found, w_.section, w_.caps, w_.stitch_plan) +
                              w_.rebuilder.plan(u_, w_.found, w_.section, w_.caps, w_.pieces);
    result.statistics.bytes_grown += grown;
    done(grown > 0 ? Phase::growth : Phase::rebuild, result);
    leaves_open_ = !options.build_caps || result.statistics.open_chains > 0;
    return true;
}

bool Cutter::misses(Side side_of_object, CutResult& result)
{
    result.side_of_object = side_of_object;
    result.statistics.section_loops = result.statistics.open_chains = result.statistics.cap_steps = 0;
    result.section_area = 0.0;
    result.caps_exceed_section = false;
    return false;
}

void Cutter::make_room_for_vertices(CutResult& result)
{
    // The walk writes new vertices behind the others: at most two for an edge that it crosses from one triangle to the
    // next, and one for an edge of the boundary.
    const std::size_t room = 2 * w_.found.crossings.size();
    result.statistics.bytes_grown += u_.vertices.make_room(room);
    for (Stream& stream : u_.streams) result.statistics.bytes_grown += stream.values.make_room(room * stream.width);
    done(Phase::growth, result);
}

bool Cutter::keep_the_rest(const CutOptions& options, Coincidences& coincidences, CutResult& result)
{
    w_.walker.run_outline(u_, plane_, coincidences, w_.outline_linker, w_.found, w_.section);
    done(Phase::walk, result);
    const std::vector<bool> is_chosen = chosen_edges(u_, plane_, *options.only, w_.found, w_.section);
    make_first_targets(w_.found, w_.pieces);
    w_.part_finder.separate(u_, w_.section, w_.found, w_.pieces);
    plan_pieces(u_, plane_, w_.found, w_.outline_linker, w_.section, w_.pieces);
    // The stamps of this pass are those of an earlier cut to the next one.
    u_.stamp_base += w_.found.crossings.size() + w_.part_finder.stamps_used();
    w_.part_finder.forget_stamps();
    w_.begin(u_);
    if (!keep_the_rest_whole(u_, shells_, is_chosen, options.split_components, w_.found, w_.pieces)) {
        result.status = Status::not_separated;
        return misses(Side::negative, result);
    }
    w_.section.clear();
    done(Phase::components, result);
    FaceStamps numbers(u_);
    for (const Crossing& c : w_.found.crossings) numbers.add(c.face);
    coincidences = split_crossings(u_, numbers, w_.found);
    done(Phase::split, result);
    return true;
}

void Cutter::find_pieces(const CutOptions& options, CutResult& result)
{
    if (options.only) {
        if (options.split_components && w_.section.is_irregular())
            w_.outline_linker.relink(u_, plane_, w_.found, w_.pieces, w_.section);
        return count_paths(result);
    }
    make_first_targets(w_.found, w_.pieces);
    if (options.split_components) {
        w_.part_finder.separate(u_, w_.section, w_.found, w_.pieces);
        plan_pieces(u_, plane_, w_.found, w_.outline_linker, w_.section, w_.pieces);
    } else {
        plan_sides(w_.found, w_.section, w_.pieces);
    }
    count_paths(result);
}

void Cutter::count_paths(CutResult& result)
{
    for (const Loop& loop : w_.section.loops)
        ++(loop.closed ? result.statistics.section_loops : result.statistics.open_chains);
    result.section_area = section_area(plane_, w_.section);
    plan_cap_sets(w_.found, w_.pieces, w_.section);
    done(Phase::components, result);
}

void Cutter::close_section(CapQuality quality, CutResult& result)
{
    w_.cap_planner.plan(plane_, quality, w_.found, w_.section, w_.caps);
    result.statistics.cap_steps = w_.cap_planner.steps();
    if (const double excess = w_.cap_planner.excess(); excess > 0.0)
        result.caps_exceed_section =
            caps_exceed_section(excess, result.section_area, section_length(w_.section), rounding_unit(u_.noise));
}

void Cutter::carry_out(CutResult& result) noexcept
{
    CutStatistics& statistics = result.statistics;
    done(Phase::components, result);  // what the caller has made of the plan
    u_.has_boundary |= leaves_open_;
    add_cap_groups();
    stitch(u_, w_.found, w_.section, w_.caps, w_.stitch_plan);
    done(Phase::split, result);  // what `split` counts is written in statistics.h
    w_.rebuilder.run(u_, statistics.triangles, plane_, PlaneFrame::of(plane_.normal, cap_uv_scale_), w_.stitch_plan,
                     w_.found, w_.section, w_.caps, w_.pieces);
    done(Phase::rebuild, result);

    const Found& found = w_.found;
    statistics.nodes_visited += found.nodes_visited;
    statistics.crossing_triangles = found.crossings.size();
    for (const Crossing& c : found.crossings)
        if (u_.group(c.group).kind == TriangleKind::surface) ++statistics.crossing_surface;
    statistics.triangles_touched =
        found.entries.size() + found.triangles_read + 2 * found.crossings.size() + 2 * w_.caps.triangles.size();
    statistics.bytes_to_upload =
        w_.rebuilder.new_vertices() * sizeof(Vertex) + w_.rebuilder.new_slots() * sizeof(Triangle);
    result.status = statistics.open_chains > 0 ? Status::open_section : Status::done;
}

void Cutter::plan_cap_groups(const CutOptions& options)
{
    Universe& u = u_;
    if (w_.caps.triangles.empty()) return;
    std::uint32_t material = options.cap_material;
    if (material >= material_count_) {
        // The material is added when nothing can fail any more, so that its place is known and not taken yet. It may be
        // there already: added by the cut of a relative.
        adds_cap_material_ = u.cap_material == kDefaultCapMaterial;
        material = adds_cap_material_ ? static_cast<std::uint32_t>(u.materials.size()) : u.cap_material;
        material_count_ = std::max<std::size_t>(material_count_, material + 1);
    }
    struct GroupOfSolid
    {
        std::uint32_t solid;
        Index group;  // kNone: there is none yet
        bool operator<(const GroupOfSolid& other) const { return solid < other.solid; }
    };
    std::vector<GroupOfSolid> group_of_solid;
    group_of_solid.reserve(w_.pieces.shells.size());
    for (const PieceShell& shell : w_.pieces.shells)
        if (shell.cap_count > 0) group_of_solid.push_back({shell.solid, kNone});
    std::sort(group_of_solid.begin(), group_of_solid.end());
    const auto find = [&](std::uint32_t solid) {
        return std::lower_bound(group_of_solid.begin(), group_of_solid.end(), GroupOfSolid{solid, kNone});
    };
    for (Index g = 0; g < u.groups.size(); ++g) {
        if (u.groups[g].material != material || u.groups[g].kind != TriangleKind::cap) continue;
        const auto entry = find(u.groups[g].solid);
        if (entry != group_of_solid.end() && entry->solid == u.groups[g].solid && entry->group == kNone)
            entry->group = g;
    }
    for (PieceShell& shell : w_.pieces.shells) {
        if (shell.cap_count == 0) continue;
        Index& group = find(shell.solid)->group;
        if (group == kNone) {
            group = static_cast<Index>(u.groups.size() + new_groups_.size());
            new_groups_.push_back({material, shell.solid, TriangleKind::cap});
        }
        shell.cap_group = GroupId(group);
    }
    if (adds_cap_material_) u.make_room_for_material();
    u.groups.reserve(u.groups.size() + new_groups_.size());
}

void Cutter::add_cap_groups()
{
    Universe& u = u_;
    if (adds_cap_material_) u.cap_material = add_cap_material(u.materials);
    u.groups.insert(u.groups.end(), new_groups_.begin(), new_groups_.end());
}

std::vector<PlannedFragment> Cutter::planned_fragments(Side side) const
{
    std::vector<PlannedFragment> fragments(w_.pieces.fragment_count[side]);
    for (const Index fragment : w_.pieces.whole_fragment[side]) ++fragments[fragment].shells;
    for (const PieceShell& shell : w_.pieces.shells)
        if (shell.side == side) ++fragments[shell.fragment].shells;
    // Every fragment gets the loops that bound it.
    for (const Loop& loop : w_.section.loops) {
        SectionLoop copy;
        copy.closed = loop.closed;
        const auto first = w_.section.loop_points.begin() + static_cast<std::ptrdiff_t>(loop.first);
        copy.points.assign(first, first + static_cast<std::ptrdiff_t>(loop.count));
        if (!loop.closed) copy.points.push_back(loop.end);
        const Index piece_shell = w_.pieces.shells_of(w_.found, w_.section.loop_edges[loop.first])[side];
        fragments[w_.pieces.shells[piece_shell].fragment].loops.push_back(std::move(copy));
    }
    return fragments;
}

}  // namespace kerf::core::halfedge
