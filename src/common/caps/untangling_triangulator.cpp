#include "common/caps/untangling_triangulator.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

#include "common/caps/clipping_triangulator.h"
#include "common/caps/convex_triangulator.h"
#include "common/caps/loop_boxes.h"
#include "common/caps/near_places.h"
#include "common/geometry/turn.h"
#include "common/mesh/plane.h"
#include "common/mesh/plane_noise.h"
#include "common/mesh/tolerances.h"

// Cut points are rounded to float, so a section that comes near to itself may touch or cross itself by a unit in the
// last place: a point lies in another edge, or two edges cross beside a point. Such an edge is led over the point: a
// triangle with (almost) no area is put on it, and its two other edges replace it in the outline. The remaining outline
// has no point inside an edge and no crossings. The idea is that of snap rounding (Hobby 1999, "Practical segment
// intersection with finite precision output"), with the outline's own points in the place of pixels: only edges that do
// meet are touched, and no point is added.
//
// If a surface runs through itself, edges cross far from all points, and a triangle over one of these would cover too
// much. There a point is added at the crossing, and both edges are led over it: the outline keeps its edges, the
// triangles on them have no more area than rounding that point gives them, and the outline behind them is free of
// crossings.
//
// If a plane passes a tip by less than floats can tell apart, thousands of points lie within rounding of one another,
// and edges cross as often as there are pairs of them: leading each over the nearest end makes new crossings for those
// it removes. There all crossings are found at once, in a triangulation whose constraints may cross, and edges are led
// over just those. In large outlines each crowd is first led over one of its points, and edges over the points that
// they pass by within rounding (snap rounding again, of points as well).
//
// A loop that comes back to a point falls into simple loops there. If all run counter-clockwise, each is covered on its own,
// which is quick; holes need the constrained triangulation. That covers a place as often as it is wound around,
// triangle upon triangle; if that takes too many, simple loops are covered on their own after all, with holes turned over.

namespace kerf::core {

namespace {

/// Rounds after which an outline is given up. Rounding errors are gone after one or two.
constexpr int kMostRounds = 32;
constexpr double kAnyShare = std::numeric_limits<double>::infinity();
/// Work that an outline of n points may cost before it is given up, per round and in all.
constexpr std::size_t kMostPairs = 64, kMostLooks = 16, kMostEdges = 4, kSmallOutline = 1024;
/// Points within rounding of one that make a crowd.
constexpr std::size_t kCrowd = 8;
/// Crowded outlines of up to so many points have few crossings, though these grow with the square of the points.
constexpr std::size_t kFewPoints = 1024;
/// Edges that crossings may add in all, beyond kMostEdges a point: some tens of milliseconds.
constexpr std::size_t kMostCrossed = 32768;

class UntanglingTriangulator final : public CapTriangulator
{
public:
    UntanglingTriangulator(std::unique_ptr<CapTriangulator> constrained, std::unique_ptr<RouteFinder> finder)
        : constrained_(std::move(constrained)), finder_(std::move(finder))
    {
    }

    bool triangulate(const CapOutline& outline, CapMesh& cap) override
    {
        cap.clear();
        inner_.steps = 0;
        const bool closed = untangle(outline, cap);
        cap.steps += inner_.steps;
        return closed;
    }

private:
    /// A directed edge of the outline; it ends where the next one of its loop starts.
    struct Edge
    {
        Index from, to;  ///< the first of the points at that position
        CapLink link;    ///< an edge of the outline, or of a triangle that was put on one
    };

    bool untangle(const CapOutline& outline, CapMesh& cap)
    {
        start(outline);
        is_crowded_.reset();
        if (const std::optional<bool> closed = lead_over_ends(cap)) return *closed;
        start_anew(outline, cap);
        // Leading edges over crossings alone costs the least area, if crossings are few.
        if (outline.points.size() <= kFewPoints || !is_crowded()) {
            const std::size_t most_crossings = is_crowded() ? outline.points.size() : most_edges();
            if (lead_along_routes(most_crossings, 0, cap)) return cover_routes(cap);
            start_anew(outline, cap);
        }
        if (!collapse_crowds(cap)) start_anew(outline, cap);
        if (edges_.empty()) return true;  // the whole outline is folded together
        // If many have moved, points crowd at every scale, and each round would add as many edges again.
        const std::size_t most_moved = outline.points.size() / kPointsForMoved;
        return lead_along_routes(most_edges(), most_moved, cap) && cover_routes(cap);
    }

