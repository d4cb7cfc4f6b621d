// This file gives CGAL's containers an allocator of its own. All of CGAL that it reads has a namespace of its own, too, so
// that a program with other files that include CGAL has two templates, and not one that is defined in two ways.
#define CGAL kerf_cgal

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include "common/caps/cgal_arena.h"

// The allocator of CGAL's containers (CGAL/memory.h).
#undef CGAL_ALLOCATOR
#define CGAL_ALLOCATOR(T) kerf::core::CapArenaAllocator<T>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <glm/common.hpp>
#include <map>
#include <new>
#include <optional>
#include <tuple>
#include <utility>

#include "common/caps/constrained_triangulator.h"
#include "common/geometry/turn.h"

// The only file that includes CGAL, whose triangulations are under the GPL.

namespace kerf::core {

namespace {

/// Steps that inserting a point may take, and how far points may exceed them, in all and for each point of the outline,
/// before another order is tried.
constexpr std::uint64_t kStepsForPoint = 64, kMostDebt = 4096, kMostDebtForPoint = 4;

/// Triangles for each point of an outline, and in addition. Loops that do not cross need two, or as many as loops lie
/// on one another; a coil around one point needs points times turns, too many for a cap.
constexpr std::size_t kMostLayers = 4, kMostCovered = 32768;

using ExactPredicates = CGAL::Exact_predicates_inexact_constructions_kernel;

/// A predicate that counts how often it is asked. Inlined, counting costs nothing measurable; left to the compiler it
/// costs a twentieth of a triangulation.
template <class Predicate>
class Counted : public Predicate
{
public:
    explicit Counted(std::uint64_t* count) : count_(count) {}

    template <class... Arguments>
    [[gnu::always_inline]] auto operator()(const Arguments&... arguments) const
    {
        ++*count_;
        return Predicate::operator()(arguments...);
    }

private:
    std::uint64_t* count_;
};

/// The predicates by which triangulations walk, flip and locate; cap steps count them. The first 2500 triangles of a
/// walk are not counted: CGAL takes them without exact predicates.
struct Kernel : ExactPredicates
{
    using Orientation_2 = Counted<ExactPredicates::Orientation_2>;
    using Side_of_oriented_circle_2 = Counted<ExactPredicates::Side_of_oriented_circle_2>;

    explicit Kernel(std::uint64_t* count) : steps(count) {}

    Orientation_2 orientation_2_object() const { return Orientation_2(steps); }
    Side_of_oriented_circle_2 side_of_oriented_circle_2_object() const { return Side_of_oriented_circle_2(steps); }

    std::uint64_t* steps;
};

}  // namespace

}  // namespace kerf::core

/// As for the kernel it is based on: walks begin without exact predicates.
template <>
struct CGAL::Triangulation_structural_filtering_traits<kerf::core::Kernel>
    : CGAL::Triangulation_structural_filtering_traits<kerf::core::ExactPredicates>
{
};

namespace kerf::core {

namespace {

/// Makes the triangles around a new constraint Delaunay with a stack of edges. CGAL takes edges to flip from the front
/// of a sorted array, so an outline edge that crosses m edges moves m^2 of them, which no predicate counts: teeth
/// around a tip that the plane passes by cost a hundred times as much as others. CGAL perturbs points on a circle, so
/// the result does not depend on the order.
template <class Triangulation>
class FlippingByStack : public Triangulation
{
public:
    using Triangulation::Triangulation;

protected:
    using Edges = typename Triangulation::List_edges;

