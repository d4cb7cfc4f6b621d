#include "halfedge/cut/quick_outline.h"

#include <algorithm>
#include <array>
#include <bit>

#include "common/cutting/cut_geometry.h"
#include "common/cutting/section_ends.h"
#include "halfedge/cut/edges_in_plane.h"

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

constexpr std::array<std::uint8_t, 3> kNextCorner{1, 2, 0};

HalfedgeId halfedge_from(const SurfaceMesh& mesh, FaceId face, std::size_t corner)
{
    HalfedgeId h = mesh.halfedge_of(face);
    for (std::size_t c = 0; c < corner; ++c) h = mesh.next(h);
    return h;
}

}  // namespace

void QuickOutline::clear()
{
    numbers_.clear();
    leaves_.clear();
    edges_.clear();
    in_plane_.clear();
    beginning_.clear();
    ending_.clear();
    ends_at_corners_ = 0;
    keeps_triangles_ = {};
    traced_.clear();
}

bool QuickOutline::find(const Universe& u, const std::vector<ShellRoot>& shells, const Plane& plane,
                        PlaneSection& section)
{
    clear();
    const std::uint64_t nodes_before = section.nodes_visited;
    const bool is_found =
        find_edges(u, shells, plane, section) && find_next(u) && (trace(u, section) || divide(u, plane, section));
    if (!is_found) {
        section.clear();
        section.nodes_visited = nodes_before;
        return false;
    }
    if (section.wants_ends) add_ends(u, plane, section);
    section.crossing_triangles = crossing_;
    section.status = Status::done;
    return true;
}

/// FIND: crossing triangles, then edges in the plane, both in the order of the tree. False if a cut point lies on the corner
/// across, or if there is none of both.
bool QuickOutline::find_edges(const Universe& u, const std::vector<ShellRoot>& shells, const Plane& plane,
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
    crossing_ = edges_.size();
    for (const InPlane& e : in_plane_) {
        const auto number = static_cast<Index>(edges_.size());
        beginning_.push_back({e.start, number});
        ending_.push_back({e.end, number});
        edges_.push_back(e.edge);
    }
    return !edges_.empty();
}

bool QuickOutline::open_leaf(const Universe& u, const Plane& plane, const Node& leaf, const VertexPrefetch& ahead)
{
    for (std::uint32_t i = 0; i < leaf.count; ++i) ahead.step(i);
    distances_.find(plane, {u.vertices.data(), u.vertices.size()}, {&u.slots[leaf.first], leaf.count});
    const LeafDistances::Masks masks = distances_.masks(leaf.count);
    for (std::uint64_t crossing = masks.crossing; crossing != 0; crossing &= crossing - 1) {
        const auto i = static_cast<Index>(std::countr_zero(crossing));
        const SlotId slot = leaf.first + i;
        __builtin_prefetch(&u.face_of_slot[slot]);
        const bool is_clear = distances_.is_on(i) ? add_crossing_at_corner(u, slot, i) : add_crossing(u, slot, i);
        if (!is_clear) return false;
        edges_.back().slot = slot;
        edges_.back().group = leaf.group;
    }
    keeps_triangles_[Side::positive] |= (masks.above & ~masks.crossing) != 0;
    keeps_triangles_[Side::negative] |= std::popcount(masks.above | masks.crossing | masks.on) < int(leaf.count);
    for (std::uint64_t on = masks.on & ~masks.crossing; on != 0; on &= on - 1) {
        const auto i = static_cast<Index>(std::countr_zero(on));
        add_edges_in_plane(u, plane, leaf.first + i, i, leaf.group);
    }
    return true;
}