    void start_anew(const CapOutline& outline, CapMesh& cap)
    {
        cap.clear();
        start(outline);
    }

    /// Edges may meet again near crossing points that were rounded or left out. That is looked for only if the edges
    /// cannot be covered.
    bool cover_routes(CapMesh& cap)
    {
        for (int round = 0; round < kMostRounds; ++round) {
            name_points(cap);
            if (cover_simple_loops(cap, kTurnedShare) || cover_with(*constrained_, cap))
                return drop_triangles_between_equals(cap);
            if (!find_meetings() || leads_.empty()) break;
            lead_over(cap);
        }
        return cover_simple_loops(cap, kAnyShare) && drop_triangles_between_equals(cap);
    }

    /// Rounds in which edges are led over ends of others and over points where they cross. Empty if points are too
    /// crowded for that.
    std::optional<bool> lead_over_ends(CapMesh& cap)
    {
        for (int round = 0; round < kMostRounds; ++round) {
            const bool found_all = find_meetings();
            // Many edges side by side are no reason to change them as long as none has been seen to meet another.
            if (!found_all && round == 0 && crossings_.empty() && leads_.empty()) {
                name_points(cap);
                if (cover_with(*constrained_, cap)) return true;
            }
            if (!found_all) return std::nullopt;
            if (leads_.size() > outline_.points.size() && is_crowded()) return std::nullopt;
            if (edges_.size() > most_edges()) return std::nullopt;
            if (leads_.empty()) return cover(cap);
            lead_over(cap);
        }
        return std::nullopt;
    }

    /// Leads edges over all that they meet at once, except points that rounding has moved away from an edge. False if
    /// those or the crossings are too many.
    bool lead_along_routes(std::size_t most_crossings, std::size_t most_moved, CapMesh& cap)
    {
        // Only points where edges end count: crowds are behind other points.
        used_.clear();
        for (const Edge& e : edges_) used_.push_back(e.from);
        std::sort(used_.begin(), used_.end());
        used_.erase(std::unique(used_.begin(), used_.end()), used_.end());
        const auto number = [&](Index point) {
            return static_cast<Index>(std::lower_bound(used_.begin(), used_.end(), point) - used_.begin());
        };
        std::vector<glm::dvec2> places;
        for (const Index point : used_) places.push_back(places_[point]);
        std::vector<std::array<Index, 2>> ends;
        for (const Edge& e : edges_) ends.push_back({number(e.from), number(e.to)});
        routes_.steps = 0;
        // Each edge has two ends on its route; the limit keeps the routes below the product of edges and crossings.
        const std::size_t most_points = ends.size() + 2 * most_edges();
        const bool found = finder_->find(places, ends, most_crossings, most_points, routes_);
        inner_.steps += routes_.steps;
        if (!found) return false;
        const std::size_t n = places_.size();
        crossings_.resize(routes_.added.size());
        for (const glm::dvec2& place : routes_.added) {
            first_at_.push_back(static_cast<Index>(places_.size()));
            used_.push_back(static_cast<Index>(places_.size()));
            places_.push_back(place);
        }
        next_edges_.clear();
        on_path_.assign(places_.size(), kNone);
        std::size_t loop = 0;
        for (Index e = 0; e < edges_.size(); ++e) {
            if (starts_[loop] == e) starts_[loop++] = static_cast<Index>(next_edges_.size());
            route_.clear();
            for (std::size_t i = routes_.starts[e]; i < routes_.starts[e + 1]; ++i) {
                const Index point = used_[routes_.points[i]];
                if (!is_beside(point, edges_[e])) {
                    if (most_moved == 0) return false;
                    --most_moved;
                    continue;  // its edges cross there still
                }
                if (point >= n) place_crossing(edges_[e], point);
                route_.push_back(point);
            }
            straighten_route();
            lead_along_route(edges_[e].link, cap);
        }
        starts_.back() = static_cast<Index>(next_edges_.size());
        edges_.swap(next_edges_);
        return true;
    }