    void triangulate_hole(typename Triangulation::List_faces& crossed, Edges& left, Edges& right) override
    {
        Edges added;
        Triangulation::Ctr::triangulate_hole(crossed, left, right, added);
        flips_.assign(added.begin(), added.end());
        while (!flips_.empty()) {
            // A flip may have changed this edge: all edges whose triangles have changed are on the stack again.
            auto [f, i] = flips_.back();
            flips_.pop_back();
            if (!this->is_flipable(f, i)) continue;
            const typename Triangulation::Face_handle g = f->neighbor(i);
            const int j = this->mirror_index(f, i);
            this->flip(f, i);
            for (const auto& [face, edge] : {std::pair(f, i), std::pair(g, j)})
                for (const int wing : {edge, this->cw(edge)}) flips_.emplace_back(face, wing);
        }
    }

private:
    std::vector<typename Triangulation::Edge> flips_;
};

struct FaceInfo
{
    static constexpr int kUnknown = std::numeric_limits<int>::min();
    int winding = kUnknown;
    Index id = kNone;                                        ///< order of the flood
    Index first = kNone;                                     ///< first cap triangle
    std::array<Index, 3> outline_edge{kNone, kNone, kNone};  ///< head of the list of those along edge i
};

using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<Index, Kernel>;
using FaceBase =
    CGAL::Triangulation_face_base_with_info_2<FaceInfo, Kernel, CGAL::Constrained_triangulation_face_base_2<Kernel>>;
using DataStructure = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
using Triangulation = FlippingByStack<CGAL::Constrained_Delaunay_triangulation_2<
    Kernel, DataStructure, CGAL::No_constraint_intersection_requiring_constructions_tag>>;
using FaceHandle = Triangulation::Face_handle;
using VertexHandle = Triangulation::Vertex_handle;

/// Knuth's linear congruential generator: the same numbers on every run and every system. Its high bits are the random
/// ones.
class RandomNumbers
{
public:
    explicit RandomNumbers(std::uint64_t seed) : state_(seed) {}

    std::size_t below(std::size_t bound)
    {
        state_ = state_ * 6364136223846793005ull + 1442695040888963407ull;
        return ((state_ >> 32) * bound) >> 32;
    }

private:
    std::uint64_t state_;
};

/// Method of Fisher and Yates.
void shuffle(std::vector<std::array<Index, 2>>& edges)
{
    RandomNumbers random(edges.size());
    for (std::size_t i = edges.size(); i > 1; --i) std::swap(edges[i - 1], edges[random.below(i)]);
}

/// The order in which points are inserted: numbers of points, with those at one place one after the other.
class InsertionOrder
{
public:
    std::span<const Index> points() const { return order_; }

    /// Insertion in loop order makes long cascades of flips; neighbours on a space-filling curve are found at once.
    /// This is the fastest order for nearly all outlines.
    void along_curve(std::span<const glm::dvec2> points)
    {
        curve_.clear();
        for (Index i = 0; i < points.size(); ++i) curve_.push_back({0, i});
        sort_along_curve(points, curve_);
        order_.clear();
        for (const Place& place : curve_) order_.push_back(place.point);
    }

    /// Any order that depends on where points lie has outlines on which each point takes over the neighbours of the one
    /// before: thousands of cut points around a tip that the plane passes by, practically in one place, and thousands
    /// elsewhere. In random order expected flips are O(n log n) for any points at all. Random rounds, each along the
    /// curve and eight times as large as the one before, keep this bound and the curve's short walks: Amenta, Choi and
    /// Rote, "Incremental constructions con BRIO", 2003. After along_curve().
    void in_rounds(std::span<const glm::dvec2> points)
    {
        refine_cells(points, curve_);
        constexpr std::size_t kGrowth = 8, kFirstRound = 64;
        std::uint32_t last_round = 0;
        for (std::size_t size = points.size(); size > kFirstRound; size /= kGrowth) ++last_round;
        RandomNumbers random(points.size());
        std::array<std::uint32_t, 32> round_start{};
        for (std::size_t i = 0; i < curve_.size(); ++i) {
            std::uint32_t round = last_round;
            if (i > 0 && points[curve_[i].point] == points[curve_[i - 1].point])
                round = curve_[i - 1].key;
            else
                while (round > 0 && random.below(kGrowth) == 0) --round;
            curve_[i].key = round;
            ++round_start[round + 1];
        }
        for (std::size_t round = 1; round < round_start.size(); ++round) round_start[round] += round_start[round - 1];
        for (const auto& [round, i] : curve_) order_[round_start[round]++] = i;
    }

    /// Moves a place that is not in line with the first two to the front. False if there is none.
    bool span_the_plane(std::span<const glm::dvec2> points)
    {
        const glm::dvec2& first = points[order_[0]];
        const auto elsewhere = [&](Index i) { return points[i] != first; };
        const auto second = std::find_if(order_.begin(), order_.end(), elsewhere);
        if (second == order_.end()) return false;
        const auto beside = [&](Index i) { return turn(first, points[*second], points[i]) != 0.0; };
        const auto third = std::find_if(second, order_.end(), beside);
        if (third == order_.end()) return false;
        const glm::dvec2& place = points[*third];
        const auto end = std::find_if(third, order_.end(), [&](Index i) { return points[i] != place; });
        std::rotate(order_.begin(), third, end);
        return true;
    }

private:
    struct Place
    {
        std::uint32_t key;  ///< cell on the curve, then round
        Index point;
    };

