#include "halfedge/cut/quick_outline.h"

#include <algorithm>
#include <array>
#include <bit>

#include "common/cutting/cut_geometry.h"
#include "common/cutting/section_ends.h"

namespace kerf::core::halfedge {

namespace {

/// Which edges of a triangle an outline crosses: edge i leads from corner i to the next one.
struct CrossedEdges
{
    std::uint8_t exit = 0;            ///< the one that leads from below the plane to above
    std::uint8_t opposite_entry = 0;  ///< the corner that is not at the one that leads back
};

/// By the bits of the corners that lie above.
constexpr std::array<CrossedEdges, 8> kCrossedEdges{{{0, 0}, {2, 2}, {0, 0}, {2, 0}, {1, 1}, {1, 2}, {0, 1}, {0, 0}}};

constexpr std::array<Index, 3> kNextCorner{1, 2, 0};

}  // namespace

bool QuickOutline::find(const Universe& u, const std::vector<ShellRoot>& shells, const Plane& plane,
                        PlaneSection& section)
{
    numbers_.clear();
    leaves_.clear();
    crossed_.clear();
    traced_.clear();
    const std::uint64_t nodes_before = section.nodes_visited;
    if (!(find_crossed(u, shells, plane, section) && find_next(u) && trace(u, section))) {
        section.clear();
        section.nodes_visited = nodes_before;
        return false;
    }
    if (section.wants_ends) add_ends(u, plane, section);
    section.crossing_triangles = crossed_.size();
    section.status = Status::done;
    return true;
}

/// FIND: the triangles that cross, in the order of the tree. False if a corner lies on the plane, a cut point on a corner,
/// or if none crosses.
bool QuickOutline::find_crossed(const Universe& u, const std::vector<ShellRoot>& shells, const Plane& plane,
                                PlaneSection& section)
{
    for (const ShellRoot& shell : shells) section.nodes_visited += visit_leaves(u, plane, shell.root, visits_, leaves_);
    constexpr std::size_t kAhead = 2;
    const std::size_t asked_for = u.geometry().is_far_away() ? leaves_.size() : 0;
    VertexPrefetch ahead(u);
    for (std::size_t i = 0; i < leaves_.size(); ++i) {
        ahead.aim_at_none();
        if (i + kAhead < asked_for) ahead.aim_at(u.tree.nodes[leaves_[i + kAhead]]);
        const Node& leaf = u.tree.nodes[leaves_[i]];
        section.triangles_touched += leaf.count;
        if (!open_leaf(u, plane, leaf, ahead)) return false;
    }
    return !crossed_.empty();
}

bool QuickOutline::open_leaf(const Universe& u, const Plane& plane, const Node& leaf, const VertexPrefetch& ahead)
{
    for (std::uint32_t i = 0; i < leaf.count; ++i) ahead.step(i);
    distances_.find(plane, {u.vertices.data(), u.vertices.size()}, {&u.slots[leaf.first], leaf.count});
    const LeafDistances::Masks masks = distances_.masks(leaf.count);
    if (masks.on != 0) return false;
    for (std::uint64_t crossing = masks.crossing; crossing != 0; crossing &= crossing - 1) {
        const auto i = static_cast<Index>(std::countr_zero(crossing));
        const SlotId slot = leaf.first + i;
        __builtin_prefetch(&u.face_of_slot[slot]);
        const Triangle& t = u.slots[slot];
        const std::array<double, 3> d = distances_.of(i);
        const auto position = [&](Index corner) -> const glm::vec3& { return u.vertices[t[corner]].position; };
        const CrossedEdges edges = kCrossedEdges[distances_.corners_above(i)];
        const Index behind_exit = kNextCorner[edges.exit];
        Crossed& c = crossed_.emplace_back();
        c.exit = cut_edge(position(edges.exit), d[edges.exit], position(behind_exit), d[behind_exit]).position;
        for (Index corner = 0; corner < 3; ++corner)
            if (same_position(c.exit, position(corner))) return false;
        c.opposite = position(edges.opposite_entry);
        c.slot = slot;
        c.group = leaf.group;
        c.exit_corner = edges.exit;
    }
    return true;
}

/// Which triangle the outline comes to from which. False if it comes to a hole.
bool QuickOutline::find_next(const Universe& u)
{
    // What a triangle leads to is asked for some triangles ahead: its face, then its half-edges.
    constexpr std::size_t kAhead = 8;
    const std::size_t count = crossed_.size();
    for (Crossed& c : crossed_) {
        c.face = u.face_of_slot[c.slot];
        numbers_.add(c.face);
    }
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

void QuickOutline::add_ends(const Universe& u, const Plane& plane, PlaneSection& section) const
{
    std::size_t next = 0;
    for (const PlaneSection::Path& path : section.paths)
        section.for_each_edge(path, [&](std::size_t, const glm::vec3& p, const glm::vec3& q) {
            add_section_ends(plane, {u.vertices.data(), u.vertices.size()}, u.streams, u.slots[traced_[next++]], p, q,
                             section);
        });
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
            if (section.wants_ends) traced_.push_back(from.slot);
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