    /// Removes from `route_` everything between two visits to one point. Rounding moves a crossing point past others,
    /// and an edge that runs over it then leads back over itself; a triangle there would have two corners in one point.
    /// `on_path_` holds kNone for all points, before and after.
    void straighten_route()
    {
        std::size_t kept = 0;
        for (const Index point : route_) {
            if (const Index first = on_path_[point]; first != kNone) {
                while (kept > first + 1) on_path_[route_[--kept]] = kNone;
                continue;
            }
            on_path_[point] = static_cast<Index>(kept);
            route_[kept++] = point;
        }
        route_.resize(kept);
        for (const Index point : route_) on_path_[point] = kNone;
    }

    /// Whether rounding could move a point onto an edge: if two edges are practically parallel, it may have moved their
    /// crossing point anywhere.
    bool is_beside(Index point, const Edge& edge) const
    {
        const glm::dvec2 &a = places_[edge.from], &b = places_[edge.to], &p = places_[point];
        const double length = glm::distance(a, b);
        if (!(length > noise_)) return glm::distance(a, p) <= 2.0 * noise_;
        const double along = glm::dot(p - a, b - a) / length;
        return std::abs(turn(a, b, p)) <= noise_ * length && along >= -noise_ && along <= length + noise_;
    }

    /// Gives a crossing point its position in space, on an edge that runs over it.
    void place_crossing(const Edge& edge, Index point)
    {
        const glm::dvec2 &a = places_[edge.from], &b = places_[edge.to], &p = places_[point];
        const int axis = longer_axis(a, b);
        const double share = (p[axis] - a[axis]) / (b[axis] - a[axis]);
        const glm::dvec3 from(position(edge.from)), to(position(edge.to));
        const std::size_t n = outline_.points.size();
        crossings_[point - n] = {glm::vec3(from + share * (to - from)) + 0.0f,
                                 edge.from < n ? edge.from : crossings_[edge.from - n].edge};
    }

    /// Once crossing points are rounded to float, removes triangles that have two corners at one position and joins
    /// their other two edges. Behind the edge between such corners lies another such triangle.
    bool drop_triangles_between_equals(CapMesh& cap)
    {
        const std::size_t n = outline_.points.size();
        std::vector<Index> number(cap.triangles.size());
        Index kept = 0;
        for (Index t = 0; t < cap.triangles.size(); ++t) {
            const std::array<Index, 3> corner = cap.triangles[t].corner;
            const auto ends_are_equal = [&](Index i) {
                const Index a = corner[i], b = corner[(i + 1) % 3];
                return (a >= n || b >= n) && position(a) == position(b);
            };
            std::array<Index, 3> long_edges{};
            std::size_t count = 0;
            for (Index i = 0; i < 3; ++i)
                if (!ends_are_equal(i)) long_edges[count++] = i;
            number[t] = count == 3 ? kept++ : kNone;
            if (count == 3) continue;
            for (const Index i : corner) cap.shared_points.push_back(i);
            if (count == 0) continue;
            const CapLink a = cap.triangles[t].link[long_edges[0]], b = cap.triangles[t].link[long_edges[1]];
            if (a != CapLink::to_triangle(t, long_edges[1])) cap.connect(a, b);
        }
        if (kept == cap.triangles.size()) return true;
        for (Index t = 0; t < number.size(); ++t) {
            if (number[t] == kNone) continue;
            CapTriangle triangle = cap.triangles[t];
            for (CapLink& link : triangle.link)
                if (!link.is_outline()) link = CapLink::to_triangle(number[link.triangle()], link.corner());
            cap.triangles[number[t]] = triangle;
        }
        cap.triangles.resize(kept);
        return true;
    }

    bool cover(CapMesh& cap)
    {
        name_points(cap);
        // Holes turned over are the last resort: they cover twice too often.
        return cover_simple_loops(cap, kTurnedShare) || cover_with(*constrained_, cap) ||
               cover_simple_loops(cap, kAnyShare);
    }