    /// Sorts along Hilbert's curve through cells of one size. False if there is only one place.
    static bool sort_along_curve(std::span<const glm::dvec2> points, std::span<Place> run)
    {
        glm::dvec2 lo = points[run.front().point], hi = lo;
        for (const Place& place : run) {
            lo = glm::min(lo, points[place.point]);
            hi = glm::max(hi, points[place.point]);
        }
        const double longest = std::max(hi.x - lo.x, hi.y - lo.y);
        constexpr std::uint32_t kBits = 16;
        const double scale = longest > 0.0 ? ((1u << kBits) - 1) / longest : 0.0;
        for (Place& place : run) {
            const glm::dvec2 cell = (points[place.point] - lo) * scale;
            place.key = hilbert_index(std::uint32_t(cell.x), std::uint32_t(cell.y), kBits);
        }
        std::sort(run.begin(), run.end(), [&](const Place& a, const Place& b) {
            const glm::dvec2 &p = points[a.point], &q = points[b.point];
            return std::tie(a.key, p.x, p.y, a.point) < std::tie(b.key, q.x, q.y, b.point);
        });
        return longest > 0.0;
    }

    /// Orders cells that hold many points along curves of their own: some floats lie a hundred powers of two nearer to
    /// one another than to the rest. The ends of a box lie in different cells of it, so each curve has fewer points
    /// than the one before, and cells 2^-16 as large.
    static void refine_cells(std::span<const glm::dvec2> points, std::span<Place> run)
    {
        constexpr std::size_t kFewPoints = 8;
        for (std::size_t first = 0, last; first < run.size(); first = last) {
            for (last = first + 1; last < run.size() && run[last].key == run[first].key;) ++last;
            const std::span<Place> cell = run.subspan(first, last - first);
            if (cell.size() > kFewPoints && sort_along_curve(points, cell)) refine_cells(points, cell);
        }
    }

    static std::uint32_t hilbert_index(std::uint32_t x, std::uint32_t y, std::uint32_t bits)
    {
        std::uint32_t index = 0;
        for (std::uint32_t s = 1u << (bits - 1); s > 0; s >>= 1) {
            const std::uint32_t right = (x & s) != 0, up = (y & s) != 0;
            index = 4 * index + ((3 * right) ^ up);
            if (up != 0) continue;
            if (right != 0) {
                x = (2 * s - 1) - (x & (2 * s - 1));
                y = (2 * s - 1) - (y & (2 * s - 1));
            }
            std::swap(x, y);
        }
        return index;
    }

    std::vector<Place> curve_;
    std::vector<Index> order_;
};

class ConstrainedTriangulator final : public CapTriangulator
{
public:
    bool triangulate(const CapOutline& outline, CapMesh& cap) override
    {
        order_.along_curve(outline.points);
        std::optional<bool> closed = triangulate_in_order(outline, cap, true);
        if (closed) return *closed;
        order_.in_rounds(outline.points);
        return order_.span_the_plane(outline.points) && *triangulate_in_order(outline, cap, false);
    }

private:
    /// Empty if `may_give_up` and points take too many steps in this order.
    std::optional<bool> triangulate_in_order(const CapOutline& outline, CapMesh& cap, bool may_give_up)
    {
        cap.clear();
        // Each cap has a triangulation of its own: one that ran out of memory half-way can only be destroyed, and reuse
        // would save nothing, since clear() frees all memory.
        const CapArena arena;
        Triangulation triangulation(Kernel(&cap.steps));
        triangulation_ = &triangulation;
        try {
            const std::optional<bool> inserted = insert_points(outline, cap, may_give_up);
            if (!inserted) return std::nullopt;
            if (!*inserted || triangulation.dimension() < 2 || !insert_edges(outline)) return false;
        } catch (const std::bad_alloc&) {
            throw;
        } catch (const std::exception&) {
            // Outline edges that cross one another: Intersection_of_constraints_exception.
            return false;
        }
        if (!flood(cap)) return false;
        link(cap);
        return true;
    }