/// By the edge that begins at a corner, which leads up. False if the outline meets it at the corner across.
inline bool QuickOutline::leave_by_edge(const Universe& u, const Triangle& t, const std::array<double, 3>& d,
                                        std::uint8_t from, Edge& e)
{
    const auto position = [&](std::size_t corner) -> const glm::vec3& { return u.vertices[t[corner]].position; };
    const std::uint8_t to = kNextCorner[from];
    e.exit_corner = from;
    e.end = cut_edge(position(from), d[from], position(to), d[to]).position;
    if (same_position(e.end, position(from))) e.end_corner = from;
    if (same_position(e.end, position(to))) e.end_corner = to;
    return !same_position(e.end, position(kNextCorner[to]));
}

/// Through a triangle with no corner on the plane. False if it ends at the corner across, which only happens to triangles
/// without a width.
bool QuickOutline::add_crossing(const Universe& u, SlotId slot, Index triangle)
{
    const Triangle& t = u.slots[slot];
    const CrossedEdges crossed = kCrossedEdges[distances_.corners_above(triangle)];
    Edge& e = edges_.emplace_back();
    e.opposite = u.vertices[t[crossed.opposite_entry]].position;
    return leave_by_edge(u, t, distances_.of(triangle), crossed.exit, e);
}

/// Through a triangle with one corner on the plane: it comes or goes by that corner. False as above.
bool QuickOutline::add_crossing_at_corner(const Universe& u, SlotId slot, Index triangle)
{
    const std::array<double, 3> d = distances_.of(triangle);
    const auto corner = static_cast<std::uint8_t>(std::find(d.begin(), d.end(), 0.0) - d.begin());
    const std::uint8_t across = kNextCorner[corner];
    const PointId point = u.mesh.from(halfedge_from(u.mesh, u.face_of_slot[slot], corner));
    const auto number = static_cast<Index>(edges_.size());
    Edge& e = edges_.emplace_back();
    if (d[across] > 0.0) {
        // The edge across leads down: the outline enters by it.
        e.end = e.opposite = u.mesh.position(point);
        ending_.push_back({point, number});
        return true;
    }
    e.opposite = u.vertices[u.slots[slot][across]].position;
    beginning_.push_back({point, number});
    return leave_by_edge(u, u.slots[slot], d, across, e);
}

void QuickOutline::add_edges_in_plane(const Universe& u, const Plane& plane, SlotId slot, Index triangle, GroupId group)
{
    const std::array<double, 3> d = distances_.of(triangle);
    const Side side = kept_side(u, plane, slot, d);
    for_each_edge_in_plane(u, plane, slot, side, d, [&](const EdgeInPlane& e) {
        if (e.is_flush || side == Side::positive) return;
        // As it runs in the surface of the positive side.
        InPlane& found = in_plane_.emplace_back();
        found.start = u.mesh.to(e.halfedge);
        found.end = u.mesh.from(e.halfedge);
        const FaceId face = u.face_of_slot[slot];
        found.edge.end = found.edge.opposite = u.mesh.position(found.end);
        found.edge.slot = slot;
        found.edge.face = u.source_of_face[e.across] < u.source_of_face[face] ? e.across : face;
        found.edge.group = group;
        found.edge.exit_corner = static_cast<std::uint8_t>(e.corner);
    });
}

/// Which edge begins where one ends, or at which corner. False if it comes to a hole.
bool QuickOutline::find_next(const Universe& u)
{
    // What a triangle leads to is asked for some triangles ahead: its face, then its half-edges.
    constexpr std::size_t kAhead = 8;
    for (std::size_t i = 0; i < crossing_; ++i) {
        edges_[i].face = u.face_of_slot[edges_[i].slot];
        __builtin_prefetch(&u.source_of_face[edges_[i].face]);
        numbers_.add(edges_[i].face);
    }
    for (std::size_t i = 0; i < crossing_; ++i) {
        if (i + 2 * kAhead < crossing_) u.mesh.prefetch(edges_[i + 2 * kAhead].face);
        if (i + kAhead < crossing_) u.mesh.prefetch(u.mesh.halfedge_of(edges_[i + kAhead].face));
        Edge& e = edges_[i];
        if (e.exit_corner == kNoCorner) continue;
        const HalfedgeId exit = halfedge_from(u.mesh, e.face, e.exit_corner);
        const FaceId beyond = u.mesh.face(opposite(exit));
        if (!beyond.is_valid()) return false;
        const Index next = numbers_.of(beyond);
        if (next == kNone) return false;
        if (e.end_corner == kNoCorner) {
            e.next = next;
            continue;
        }
        const PointId corner = e.end_corner == e.exit_corner ? u.mesh.from(exit) : u.mesh.to(exit);
        e.end = u.mesh.position(corner);
        ending_.push_back({corner, static_cast<Index>(i)});
        beginning_.push_back({corner, next});
        ++ends_at_corners_;
    }
    return true;
}