    /// Whether many points lie within rounding of one.
    bool is_crowded()
    {
        if (is_crowded_) return *is_crowded_;
        const std::vector<Index> standing = stand_ins(places_, order_, noise_);
        std::vector<std::size_t> size(standing.size(), 0);
        is_crowded_ = false;
        for (Index i = 0; i < standing.size(); ++i)
            if (first_at_[i] == i && ++size[standing[i]] >= kCrowd) is_crowded_ = true;
        return *is_crowded_;
    }

    /// Leads all edges over the points that stand for their ends and over those that they pass by within rounding;
    /// edges that then run to a point and back are folded together. False if that makes too many edges.
    bool collapse_crowds(CapMesh& cap)
    {
        const std::vector<Index> standing = stand_ins(places_, order_, noise_);
        std::vector<Index> standing_for_others;
        for (const Index i : order_)
            if (standing[i] == i && first_at_[i] == i) standing_for_others.push_back(i);
        tree_.build(places_, std::move(standing_for_others));
        std::vector<Edge> edges;
        std::vector<Index> starts;
        for (std::size_t loop = 0; loop + 1 < starts_.size(); ++loop) {
            const std::size_t first = edges.size();
            // Edges to a point and from it (spikes): at the loop's first point, and at the start of the next edge.
            std::optional<CapLink> first_spike, last_spike;
            for (Index e = starts_[loop]; e < starts_[loop + 1]; ++e) {
                const auto [from, to, link] = edges_[e];
                next_edges_.clear();
                find_route(from, to, standing);
                lead_along_route(link, cap);
                auto begin = next_edges_.begin(), end = next_edges_.end();
                if (from != standing[from]) {
                    if (e == starts_[loop])
                        first_spike = begin->link;
                    else
                        cap.connect(*last_spike, begin->link);
                    ++begin;
                }
                if (to != standing[to]) last_spike = (--end)->link;
                edges.insert(edges.end(), begin, end);
                if (edges.size() > most_edges()) return false;
            }
            if (first_spike) cap.connect(*last_spike, *first_spike);
            if (edges.size() > first) starts.push_back(static_cast<Index>(first));
        }
        starts.push_back(static_cast<Index>(edges.size()));
        edges_.swap(edges);
        starts_.swap(starts);
        for (Index i = 0; i < standing.size(); ++i)
            if (standing[i] != i) {
                cap.shared_points.push_back(i);
                cap.shared_points.push_back(standing[i]);
            }
        return true;
    }

    /// Fills `route_` with an edge's start, the start's stand-in, the places beside the edge, the end's stand-in, and
    /// the end.
    void find_route(Index from, Index to, std::span<const Index> standing)
    {
        const Index first = standing[from], last = standing[to];
        route_.clear();
        if (from != first) route_.push_back(from);
        route_.push_back(first);
        if (first != last) {
            tree_.append_beside(places_[first], places_[last], 0.5 * noise_, route_, inner_.steps);
            std::erase_if(route_, [&](Index i) { return i == last; });
            route_.push_back(last);
        }
        if (to != last) route_.push_back(to);
    }

    /// An edge that is to be led over a point.
    struct Lead
    {
        Index edge;
        /// Position of the point along the longer side of the edge's box, then along the other: orders the points of an
        /// edge without rounding.
        std::array<double, 2> along;
        Index point;

        bool operator<(const Lead& other) const
        {
            return std::tie(edge, along, point) < std::tie(other.edge, other.along, other.point);
        }
    };