    /// False if two points in space fall together in the projection.
    std::optional<bool> insert_points(const CapOutline& outline, CapMesh& cap, bool may_give_up)
    {
        vertices_.resize(outline.points.size());
        loops_at_.assign(outline.points.size(), 0);
        FaceHandle hint;
        VertexHandle v;
        const std::uint64_t most_debt = kMostDebt + kMostDebtForPoint * outline.points.size();
        std::uint64_t debt = 0;
        for (const Index i : order_.points()) {
            const glm::dvec2& p = outline.points[i];
            // Points at one place follow one another. CGAL would search around each again to find that it has them.
            if (v == VertexHandle() || outline.points[v->info()] != p) {
                const std::uint64_t before = cap.steps;
                // As long as all points are in line, CGAL looks at all edges for each new one.
                if (triangulation_->dimension() < 2) cap.steps += triangulation_->number_of_vertices();
                v = triangulation_->insert(Kernel::Point_2(p.x, p.y), hint);
                v->info() = i;
                debt += cap.steps - before;
                debt -= std::min(debt, kStepsForPoint);
                if (may_give_up && debt > most_debt) return std::nullopt;
            } else {
                if (outline.positions[v->info()] != outline.positions[i]) return false;
                cap.shared_points.push_back(v->info());
                cap.shared_points.push_back(i);
            }
            vertices_[i] = v;
            ++loops_at_[v->info()];
            hint = v->face();
        }
        return true;
    }

    /// False if an edge passes through a point of the outline, or has no length.
    bool insert_edges(const CapOutline& outline)
    {
        crossed_.clear();
        const bool have_length = for_each_edge(outline, [&](Index i, Index j) {
            const auto [from, to] = from_fewer_loops(i, j);
            // CGAL would look for the way from a point to itself.
            if (vertices_[from] == vertices_[to]) return false;
            FaceHandle f;
            int edge;
            if (triangulation_->is_edge(vertices_[from], vertices_[to], f, edge))
                triangulation_->insert_constraint(vertices_[from], vertices_[to]);
            else
                crossed_.push_back({from, to});
            return true;
        });
        if (!have_length) return false;
        // The triangles that an edge crosses are made anew. In the order of a loop that can be half of the
        // triangulation, edge after edge (teeth that lean over one another). In random order earlier edges shield later
        // ones: O(n log^2 n) expected. Shewchuk and Brown, "Fast segment insertion and incremental construction of
        // constrained Delaunay triangulations", 2015.
        shuffle(crossed_);
        for (const auto& [i, j] : crossed_) triangulation_->insert_constraint(vertices_[i], vertices_[j]);
        next_along_.assign(vertices_.size(), kNone);
        return for_each_edge(outline, [&](Index i, Index j) {
            FaceHandle f;
            int edge;
            const auto [from, to] = from_fewer_loops(i, j);
            if (!triangulation_->is_edge(vertices_[from], vertices_[to], f, edge)) return false;
            next_along_[i] = f->info().outline_edge[std::size_t(edge)];
            f->info().outline_edge[std::size_t(edge)] = i;
            const FaceHandle g = f->neighbor(edge);
            g->info().outline_edge[std::size_t(triangulation_->mirror_index(f, edge))] = i;
            return true;
        });
    }

    /// The ends of an edge, first the one that fewer loops run through: CGAL looks for the other end around it, and
    /// thousands of edges meet where thousands of loops do.
    std::array<Index, 2> from_fewer_loops(Index i, Index j) const
    {
        return loops_at_[vertices_[i]->info()] <= loops_at_[vertices_[j]->info()] ? std::array{i, j} : std::array{j, i};
    }

    template <class Visit>
    static bool for_each_edge(const CapOutline& outline, Visit visit)
    {
        for (Index loop = 0; loop + 1 < outline.loop_starts.size(); ++loop)
            for (Index i = outline.loop_starts[loop]; i < outline.loop_starts[loop + 1]; ++i)
                if (!visit(i, outline.successor(i, loop))) return false;
        return true;
    }

    /// True if edge i of the outline runs with face f on its left along edge `edge`.
    bool leaves_on_left(Index i, FaceHandle f, int edge) const { return vertices_[i] == f->vertex(f->ccw(edge)); }

