#include "halfedge/cut/cutter.h"

#include <algorithm>
#include <unordered_map>

#include "halfedge/cut/cap.h"
#include "halfedge/cut/components.h"
#include "halfedge/cut/cut_plan.h"
#include "halfedge/cut/rebuild.h"
#include "halfedge/cut/stitch.h"

namespace kerf::halfedge {

void Cutter::done(Phase phase, CutResult& result)
{
    const auto now = std::chrono::steady_clock::now();
    result.statistics.phases[phase] += std::chrono::duration<double, std::milli>(now - last_).count();
    last_ = now;
}

bool Cutter::plan(const Plane& plane, const CutOptions& options, CutResult& result)
{
    plane_ = plane;
    for (const ShellRoot& shell : shells_) result.statistics.triangles += u_.tree.nodes[shell.root].count;

    if (const std::optional<Side> side = missed_side(plane, result.statistics.nodes_visited)) {
        done(Phase::find, result);
        return misses(*side, result);
    }
    s_.begin(u_);
    find_shells(plane);
    done(Phase::find, result);
    make_room_for_vertices(result);
    split_crossings(u_, s_);
    done(Phase::split, result);
    // All of a side can vanish: a spike so thin that its cut points are one.
    for (const Side side : kSides)
        if (!keeps_triangles(side)) return misses(opposite(side), result);
    walk_section(u_, plane, s_);
    done(Phase::walk, result);

    find_pieces(options, result);
    if (options.build_caps) close_section(result);
    done(Phase::cap, result);
    hand_out_caps(s_);
    if (options.split_components) divide_piece_shells(s_);
    plan_cap_groups(options);
    for (const Side side : kSides)
        if (pieces_.fragment_count[side] == 0) return misses(opposite(side), result);
    done(Phase::components, result);

    const std::size_t grown = s_.stitcher->plan(u_, s_) + s_.rebuilder->plan(u_, s_);
    result.statistics.bytes_grown += grown;
    done(grown > 0 ? Phase::growth : Phase::rebuild, result);
    leaves_open_ = !options.build_caps || result.statistics.open_chains > 0;
    return true;
}

bool Cutter::misses(Side side_of_object, CutResult& result)
{
    result.side_of_object = side_of_object;
    result.section_area = 0.0;
    result.caps_exceed_section = false;
    return false;
}

void Cutter::make_room_for_vertices(CutResult& result)
{
    // The walk writes new vertices behind the others: two for each crossing triangle at most, and two for each point of
    // the outline.
    const std::size_t outline_edges = s_.crossings.size() + s_.in_plane.size();
    const std::size_t room = 2 * s_.crossings.size() + 2 * outline_edges;
    result.statistics.bytes_grown += u_.vertices.make_room(room);
    for (Stream& stream : u_.streams) result.statistics.bytes_grown += stream.values.make_room(room * stream.width);
    done(Phase::growth, result);
}

void Cutter::find_pieces(const CutOptions& options, CutResult& result)
{
    for (Index i = 0; i < s_.cut_shells.size(); ++i)
        for (const Side side : kSides) {
            Target t;
            t.side = side;
            t.shell = i;
            s_.targets.push_back(t);
        }
    if (options.split_components) {
        s_.components->separate(u_, s_);
        pieces_ = plan_pieces(u_, plane_, whole_, s_);
    } else {
        pieces_ = plan_sides(whole_, s_);
    }
    for (const Loop& loop : s_.loops) ++(loop.closed ? result.statistics.section_loops : result.statistics.open_chains);
    result.section_area = section_area(plane_, s_);
    plan_cap_sets(s_);
    done(Phase::components, result);
}

void Cutter::close_section(CutResult& result)
{
    s_.cap_planner->plan(plane_, s_);
    result.statistics.cap_steps = s_.cap_planner->steps();
    if (const double excess = s_.cap_planner->excess(); excess > 0.0)
        result.caps_exceed_section =
            caps_exceed_section(excess, result.section_area, section_length(s_), u_.noise / kNoiseInUnits);
}

void Cutter::carry_out(CutResult& result) noexcept
{
    Universe& u = u_;
    CutScratch& s = s_;
    CutStatistics& statistics = result.statistics;
    done(Phase::components, result);  // what the caller has made of the plan
    u.has_boundary |= leaves_open_;
    add_cap_groups();
    s.stitcher->run(u, s);
    done(Phase::split, result);
    s.rebuilder->run(u, plane_, *s.stitcher, s);
    done(Phase::rebuild, result);

    statistics.nodes_visited += s.nodes_visited;
    statistics.crossing_triangles = s.crossings.size();
    for (const Crossing& c : s.crossings)
        if (u.groups[c.group].kind == TriangleKind::surface) ++statistics.crossing_surface;
    statistics.triangles_touched = s.entries.size() + s.triangles_read + 2 * s.crossings.size() + 2 * s.caps.size();
    statistics.bytes_to_upload =
        s.rebuilder->new_vertices() * sizeof(Vertex) + s.rebuilder->new_slots() * sizeof(Triangle);
    result.status = statistics.open_chains > 0 ? Status::open_section : Status::done;
}

std::optional<Side> Cutter::missed_side(const Plane& plane, std::uint64_t& nodes_visited) const
{
    const Universe& u = u_;
    const auto reaches = [&](int sign) {
        return std::any_of(shells_.begin(), shells_.end(), [&](const ShellRoot& shell) {
            return reaches_beyond(u.tree, u.geometry(), shell.root, plane, u.noise, sign, nodes_visited);
        });
    };
    if (!reaches(1)) return Side::negative;
    if (!reaches(-1)) return Side::positive;
    return std::nullopt;
}

bool Cutter::keeps_triangles(Side side) const
{
    const CutScratch& s = s_;
    if (!whole_[side].empty()) return true;
    const auto goes_to_side = [&](Index target) { return side_of_target(target) == side; };
    const auto splits_to_side = [&](const Crossing& c) {
        return std::ranges::any_of(c.split.sub_triangles(), [&](const SubTriangle& t) { return t.side == side; });
    };
    // The first crossing triangle answers, but for spikes.
    return std::any_of(s.crossings.begin(), s.crossings.end(), splits_to_side) ||
           std::any_of(s.ops.begin(), s.ops.end(),
                       [&](const TreeOp& op) { return op.kind == TreeOp::Kind::whole && goes_to_side(op.argument); }) ||
           std::any_of(s.entries.begin(), s.entries.end(),
                       [&](LeafEntry entry) { return !entry.is_crossing() && goes_to_side(entry.target()); });
}

void Cutter::find_shells(const Plane& plane)
{
    Universe& u = u_;
    CutScratch& s = s_;
    for (Index i = 0; i < shells_.size(); ++i) {
        CutShell cut;
        cut.shell = i;
        cut.solid = shells_[i].solid;
        cut.connected = shells_[i].connected;
        cut.first_op = s.ops.size();
        cut.first_flush = s.flush.size();
        cut.first_in_plane = s.in_plane.size();
        cut.first_crossing = s.crossings.size();
        const BySide<bool> present = find(u, shells_[i].root, plane, static_cast<Index>(s.cut_shells.size()), s);
        if (present[Side::negative] && present[Side::positive]) {
            cut.op_count = s.ops.size() - cut.first_op;
            cut.crossing_count = s.crossings.size() - cut.first_crossing;
            cut.flush_count = s.flush.size() - cut.first_flush;
            cut.in_plane_count = s.in_plane.size() - cut.first_in_plane;
            s.cut_shells.push_back(cut);
        } else {
            s.ops.resize(cut.first_op);
            s.flush.resize(cut.first_flush);
            whole_[present[Side::positive] ? Side::positive : Side::negative].push_back(shells_[i]);
        }
    }
}

void Cutter::plan_cap_groups(const CutOptions& options)
{
    Universe& u = u_;
    CutScratch& s = s_;
    if (s.caps.empty()) return;
    std::uint32_t material = options.cap_material;
    if (material >= material_count_) {
        // The material is added when nothing can fail any more, so that its place is known and not taken yet. It may be
        // there already: added by the cut of a relative.
        adds_cap_material_ = u.cap_material == kDefaultCapMaterial;
        material = adds_cap_material_ ? static_cast<std::uint32_t>(u.materials.size()) : u.cap_material;
        material_count_ = std::max<std::size_t>(material_count_, material + 1);
    }
    std::unordered_map<std::uint32_t, Index> group_of_solid;
    for (Index g = 0; g < u.groups.size(); ++g)
        if (u.groups[g].material == material && u.groups[g].kind == TriangleKind::cap)
            group_of_solid.emplace(u.groups[g].solid, g);
    for (PieceShell& b : s.piece_shells) {
        if (b.cap_count == 0) continue;
        const auto [entry, is_new] =
            group_of_solid.try_emplace(b.solid, static_cast<Index>(u.groups.size() + new_groups_.size()));
        if (is_new) new_groups_.push_back({material, b.solid, TriangleKind::cap});
        b.cap_group = entry->second;
    }
    u.materials.reserve(u.materials.size() + 1);
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
    std::vector<PlannedFragment> fragments(pieces_.fragment_count[side]);
    for (const Index fragment : pieces_.whole_fragment[side]) ++fragments[fragment].shells;
    for (const PieceShell& b : s_.piece_shells)
        if (b.side == side) ++fragments[b.fragment].shells;
    // Every fragment gets the loops that bound it.
    for (const Loop& loop : s_.loops) {
        SectionLoop copy;
        copy.closed = loop.closed;
        const auto first = s_.loop_points.begin() + static_cast<std::ptrdiff_t>(loop.first);
        copy.points.assign(first, first + static_cast<std::ptrdiff_t>(loop.count));
        if (!loop.closed) copy.points.push_back(loop.end);
        const Index piece_shell = s_.piece_shells_of(s_.loop_edges[loop.first])[side];
        fragments[s_.piece_shells[piece_shell].fragment].loops.push_back(std::move(copy));
    }
    return fragments;
}

}  // namespace kerf::halfedge