    void start(const CapOutline& outline)
    {
        const std::size_t n = outline.points.size();
        outline_ = outline;
        crossings_.clear();
        point_at_.clear();
        float largest_coordinate = 0.0f;
        for (const glm::vec3& p : outline.positions)
            for (int axis = 0; axis < 3; ++axis) largest_coordinate = std::max(largest_coordinate, std::abs(p[axis]));
        noise_ = plane_noise(largest_coordinate);
        places_.assign(outline.points.begin(), outline.points.end());
        order_.resize(n);
        for (Index i = 0; i < n; ++i) order_[i] = i;
        const auto key = [&](Index i) {
            const glm::dvec2& p = outline.points[i];
            const glm::vec3& q = outline.positions[i];
            return std::tie(p.x, p.y, q.x, q.y, q.z);
        };
        std::stable_sort(order_.begin(), order_.end(), [&](Index a, Index b) { return key(a) < key(b); });

        // Points that differ only along the dropped axis are moved apart by less than a float can tell.
        double largest = 0.0;
        for (const glm::dvec2& p : places_) largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
        const double nudge = kNudge * largest;
        first_at_.resize(n);
        int nudges = 0;
        for (std::size_t i = 0; i < n; ++i) {
            const Index now = order_[i], before = i > 0 ? order_[i - 1] : now;
            first_at_[now] = now;
            if (i == 0 || outline.points[before] != outline.points[now])
                nudges = 0;
            else if (outline.positions[before] == outline.positions[now])
                first_at_[now] = first_at_[before];
            else
                ++nudges;
            places_[now].x += nudges * nudge;
        }

        edges_.clear();
        starts_.clear();
        for (Index loop = 0; loop + 1 < outline.loop_starts.size(); ++loop) {
            starts_.push_back(static_cast<Index>(edges_.size()));
            for (Index i = outline.loop_starts[loop]; i < outline.loop_starts[loop + 1]; ++i)
                edges_.push_back({first_at_[i], first_at_[outline.successor(i, loop)], CapLink::to_outline(i)});
        }
        starts_.push_back(static_cast<Index>(edges_.size()));
    }

    std::size_t most_edges() const { return kMostEdges * outline_.points.size() + kMostCrossed; }

    /// Fills `leads_`; false if there are too many pairs to look at, or too many crossings. O(k log k) for outlines
    /// that are near to none.
    bool find_meetings()
    {
        leads_.clear();
        const auto add_edge = [&](std::size_t i, Box2& box) {
            for (const Index end : {edges_[i].from, edges_[i].to}) box.add(places_[end].x, places_[end].y);
        };
        boxes_.build(edges_.size(), add_edge);
        std::size_t pairs_left = kMostPairs * (edges_.size() + kSmallOutline), looks_left = kMostLooks * pairs_left;
        for (Index e = 0; e < edges_.size(); ++e) {
            Box2 box;
            add_edge(e, box);
            const bool too_many = boxes_.any(box, [&](std::size_t f) {
                ++inner_.steps;
                if (--looks_left == 0) return true;
                if (f <= e) return false;
                Box2 other;
                add_edge(f, other);
                if (!box.overlaps(other)) return false;
                meet(e, static_cast<Index>(f));
                // Each crossing makes two edges more.
                return --pairs_left == 0 || 2 * crossings_.size() > most_edges();
            });
            if (too_many || (leads_.size() > outline_.points.size() && is_crowded())) return false;
        }
        return true;
    }

    void meet(Index e, Index f)
    {
        const Index a = edges_[e].from, b = edges_[e].to, c = edges_[f].from, d = edges_[f].to;
        const glm::dvec2 &pa = places_[a], &pb = places_[b], &pc = places_[c], &pd = places_[d];
        const auto on = [&](Index p, Index edge) {
            return p != edges_[edge].from && p != edges_[edge].to && is_between(p, edge);
        };
        const double c_of_e = turn(pa, pb, pc), d_of_e = turn(pa, pb, pd), a_of_f = turn(pc, pd, pa),
                     b_of_f = turn(pc, pd, pb);
        if (c_of_e == 0.0 && on(c, e)) lead(e, c);
        if (d_of_e == 0.0 && on(d, e)) lead(e, d);
        if (a_of_f == 0.0 && on(a, f)) lead(f, a);
        if (b_of_f == 0.0 && on(b, f)) lead(f, b);
        if (a == c || a == d || b == c || b == d) return;
        const auto apart = [](double x, double y) { return (x < 0.0 && y > 0.0) || (x > 0.0 && y < 0.0); };
        if (!apart(c_of_e, d_of_e) || !apart(a_of_f, b_of_f)) return;
        // The nearest of the four ends lies beside the inside of the other edge.
        const double e_length = glm::distance(pa, pb), f_length = glm::distance(pc, pd);
        const std::array<std::pair<double, std::pair<Index, Index>>, 4> ends{{
            {std::abs(c_of_e) / e_length, {e, c}},
            {std::abs(d_of_e) / e_length, {e, d}},
            {std::abs(a_of_f) / f_length, {f, a}},
            {std::abs(b_of_f) / f_length, {f, b}},
        }};
        const auto& nearest = *std::min_element(ends.begin(), ends.end());
        const auto& [edge, point] = nearest.second;
        if (nearest.first <= noise_) {
            lead(edge, point);
        } else {
            const Index crossing = crossing_point(e, a_of_f / (a_of_f - b_of_f));
            for (const Index crossed : {e, f}) lead(crossed, crossing);
        }
    }