    /// False if the cap would need too many triangles, because loops wind around places too often.
    bool flood(CapMesh& cap)
    {
        const std::size_t most = kMostLayers * vertices_.size() + kMostCovered;
        queue_.clear();
        const auto reach = [&](FaceHandle f, int winding) {
            f->info().winding = winding;
            f->info().id = static_cast<Index>(queue_.size());
            queue_.push_back(f);
        };
        reach(triangulation_->infinite_face(), 0);
        for (std::size_t at = 0; at < queue_.size(); ++at) {
            const FaceHandle f = queue_[at];
            const int winding = f->info().winding;
            if (winding != 0) {
                f->info().first = static_cast<Index>(cap.triangles.size());
                const Index a = f->vertex(0)->info(), b = f->vertex(1)->info(), c = f->vertex(2)->info();
                if (winding != 1)
                    for (const Index i : {a, b, c}) cap.shared_points.push_back(i);
                if (cap.triangles.size() + std::size_t(std::abs(winding)) > most) return false;
                for (int copy = 0; copy < std::abs(winding); ++copy)
                    if (winding > 0)
                        cap.triangles.push_back({{a, b, c}});
                    else
                        cap.triangles.push_back({{a, c, b}});
            }
            for (int edge = 0; edge < 3; ++edge) {
                const FaceHandle g = f->neighbor(edge);
                if (g->info().winding != FaceInfo::kUnknown) continue;
                int across = winding;
                for (Index i = f->info().outline_edge[std::size_t(edge)]; i != kNone; i = next_along_[i])
                    across += leaves_on_left(i, f, edge) ? -1 : 1;
                reach(g, across);
            }
        }
        return true;
    }

    /// Pairs the half-edges along each edge: those of cap triangles on both sides and those of the outline.
    void link(CapMesh& cap)
    {
        for (const FaceHandle f : queue_)
            for (int edge = 0; edge < 3; ++edge) {
                const FaceHandle g = f->neighbor(edge);
                if (f->info().id > g->info().id) continue;
                const Index first = f->info().outline_edge[std::size_t(edge)];
                if (f->info().winding == 0 && g->info().winding == 0 && first == kNone) continue;
                // `along` holds half-edges with f on their left, `against` those with g on their left; an outline edge
                // counts as the surface's half-edge, which runs against it.
                along_.clear();
                against_.clear();
                for (Index i = first; i != kNone; i = next_along_[i])
                    if (leaves_on_left(i, f, edge)) against_.push_back(CapLink::to_outline(i));
                append_copies(f, edge, along_, against_);
                append_copies(g, triangulation_->mirror_index(f, edge), against_, along_);
                for (Index i = first; i != kNone; i = next_along_[i])
                    if (!leaves_on_left(i, f, edge)) along_.push_back(CapLink::to_outline(i));
                for (std::size_t i = 0; i < along_.size() && i < against_.size(); ++i)
                    cap.connect(along_[i], against_[i]);
            }
    }

    static void append_copies(FaceHandle f, int edge, std::vector<CapLink>& left, std::vector<CapLink>& right)
    {
        // Edge `edge` of a face starts at corner edge + 1; in a triangle turned over it has another number.
        static constexpr std::array<Index, 3> kUpright{1, 2, 0}, kTurned{1, 0, 2};
        const int winding = f->info().winding;
        for (int copy = 0; copy < std::abs(winding); ++copy) {
            const Index t = f->info().first + static_cast<Index>(copy);
            if (winding > 0)
                left.push_back(CapLink::to_triangle(t, kUpright[std::size_t(edge)]));
            else
                right.push_back(CapLink::to_triangle(t, kTurned[std::size_t(edge)]));
        }
    }

