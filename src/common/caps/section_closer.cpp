#include "common/caps/section_closer.h"

#include <algorithm>
#include <cmath>

#include "common/caps/clipping_triangulator.h"
#include "common/caps/constrained_triangulator.h"
#include "common/caps/convex_triangulator.h"
#include "common/caps/flip_edges.h"
#include "common/caps/morton.h"
#include "common/caps/nested_triangulator.h"
#include "common/caps/topological_triangulator.h"
#include "common/caps/untangling_triangulator.h"
#include "common/geometry/dominant_axis.h"
#include "common/support/order_by.h"

namespace kerf::core {

namespace {

/// With fewer cap triangles, sorting by comparisons is faster than by counting to 1024 twice: 0.1 us and 1 us for 6, the
/// same for about 55.
constexpr std::size_t kFewTriangles = 48;

}  // namespace

SectionCloser::SectionCloser()
    : ways_{make_convex_triangulator(),
            make_clipping_triangulator(),
            make_nested_triangulator(),
            make_constrained_triangulator(),
            make_untangling_triangulator(make_constrained_triangulator(), make_route_finder()),
            make_topological_triangulator()}
{
}

std::span<const SectionCloser::Way> SectionCloser::ways_of(CapQuality quality)
{
    static constexpr std::array kFast{convex, clipping, nested, untangling, topological};
    // What crosses or touches itself is untangled first, and closed by the same triangulation then.
    static constexpr std::array kDelaunay{constrained, untangling, topological};
    return quality == CapQuality::delaunay ? std::span<const Way>(kDelaunay) : std::span<const Way>(kFast);
}

void SectionCloser::close(const Plane& plane, std::span<const CapLoop> loops, CapQuality quality,
                          std::vector<glm::vec3>& points, SectionCaps& caps)
{
    loops_ = loops;
    quality_ = quality;
    points_in_ = &points;
    caps_ = &caps;
    const int dropped = dominant_axis(plane.normal);
    axis_u_ = (dropped + 1) % 3;
    axis_v_ = (dropped + 2) % 3;
    if (plane.normal[dropped] < 0.0) std::swap(axis_u_, axis_v_);
    excess_ = 0.0;
    mesh_.steps = 0;

    order_by(by_set_, loops.size(), [&](std::size_t i) { return loops[i].set; });
    for (std::size_t first = 0, last; first < by_set_.size(); first = last) {
        const Index set = loops[by_set_[first]].set;
        for (last = first; last < by_set_.size() && loops[by_set_[last]].set == set;) ++last;
        close_set({by_set_.data() + first, last - first}, set);
    }
    excess_ /= std::abs(plane.normal[dropped]);
}

void SectionCloser::clear_outline()
{
    points_.clear();
    positions_.clear();
    starts_.clear();
    global_.clear();
    edge_.clear();
}

void SectionCloser::append_point(std::size_t p)
{
    points_.push_back(projected(section_points()[p]));
    positions_.push_back(section_points()[p]);
    global_.push_back(static_cast<Index>(p));
    edge_.push_back(CapLink::to_outline(static_cast<Index>(p)));
    box_.add(points_.back().x, points_.back().y);
}

void SectionCloser::drop_point()
{
    points_.pop_back();
    positions_.pop_back();
    global_.pop_back();
    edge_.pop_back();
}

bool SectionCloser::append_loop(const CapLoop& loop)
{
    const auto place = [&](std::size_t i) { return projected(section_points()[loop.first + i % loop.count]); };
    // Start where two points follow one another that don't fall together.
    std::size_t start = 0;
    while (start < loop.count && place(start) == place(start + 1)) ++start;
    if (start == loop.count) return false;

    const std::size_t first = points_.size(), first_cap = caps_->triangles.size();
    // Takes the last point away: the triangle from the one before it over it to `next`.
    const auto take_away = [&](std::size_t next) {
        const Index t = static_cast<Index>(caps_->triangles.size()), last = static_cast<Index>(points_.size() - 1);
        caps_->triangles.push_back({{global_[last - 1], global_[last], static_cast<Index>(next)}});
        connect(CapLink::to_triangle(t, 0), edge_[last - 1]);
        connect(CapLink::to_triangle(t, 1), edge_[last]);
        drop_point();
        edge_.back() = CapLink::to_triangle(t, 2);
    };
    for (std::size_t i = 0; i < loop.count; ++i) {
        const std::size_t p = loop.first + (start + i) % loop.count;
        if (i > 0 && points_.back() == projected(section_points()[p])) take_away(p);
        append_point(p);
    }
    while (points_.size() - first >= 2 && points_.back() == points_[first]) take_away(global_[first]);
    if (points_.size() - first >= 3) {
        starts_.push_back(static_cast<Index>(first));
        return true;
    }
    while (points_.size() > first) drop_point();
    caps_->triangles.resize(first_cap);
    return false;
}

void SectionCloser::connect(CapLink a, CapLink b)
{
    if (core::connect(caps_->triangles, a, b)) caps_->cancelled.push_back({a.outline_edge(), b.outline_edge()});
}

void SectionCloser::close_set(std::span<const std::size_t> loops, Index set)
{
    CapSet cap{set, caps_->triangles.size(), 0};
    upright_.clear();
    box_ = {};
    clear_outline();
    for (const std::size_t i : loops)
        if (!append_loop(loops_[i])) upright_.push_back(i);
    close_outline();
    // Loops without an inside are closed on their own, as they are: none of the others is the worse for them.
    clear_outline();
    for (const std::size_t i : upright_) {
        const CapLoop& loop = loops_[i];
        starts_.push_back(static_cast<Index>(points_.size()));
        for (std::size_t p = loop.first; p < loop.first + loop.count; ++p) append_point(p);
    }
    close_outline();
    cap.count = caps_->triangles.size() - cap.first;
    caps_->sets.push_back(cap);
    order_spatially(cap);
}

void SectionCloser::close_outline()
{
    if (starts_.empty()) return;
    starts_.push_back(static_cast<Index>(points_.size()));
    const CapOutline outline{points_, positions_, starts_, axis_u_, axis_v_};
    const std::span<const Way> ways = ways_of(quality_);
    const auto way =
        std::find_if(ways.begin(), ways.end(), [&](Way each) { return ways_[each]->triangulate(outline, mesh_); });
    // These turn hardly a triangle over, and name each corner by its own point.
    const bool is_simple = way != ways.end() && (*way == convex || *way == clipping);
    if (is_simple && mesh_.triangles.size() <= kMostFlippedTriangles) flip_edges(outline.points, mesh_.triangles);
    take_over();
    if (!is_simple || mesh_.turns_over) excess_ += 2.0 * turned_area();
    if (is_simple) return;
    share_ends_of_links(outline);
}

void SectionCloser::share_ends_of_links(const CapOutline& outline)
{
    const auto compare = [&](Index a, Index b) {
        if (a != b) caps_->shared_points.insert(caps_->shared_points.end(), {global_[a], global_[b]});
    };
    successor_.resize(outline.points.size());
    for (Index loop = 0; loop + 1 < outline.loop_starts.size(); ++loop)
        for (Index i = outline.loop_starts[loop]; i < outline.loop_starts[loop + 1]; ++i)
            successor_[i] = outline.successor(i, loop);
    for (const CapTriangle& t : mesh_.triangles)
        for (std::size_t i = 0; i < 3; ++i) {
            const Index from = t.corner[i], to = t.corner[(i + 1) % 3];
            if (const CapLink link = t.link[i]; link.is_outline()) {
                compare(from, link.outline_edge());
                compare(to, successor_[link.outline_edge()]);
            } else {
                const auto& beyond = mesh_.triangles[link.triangle()].corner;
                compare(from, beyond[(link.corner() + 1) % 3]);
                compare(to, beyond[link.corner()]);
            }
        }
}

double SectionCloser::turned_area() const
{
    double twice = 0.0;
    for (const CapTriangle& t : mesh_.triangles) {
        const auto place = [&](std::size_t i) { return projected(section_points()[global_[t.corner[i]]]); };
        const glm::dvec2 p = place(1) - place(0), q = place(2) - place(0);
        twice -= std::min(0.0, p.x * q.y - p.y * q.x);
    }
    return 0.5 * twice;
}

void SectionCloser::take_over()
{
    const Index first = static_cast<Index>(caps_->triangles.size());
    for (const CrossingPoint& crossing : mesh_.crossing_points) {
        global_.push_back(static_cast<Index>(points_in_->size()));
        points_in_->push_back(crossing.position);
        caps_->crossing_edges.push_back(global_[crossing.edge]);
    }
    for (const CapTriangle& t : mesh_.triangles)
        caps_->triangles.push_back({{global_[t.corner[0]], global_[t.corner[1]], global_[t.corner[2]]}});
    for (Index t = 0; t < mesh_.triangles.size(); ++t)
        for (Index i = 0; i < 3; ++i) {
            const CapLink link = mesh_.triangles[t].link[i];
            connect(CapLink::to_triangle(first + t, i),
                    link.is_outline() ? edge_[link.outline_edge()]
                                      : CapLink::to_triangle(first + link.triangle(), link.corner()));
        }
    for (const auto& [a, b] : mesh_.cancelled) connect(edge_[a], edge_[b]);
    for (const Index i : mesh_.shared_points) caps_->shared_points.push_back(global_[i]);
}

void SectionCloser::order_spatially(const CapSet& cap)
{
    // Neighbouring triangles go to the same leaves: along a Morton curve of 1024 x 1024 cells.
    const glm::dvec2 lo(box_.lo_x, box_.lo_y);
    const double longest = std::max(box_.hi_x - box_.lo_x, box_.hi_y - box_.lo_y);
    const double scale = longest > 0.0 ? 1023.0 / (3.0 * longest) : 0.0;
    keys_.clear();
    for (std::size_t t = cap.first; t < cap.first + cap.count; ++t) {
        glm::dvec2 cell{0.0};
        for (const Index corner : caps_->triangles[t].corner) cell += projected(section_points()[corner]) - lo;
        cell *= scale;
        keys_.emplace_back(morton(std::uint32_t(cell.x), std::uint32_t(cell.y)), static_cast<Index>(t));
    }
    if (keys_.size() < kFewTriangles)
        std::sort(keys_.begin(), keys_.end());
    else
        sort_by_counting();
    for (const auto& [key, t] : keys_) caps_->order.push_back(t);
}

void SectionCloser::sort_by_counting()
{
    // Two stable passes of ten bits.
    sorted_.resize(keys_.size());
    for (std::uint32_t shift = 0; shift < 20; shift += 10) {
        std::array<std::uint32_t, 1025> start{};
        for (const auto& [key, t] : keys_) ++start[((key >> shift) & 1023u) + 1];
        for (std::size_t i = 1; i < start.size(); ++i) start[i] += start[i - 1];
        for (const auto& item : keys_) sorted_[start[(item.first >> shift) & 1023u]++] = item;
        keys_.swap(sorted_);
    }
}

}  // namespace kerf::core