    /// The point in `edge` at that share of its length: an existing one, or a new one. It is farther from all ends than
    /// rounding moves it.
    Index crossing_point(Index edge, double share)
    {
        const auto [from, to, link] = edges_[edge];
        const glm::dvec3 a(position(from)), b(position(to));
        const glm::vec3 p = glm::vec3(a + share * (b - a)) + 0.0f;  // -0 does not occur in a mesh
        const glm::dvec2 place(p[outline_.axis_u], p[outline_.axis_v]);
        const auto key = [](const glm::dvec2& q) { return std::array{q.x, q.y}; };
        if (point_at_.empty())
            for (const Index i : order_) point_at_.try_emplace(key(outline_.points[i]), first_at_[i]);
        const Index added = static_cast<Index>(places_.size());
        const auto [entry, is_new] = point_at_.try_emplace(key(place), added);
        if (is_new) {
            const std::size_t n = outline_.points.size();
            crossings_.push_back({p, from < n ? from : crossings_[from - n].edge});
            places_.push_back(place);
            first_at_.push_back(added);
        }
        return entry->second;
    }

    const glm::vec3& position(Index point) const
    {
        const std::size_t n = outline_.positions.size();
        return point < n ? outline_.positions[point] : crossings_[point - n].position;
    }

    /// The axis along which an edge is longer.
    static int longer_axis(const glm::dvec2& a, const glm::dvec2& b)
    {
        return std::abs(b.x - a.x) >= std::abs(b.y - a.y) ? 0 : 1;
    }

    /// Whether a point on the line of an edge lies between its ends.
    bool is_between(Index p, Index edge) const
    {
        const glm::dvec2 &a = places_[edges_[edge].from], &b = places_[edges_[edge].to], &q = places_[p];
        const int axis = longer_axis(a, b);
        return std::min(a[axis], b[axis]) < q[axis] && q[axis] < std::max(a[axis], b[axis]);
    }

    void lead(Index edge, Index point)
    {
        const glm::dvec2 &a = places_[edges_[edge].from], &b = places_[edges_[edge].to], &p = places_[point];
        const int axis = longer_axis(a, b);
        const auto along = [&](int i) { return a[i] <= b[i] ? p[i] : -p[i]; };
        leads_.push_back({edge, {along(axis), along(1 - axis)}, point});
    }

    void lead_over(CapMesh& cap)
    {
        std::sort(leads_.begin(), leads_.end());
        const auto same = [](const Lead& x, const Lead& y) { return x.edge == y.edge && x.point == y.point; };
        leads_.erase(std::unique(leads_.begin(), leads_.end(), same), leads_.end());
        next_edges_.clear();
        auto next = leads_.begin();
        std::size_t loop = 0;
        for (Index e = 0; e < edges_.size(); ++e) {
            // No loop is empty.
            if (starts_[loop] == e) starts_[loop++] = static_cast<Index>(next_edges_.size());
            route_.assign(1, edges_[e].from);
            for (; next != leads_.end() && next->edge == e; ++next) route_.push_back(next->point);
            route_.push_back(edges_[e].to);
            lead_along_route(edges_[e].link, cap);
        }
        starts_.back() = static_cast<Index>(next_edges_.size());
        edges_.swap(next_edges_);
    }