void QuickOutline::add_ends(const Universe& u, const Plane& plane, PlaneSection& section) const
{
    std::size_t at = 0;
    for (const PlaneSection::Path& path : section.paths)
        section.for_each_edge(path, [&](std::size_t, const glm::vec3& p, const glm::vec3& q) {
            const Index number = traced_[at++];
            const Edge& e = edges_[number];
            Triangle corners = u.slots[e.slot];
            if (number >= crossing_) {
                const Index start = corners[kNextCorner[e.exit_corner]], end = corners[e.exit_corner];
                corners = {start, end, end};
            }
            add_section_ends(plane, {u.vertices.data(), u.vertices.size()}, u.streams, corners, p, q, section);
        });
}

/// The loops of an outline of which no two points coincide, each from the first of its edges on. False if two do, or if a
/// loop runs forth and back over two edges.
bool QuickOutline::trace(const Universe& u, PlaneSection& section)
{
    constexpr std::size_t kBackToBack = 2;
    if (!beginning_.empty() || !ending_.empty()) return false;
    section.points.reserve(edges_.size());
    section.edges.reserve(edges_.size());
    for (Index start = 0; start < edges_.size(); ++start) {
        if (edges_[start].is_passed) continue;
        PlaneSection::Path path;
        path.first_point = section.points.size();
        path.first_edge = section.edges.size();
        path.solid = u.group(edges_[start].group).solid;
        for (Index at = start; !edges_[at].is_passed;) {
            Edge& from = edges_[at];
            const Edge& to = edges_[from.next];
            // The point lies on the edge by which `to` enters its triangle, too.
            if (same_position(from.end, to.end) || same_position(from.end, to.opposite)) return false;
            section.points.push_back(from.end);
            add_edge(u, at, section);
            from.is_passed = true;
            at = from.next;
        }
        path.point_count = path.edge_count = section.points.size() - path.first_point;
        if (path.point_count <= kBackToBack) return false;
        // Edge i starts at point i, which is where the one before ends.
        std::rotate(section.points.begin() + static_cast<std::ptrdiff_t>(path.first_point), section.points.end() - 1,
                    section.points.end());
        section.paths.push_back(path);
    }
    return true;
}

void QuickOutline::add_edge(const Universe& u, Index number, PlaneSection& section)
{
    const Edge& e = edges_[number];
    section.edges.push_back({u.source_of_face[e.face], u.group(e.group).material});
    if (section.wants_ends) traced_.push_back(number);
}

/// The loops of one of which some do, as a cut divides it. False if it comes from a hole, or if nothing may be left on a side.
bool QuickOutline::divide(const Universe& u, const Plane& plane, PlaneSection& section)
{
    section.points.clear();
    section.edges.clear();
    section.paths.clear();
    traced_.clear();
    if (!list_outline(u)) return false;
    leave_out_pairs();
    solids_.clear();
    for (const Index number : number_) solids_.push_back(u.group(edges_[number].group).solid);
    const DividedOutline& divided = divider_.divide(plane, points_, outline_, solids_);
    for (const OutlinePath& from : divided.paths) {
        if (!from.closed) return false;
        section.paths.push_back({section.points.size(), from.count, section.edges.size(), from.count,
                                 u.group(edges_[number_[divided.edges[from.first]]].group).solid});
        for (std::size_t i = from.first; i < from.first + from.count; ++i) {
            section.points.push_back(points_[outline_[divided.edges[i]].from]);
            add_edge(u, number_[divided.edges[i]], section);
        }
    }
    return true;
}