    Triangulation* triangulation_ = nullptr;  // of the cap under way
    InsertionOrder order_;
    std::vector<VertexHandle> vertices_;
    std::vector<Index> loops_at_;                // by a vertex's point: points of the outline that lie there
    std::vector<std::array<Index, 2>> crossed_;  // ends of outline edges that are no edges yet
    std::vector<Index> next_along_;
    std::vector<FaceHandle> queue_;
    std::vector<CapLink> along_, against_;
};

/// Edges are constraints of a triangulation in which constraints may cross. Predicates are exact; the point where two
/// constraints cross is rounded to double, and both then run over that point.
class CgalRouteFinder final : public RouteFinder
{
public:
    bool find(std::span<const glm::dvec2> places, std::span<const std::array<Index, 2>> edges, std::size_t most_added,
              std::size_t most_points, EdgeRoutes& routes) override
    {
        routes.points.clear();
        routes.starts.assign(1, 0);
        routes.added.clear();
        order_.along_curve(places);
        order_.in_rounds(places);
        if (!order_.span_the_plane(places)) return false;
        const CapArena arena;
        try {
            return find_within(places, edges, places.size() + most_added, most_points, routes);
        } catch (const std::bad_alloc&) {
            throw;
        } catch (const std::exception&) {
            return false;
        }
    }

private:
    struct Number
    {
        Index value = kNone;
    };
    using Vertices = CGAL::Triangulation_vertex_base_with_info_2<Number, Kernel>;
    using Faces = CGAL::Constrained_triangulation_face_base_2<Kernel>;
    using Constraints = FlippingByStack<CGAL::Constrained_Delaunay_triangulation_2<
        Kernel, CGAL::Triangulation_data_structure_2<Vertices, Faces>, CGAL::Exact_predicates_tag>>;

    /// Records where constraints were divided: where they cross, and where they run over a vertex. (So does CGAL's
    /// Constrained_triangulation_plus_2, but it cannot be destroyed once it has run out of memory.)
    class Crossing final : public Constraints
    {
    public:
        Crossing(const Kernel& kernel, Index places) : Constraints(kernel), next_(places) {}

        /// As insert_constraint(), but records where the edge is divided.
        void insert_edge(Vertex_handle from, Vertex_handle to)
        {
            std::vector<std::array<Vertex_handle, 2>> left{{from, to}};
            while (!left.empty()) {
                auto [a, b] = left.back();
                left.pop_back();
                // CGAL looks all around the first end; if most edges meet in it, that is a loop over all of them.
                if (has_fewer_edges(b, a)) std::swap(a, b);
                Vertex_handle v;
                Face_handle face;
                int edge = 0;
                if (includes_edge(a, b, v, face, edge)) {
                    mark_constraint(face, edge);
                } else {
                    List_faces crossed;
                    List_edges on_left, on_right;
                    if (find_intersected_faces(a, b, crossed, on_left, on_right, v)) {
                        // If the edge runs over its own end, the edge found is gone by now.
                        if (v == a || v == b) {
                            left.push_back({a, b});
                        } else {
                            divide(a, b, v);
                            left.push_back({v, b});
                            left.push_back({a, v});
                        }
                        continue;
                    }
                    triangulate_hole(crossed, on_left, on_right);
                }
                if (v == b) continue;
                divide(a, b, v);
                left.push_back({v, b});
            }
        }

        /// Appends the vertices from a to b, without a. False if they cannot be told, or are too many.
        bool append_route(Vertex_handle a, Vertex_handle b, std::vector<Index>& route, std::size_t most_points) const
        {
            std::vector<std::array<Vertex_handle, 2>> left{{a, b}};
            for (std::size_t most = kMostOnRoute; !left.empty(); --most) {
                if (most == 0 || route.size() >= most_points) return false;
                const auto [from, to] = left.back();
                left.pop_back();
                const auto split = split_at_.find(key(from, to));
                Vertex_handle middle;
                Face_handle face;
                int edge = 0;
                if (split != split_at_.end() && split->second != from && split->second != to) {
                    middle = split->second;
                } else if (has_fewer_edges(to, from) ? is_edge(to, from, face, edge) : is_edge(from, to, face, edge)) {
                    route.push_back(to->info().value);
                    continue;
                } else {
                    return false;
                }
                left.push_back({middle, to});
                left.push_back({from, middle});
            }
            return true;
        }

    protected:
        Vertex_handle intersect(Face_handle face, int edge, Vertex_handle a, Vertex_handle b) override
        {
            const Vertex_handle c = face->vertex(cw(edge)), d = face->vertex(ccw(edge));
            const Vertex_handle v = insert_intersection(face, edge, a, b, c, d, a->point(), b->point(), c->point(),
                                                        d->point(), Intersection_tag());
            if (v == c || v == d) {
                insert_edge(c, d);
            } else {
                divide(c, d, v);
                insert_edge(c, v);
                insert_edge(v, d);
            }
            return v;
        }

        /// Rounding can move the point where two edges cross exactly onto a third.
        Vertex_handle virtual_insert(const Point& place, Face_handle start) override
        {
            Locate_type type;
            int edge = 0;
            const Face_handle face = locate(place, type, edge, start);
            if (type != Constraints::EDGE || !face->is_constrained(edge)) return insert(place, type, face, edge);
            const Vertex_handle a = face->vertex(cw(edge)), b = face->vertex(ccw(edge));
            const Vertex_handle v = insert(place, type, face, edge);
            divide(a, b, v);
            return v;
        }