    /// Fills the space between an edge and the points of `route_` with triangles, by halving it: their edges are as
    /// short as possible, and so is their area.
    void lead_along_route(CapLink link, CapMesh& cap)
    {
        struct Span
        {
            std::size_t first, last;
            CapLink link;
        };
        std::vector<Span> spans{{0, route_.size() - 1, link}};
        while (!spans.empty()) {
            const auto [first, last, edge] = spans.back();
            spans.pop_back();
            if (last == first + 1) {
                next_edges_.push_back({route_[first], route_[last], edge});
                continue;
            }
            const std::size_t middle = first + (last - first) / 2;
            const Index t = static_cast<Index>(cap.triangles.size());
            cap.triangles.push_back({{route_[first], route_[last], route_[middle]}});
            cap.connect(CapLink::to_triangle(t, 0), edge);
            // The first half is taken from the stack first.
            spans.push_back({middle, last, CapLink::to_triangle(t, 1)});
            spans.push_back({first, middle, CapLink::to_triangle(t, 2)});
        }
    }

    void name_points(CapMesh& cap)
    {
        cap.crossing_points = crossings_;
        visits_.assign(places_.size(), 0);
        for (const Edge& e : edges_) ++visits_[e.from];
        for (Index i = 0; i < places_.size(); ++i)
            if (visits_[first_at_[i]] > 1) cap.shared_points.push_back(i);
    }

    /// Covers each simple loop on its own, clockwise ones by triangles that are turned over. False, with nothing
    /// covered, if the clockwise ones have more than such a share of the area, or if one loop is too
    /// difficult. O(k log k), however often a place is wound around.
    bool cover_simple_loops(CapMesh& cap, double turned_share)
    {
        split_into_simple_loops();
        double upright = 0.0, turned = 0.0;
        for (std::size_t loop = 0; loop + 1 < simple_starts_.size(); ++loop) {
            const double area = area_of_simple_loop(loop);
            (area > 0.0 ? upright : turned) += std::abs(area);
        }
        if (turned > turned_share * upright) return false;
        const std::size_t triangles = cap.triangles.size(), cancelled = cap.cancelled.size();
        for (std::size_t loop = 0; loop + 1 < simple_starts_.size(); ++loop) {
            const std::span<const Edge> edges(simple_edges_.data() + simple_starts_[loop],
                                              simple_starts_[loop + 1] - simple_starts_[loop]);
            const std::array<Index, 2> ends{0, static_cast<Index>(edges.size())};
            set_points(edges);
            // A mirrored loop runs the other way round; the cover's edges run as the loop's do all the same.
            if (area_of_simple_loop(loop) < 0.0)
                for (glm::dvec2& p : points_) std::swap(p.x, p.y);
            const CapOutline outline{points_, positions_, ends};
            if (!convex_->triangulate(outline, inner_) && !clipping_->triangulate(outline, inner_) &&
                !constrained_->triangulate(outline, inner_)) {
                cap.triangles.resize(triangles);
                cap.cancelled.resize(cancelled);
                return false;
            }
            take_over(edges, cap);
        }
        for (const auto& [a, b] : folds_) cap.connect(a, b);
        return true;
    }

    /// Fills `simple_edges_` with the loops into which the outline falls at points that it comes back to, and `folds_` with
    /// the edges that run forth and straight back.
    void split_into_simple_loops()
    {
        simple_edges_.clear();
        simple_starts_.assign(1, 0);
        folds_.clear();
        on_path_.assign(places_.size(), kNone);
        for (std::size_t loop = 0; loop + 1 < starts_.size(); ++loop) {
            path_.clear();
            for (Index e = starts_[loop]; e < starts_[loop + 1]; ++e) {
                on_path_[edges_[e].from] = static_cast<Index>(path_.size());
                path_.push_back(edges_[e]);
                const Index first = on_path_[edges_[e].to];
                if (first == kNone) continue;
                for (std::size_t i = first; i < path_.size(); ++i) on_path_[path_[i].from] = kNone;
                if (path_.size() - first == 2) {
                    folds_.push_back({path_[first].link, path_[first + 1].link});
                } else {
                    simple_edges_.insert(simple_edges_.end(), path_.begin() + first, path_.end());
                    simple_starts_.push_back(static_cast<Index>(simple_edges_.size()));
                }
                path_.resize(first);
            }
        }
    }

