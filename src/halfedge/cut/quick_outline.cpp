#include "halfedge/cut/quick_outline.h"

#include <algorithm>
#include <array>

#include "common/caps/section_area.h"
#include "common/cutting/cut_geometry.h"

namespace kerf::core::halfedge {

bool QuickOutline::find(const Universe& u, const std::vector<ShellRoot>& shells, const Plane& plane,
                        PlaneSection& section)
{
    numbers_.clear();
    program_.clear();
    crossed_.clear();
    const std::uint64_t nodes_before = section.nodes_visited;
    if (!(find_crossed(u, shells, plane, section) && find_next(u) && trace(u, section))) {
        section.clear();
        section.nodes_visited = nodes_before;
        return false;
    }
    section.area = section_area(plane, [&](auto visit) {
        for (const PlaneSection::Path& path : section.paths) {
            const auto points = section.points_of(path);
            for (std::size_t i = 0; i + 1 < points.size(); ++i) visit(points[i], points[i + 1]);
            visit(points.back(), points.front());
        }
    });
    section.crossing_triangles = crossed_.size();
    section.status = Status::done;
    return true;
}

/// FIND: the triangles that cross, in the order of the tree. False if a corner lies on the plane, a cut point on a corner,
/// or if none crosses.
bool QuickOutline::find_crossed(const Universe& u, const std::vector<ShellRoot>& shells, const Plane& plane,
                                PlaneSection& section)
{
    for (const ShellRoot& shell : shells)
        section.nodes_visited += visit_tree(u, plane, 0, shell.root, visits_, program_).nodes;
    // The program becomes, in place, the list of its leaves.
    std::size_t count = 0;
    for (const TreeOp& op : program_) {
        program_[count] = op;
        count += op.kind == TreeOp::Kind::leaf ? 1 : 0;
    }
    constexpr std::size_t kAhead = 2;
    const std::size_t asked_for = u.geometry().is_far_away() ? count : 0;
    for (std::size_t i = 0; i < count; ++i) {
        if (i + kAhead < asked_for) {
            const Node& later = u.tree.nodes[program_[i + kAhead].node];
            for (std::uint32_t t = 0; t < later.count; ++t)
                for (const Index v : u.slots[later.first + t]) __builtin_prefetch(&u.vertices[v]);
        }
        const Node& leaf = u.tree.nodes[program_[i].node];
        section.triangles_touched += leaf.count;
        if (!open_leaf(u, plane, leaf)) return false;
    }
    return !crossed_.empty();
}

bool QuickOutline::open_leaf(const Universe& u, const Plane& plane, const Node& leaf)
{
    distances_.find(plane, {u.vertices.data(), u.vertices.size()}, {&u.slots[leaf.first], leaf.count});
    for (std::uint32_t i = 0; i < leaf.count; ++i) {
        if (distances_.is_on(i)) return false;
        if (!(distances_.is_above(i) && distances_.is_below(i))) continue;
        const SlotId slot = leaf.first + i;
        const Triangle& t = u.slots[slot];
        const std::array<double, 3> d = distances_.of(i);
        // The one edge that leads from below to above, and the one that leads back.
        const Index exit = d[0] < 0.0 && d[1] > 0.0 ? 0 : d[1] < 0.0 && d[2] > 0.0 ? 1 : 2;
        const Index entry = d[0] > 0.0 && d[1] < 0.0 ? 0 : d[1] > 0.0 && d[2] < 0.0 ? 1 : 2;
        const auto position = [&](Index corner) -> const glm::vec3& { return u.vertices[t[corner % 3]].position; };
        Crossed& c = crossed_.emplace_back();
        c.exit = cut_edge(position(exit), d[exit], position(exit + 1), d[(exit + 1) % 3]).position;
        for (Index corner = 0; corner < 3; ++corner)
            if (same_position(c.exit, position(corner))) return false;
        c.opposite = position(entry + 2);
        c.face = u.face_of_slot[slot];
        c.group = leaf.group;
        c.exit_corner = exit;
        numbers_.add(c.face);
    }
    return true;
}

/// Which triangle the outline comes to from which. False if it comes to a hole.
bool QuickOutline::find_next(const Universe& u)
{
    // What a triangle leads to is asked for some triangles ahead: its face, then its half-edges.
    constexpr std::size_t kAhead = 8;
    const std::size_t count = crossed_.size();
    for (std::size_t i = 0; i < count; ++i) {
        if (i + 2 * kAhead < count) u.mesh.prefetch(crossed_[i + 2 * kAhead].face);
        if (i + kAhead < count) u.mesh.prefetch(u.mesh.halfedge_of(crossed_[i + kAhead].face));
        Crossed& c = crossed_[i];
        HalfedgeId h = u.mesh.halfedge_of(c.face);
        for (Index corner = 0; corner < c.exit_corner; ++corner) h = u.mesh.next(h);
        const FaceId beyond = u.mesh.face(opposite(h));
        if (!beyond.is_valid()) return false;
        c.next = numbers_.of(beyond);
        if (c.next == kNone) return false;
    }
    return true;
}

/// The loops, each from the first of its triangles on. False if two cut points coincide, or a loop runs forth and back
/// over two triangles.
bool QuickOutline::trace(const Universe& u, PlaneSection& section)
{
    constexpr std::size_t kBackToBack = 2;
    section.points.reserve(crossed_.size());
    section.edges.reserve(crossed_.size());
    for (Index start = 0; start < crossed_.size(); ++start) {
        if (crossed_[start].next == kNone) continue;
        PlaneSection::Path path;
        path.first_point = section.points.size();
        path.first_edge = section.edges.size();
        path.solid = u.group(crossed_[start].group).solid;
        for (Index at = start; crossed_[at].next != kNone;) {
            Crossed& from = crossed_[at];
            const Crossed& to = crossed_[from.next];
            // The point lies on the edge by which `to` is entered, too.
            if (same_position(from.exit, to.exit) || same_position(from.exit, to.opposite)) return false;
            section.points.push_back(from.exit);
            section.edges.push_back({u.source_of_face[from.face], u.group(from.group).material});
            at = from.next;
            from.next = kNone;
        }
        path.point_count = path.edge_count = section.points.size() - path.first_point;
        if (path.point_count <= kBackToBack) return false;
        // Edge i starts at point i, which is where the outline left the triangle before.
        std::rotate(section.points.begin() + static_cast<std::ptrdiff_t>(path.first_point), section.points.end() - 1,
                    section.points.end());
        section.paths.push_back(path);
    }
    return true;
}

}  // namespace kerf::core::halfedge