    private:
        /// A limit that no edge reaches: it ends a chain of divisions that leads back to itself.
        static constexpr std::size_t kMostOnRoute = std::size_t{1} << 20;

        static std::array<Index, 2> key(Vertex_handle a, Vertex_handle b)
        {
            return {std::min(a->info().value, b->info().value), std::max(a->info().value, b->info().value)};
        }

        /// O(edges at the one that has fewer).
        bool has_fewer_edges(Vertex_handle a, Vertex_handle b) const
        {
            const auto at_a = incident_vertices(a), at_b = incident_vertices(b);
            auto of_a = at_a, of_b = at_b;
            do {
                if (++of_b == at_b) return false;
            } while (++of_a != at_a);
            return true;
        }

        /// Records that the edge from a to b runs over v, which may be new.
        void divide(Vertex_handle a, Vertex_handle b, Vertex_handle v)
        {
            if (v->info().value == kNone) v->info().value = next_++;
            split_at_[key(a, b)] = v;
        }

        std::map<std::array<Index, 2>, Vertex_handle> split_at_;
        Index next_;
    };

    bool find_within(std::span<const glm::dvec2> places, std::span<const std::array<Index, 2>> edges,
                     std::size_t most_vertices, std::size_t most_points, EdgeRoutes& routes)
    {
        Crossing triangulation(Kernel(&routes.steps), static_cast<Index>(places.size()));
        std::vector<Crossing::Vertex_handle> vertices(places.size());
        Crossing::Face_handle hint;
        Crossing::Vertex_handle v;
        for (const Index i : order_.points()) {
            const glm::dvec2& p = places[i];
            // Equal places follow one another. CGAL has no constraint between a vertex and itself.
            if (v != Crossing::Vertex_handle() && places[v->info().value] == p) return false;
            v = triangulation.insert(Kernel::Point_2(p.x, p.y), hint);
            v->info().value = i;
            vertices[i] = v;
            hint = v->face();
        }
        // If many edges meet in one place, many may join the same two places.
        std::vector<std::array<Index, 2>> constraints;
        for (const auto& [from, to] : edges) {
            if (from == to) return false;
            constraints.push_back({std::min(from, to), std::max(from, to)});
        }
        std::sort(constraints.begin(), constraints.end());
        constraints.erase(std::unique(constraints.begin(), constraints.end()), constraints.end());
        shuffle(constraints);
        for (const auto& [a, b] : constraints) {
            triangulation.insert_edge(vertices[a], vertices[b]);
            if (triangulation.number_of_vertices() > most_vertices) return false;
        }
        routes.added.resize(triangulation.number_of_vertices());
        std::size_t added = 0;
        for (auto it = triangulation.finite_vertices_begin(); it != triangulation.finite_vertices_end(); ++it)
            if (it->info().value >= places.size()) {
                if (it->info().value == kNone) return false;
                routes.added[it->info().value - places.size()] = {it->point().x(), it->point().y()};
                ++added;
            }
        routes.added.resize(added);
        for (const auto& [from, to] : edges) {
            routes.points.push_back(from);
            if (!triangulation.append_route(vertices[from], vertices[to], routes.points, most_points)) return false;
            routes.starts.push_back(routes.points.size());
        }
        return true;
    }

    InsertionOrder order_;
};

constexpr ConstrainedWays kCgalWays{
    []() -> std::unique_ptr<CapTriangulator> { return std::make_unique<ConstrainedTriangulator>(); },
    []() -> std::unique_ptr<RouteFinder> { return std::make_unique<CgalRouteFinder>(); }};

/// In place before main() begins.
[[maybe_unused]] const bool are_in_place = [] {
    use_constrained_ways(&kCgalWays);
    return true;
}();

}  // namespace

}  // namespace kerf::core

/// By this name linkers are told to take this file (`-u`), which nothing else refers to. Shown by shared libraries of Kerf
/// alone: if one of somebody's showed it, linkers would take that for this, and leave this file out of the program.
extern "C" const int kerf_component_caps_cgal;
extern "C" const int kerf_component_caps_cgal = 1;