/// Lists points and edges, but no edge that begins where it ends. False as above.
bool QuickOutline::list_outline(const Universe& u)
{
    corners_.clear();
    for (const AtCorner& end : ending_) corners_.push_back(end.corner);
    for (const AtCorner& begin : beginning_) corners_.push_back(begin.corner);
    const auto by_number = [](PointId a, PointId b) { return a.idx() < b.idx(); };
    std::sort(corners_.begin(), corners_.end(), by_number);
    corners_.erase(std::unique(corners_.begin(), corners_.end()), corners_.end());
    const std::size_t count = edges_.size();
    const auto place_of = [&](PointId corner) {
        return static_cast<Index>(count) +
               static_cast<Index>(std::lower_bound(corners_.begin(), corners_.end(), corner, by_number) -
                                  corners_.begin());
    };
    points_.clear();
    outline_.assign(count, {kNone, kNone});
    for (Index i = 0; i < count; ++i) {
        const Edge& e = edges_[i];
        points_.push_back(e.end);
        outline_[i].source = u.source_of_face[e.face];
        outline_[i].to = i;
        if (e.next != kNone) outline_[e.next].from = i;
    }
    for (const PointId corner : corners_) points_.push_back(u.mesh.position(corner));
    for (const AtCorner& begin : beginning_) outline_[begin.edge].from = place_of(begin.corner);
    for (const AtCorner& end : ending_) outline_[end.edge].to = place_of(end.corner);
    number_.clear();
    std::size_t collapsed = 0;
    for (Index i = 0; i < count; ++i) {
        const OutlineEdge e = outline_[i];
        if (e.from == kNone || same_position(points_[e.from], edges_[i].opposite)) return false;
        if (e.from == e.to) continue;
        if (same_position(points_[e.from], points_[e.to])) {
            unite(e.from, e.to, collapsed++ == 0);
            continue;
        }
        outline_[number_.size()] = e;
        number_.push_back(i);
    }
    outline_.resize(number_.size());
    if (collapsed > 0) take_representatives();
    // Something is kept on both sides at an edge in the plane, and of a triangle with two cut points, none of them a corner.
    return !in_plane_.empty() || crossing_ > 2 * ends_at_corners_ + collapsed ||
           (keeps_triangles_[Side::negative] && keeps_triangles_[Side::positive]);
}

/// Makes one of the points of a triangle that coincide.
void QuickOutline::unite(Index a, Index b, bool is_first)
{
    if (is_first) {
        classes_.clear();
        for (std::size_t i = 0; i < points_.size(); ++i) classes_.add();
    }
    classes_.unite(a, b);
}

/// Edges lead between what stands for their points.
void QuickOutline::take_representatives()
{
    std::size_t kept = 0;
    for (std::size_t i = 0; i < outline_.size(); ++i) {
        OutlineEdge e = outline_[i];
        e.from = classes_.find(e.from);
        e.to = classes_.find(e.to);
        if (e.from == e.to) continue;
        outline_[kept] = e;
        number_[kept++] = number_[i];
    }
    outline_.resize(kept);
    number_.resize(kept);
}

/// Leaves out pairs of edges that run forth and back.
void QuickOutline::leave_out_pairs()
{
    const auto pairs = opposite_.find(points_.size(), outline_);
    if (pairs.empty()) return;
    for (const auto& pair : pairs)
        for (const Index i : pair) number_[i] = kNone;
    std::size_t kept = 0;
    for (Index i = 0; i < outline_.size(); ++i) {
        if (number_[i] == kNone) continue;
        outline_[kept] = outline_[i];
        number_[kept++] = number_[i];
    }
    outline_.resize(kept);
    number_.resize(kept);
}

}  // namespace kerf::core::halfedge