    /// Positive if the simple loop runs counter-clockwise.
    double area_of_simple_loop(std::size_t loop) const
    {
        const glm::dvec2 origin = places_[simple_edges_[simple_starts_[loop]].from];
        double twice = 0.0;
        for (Index i = simple_starts_[loop]; i < simple_starts_[loop + 1]; ++i) {
            const glm::dvec2 a = places_[simple_edges_[i].from] - origin, b = places_[simple_edges_[i].to] - origin;
            twice += a.x * b.y - a.y * b.x;
        }
        return 0.5 * twice;
    }

    bool cover_with(CapTriangulator& way, CapMesh& cap)
    {
        set_points(edges_);
        if (!way.triangulate({points_, positions_, starts_}, inner_)) return false;
        take_over(edges_, cap);
        return true;
    }

    void set_points(std::span<const Edge> edges)
    {
        points_.clear();
        positions_.clear();
        for (const Edge& e : edges) {
            points_.push_back(places_[e.from]);
            positions_.push_back(position(e.from));
        }
    }

    /// Appends `inner_`, a cover of these edges.
    void take_over(std::span<const Edge> edges, CapMesh& cap)
    {
        const Index first = static_cast<Index>(cap.triangles.size());
        for (const CapTriangle& t : inner_.triangles) {
            const auto point = [&](std::size_t i) { return edges[t.corner[i]].from; };
            cap.triangles.push_back({{point(0), point(1), point(2)}});
        }
        for (Index t = 0; t < inner_.triangles.size(); ++t)
            for (Index i = 0; i < 3; ++i) {
                const CapLink link = inner_.triangles[t].link[i];
                cap.connect(CapLink::to_triangle(first + t, i),
                            link.is_outline() ? edges[link.outline_edge()].link
                                              : CapLink::to_triangle(first + link.triangle(), link.corner()));
            }
        for (const auto& [a, b] : inner_.cancelled) cap.connect(edges[a].link, edges[b].link);
        for (const Index i : inner_.shared_points) cap.shared_points.push_back(edges[i].from);
    }

    const std::unique_ptr<CapTriangulator> convex_ = make_convex_triangulator(),
                                           clipping_ = make_clipping_triangulator();
    const std::unique_ptr<CapTriangulator> constrained_;
    const std::unique_ptr<RouteFinder> finder_;
    EdgeRoutes routes_;
    PlaceTree tree_;
    std::vector<Index> used_;
    CapOutline outline_;
    std::optional<bool> is_crowded_;
    double noise_ = 0.0;                               ///< how far rounding can move points, mesh units
    std::vector<CrossingPoint> crossings_;             ///< numbered behind the points of the outline
    std::map<std::array<double, 2>, Index> point_at_;  ///< by place; filled if edges cross far from all ends
    std::vector<glm::dvec2> places_;                   ///< of the points; no two positions at one place
    std::vector<Index> first_at_;                      ///< the first point at the position of each
    std::vector<Index> order_;
    std::vector<Edge> edges_, next_edges_;  ///< loop by loop
    std::vector<Index> starts_;             ///< first edge of each loop, and their number at the end
    std::vector<Lead> leads_;
    std::vector<Index> route_;  ///< the points of an edge that is led over some
    LoopBoxes boxes_;
    std::vector<Edge> path_, simple_edges_;
    std::vector<Index> simple_starts_, visits_;
    std::vector<Index> on_path_;                 ///< by point: its place on the current path
    std::vector<std::array<CapLink, 2>> folds_;  ///< links of the two edges
    std::vector<glm::dvec2> points_;
    std::vector<glm::vec3> positions_;
    CapMesh inner_;  ///< the cover of a simple loop; counts all steps
};

}  // namespace

std::unique_ptr<CapTriangulator> make_untangling_triangulator(std::unique_ptr<CapTriangulator> constrained,
                                                              std::unique_ptr<RouteFinder> finder)
{
    return std::make_unique<UntanglingTriangulator>(std::move(constrained), std::move(finder));
}

}  // namespace kerf::core
