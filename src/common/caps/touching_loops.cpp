#include "common/caps/touching_loops.h"

#include <algorithm>
#include <bit>
#include <tuple>

#include "common/geometry/turn.h"

namespace kerf::core {

namespace {

/// Both zeros have the bits of one.
std::uint32_t bits(float coordinate)
{
    return std::bit_cast<std::uint32_t>(coordinate + 0.0f);
}

}  // namespace

const Succession& LoopParter::part(const CapOutline& outline)
{
    begin(outline);
    find_crowded(outline);
    const auto key = [&](Index i) {
        const glm::vec3& p = outline.positions[i];
        return std::tie(p.x, p.y, p.z);
    };
    std::sort(crowded_.begin(), crowded_.end(),
              [&](Index a, Index b) { return std::tuple(key(a), a) < std::tuple(key(b), b); });
    for (std::size_t first = 0, last; first < crowded_.size(); first = last) {
        for (last = first + 1; last < crowded_.size() && key(crowded_[first]) == key(crowded_[last]);) ++last;
        if (last - first > 1) part_place(outline, {crowded_.data() + first, last - first});
    }
    return succession_;
}

void LoopParter::begin(const CapOutline& outline)
{
    const std::size_t n = outline.points.size();
    succession_.after.resize(n);
    succession_.shared.clear();
    before_.resize(n);
    end_.resize(n);
    for (Index loop = 0; loop + 1 < outline.loop_starts.size(); ++loop)
        for (Index i = outline.loop_starts[loop]; i < outline.loop_starts[loop + 1]; ++i) {
            end_[i] = succession_.after[i] = outline.successor(i, loop);
            before_[end_[i]] = i;
        }
}

/// Nearly all outlines have each place once: a table tells sooner than sorting all points would. Of places that it does
/// not tell apart the sorting of their points does.
void LoopParter::find_crowded(const CapOutline& outline)
{
    const auto n = static_cast<Index>(outline.points.size());
    place_of_.reset(n);
    is_crowded_.assign(n, 0);
    crowded_.clear();
    const auto add = [&](Index point) {
        if (is_crowded_[point] != 0) return;
        is_crowded_[point] = 1;
        crowded_.push_back(point);
    };
    for (Index i = 0; i < n; ++i) {
        const glm::vec3& p = outline.positions[i];
        Index& point = place_of_(bits(p.x) ^ std::rotl(bits(p.z), 16), bits(p.y));
        if (point == kNone) {
            point = i;
        } else {
            add(point);
            add(i);
        }
    }
}

void LoopParter::part_place(const CapOutline& outline, std::span<const Index> points)
{
    const glm::dvec2& place = outline.points[points.front()];
    rays_.clear();
    for (const Index i : points) {
        rays_.push_back({outline.points[before_[i]], before_[i], false});
        rays_.push_back({outline.points[end_[i]], i, true});
    }
    const auto is_below = [&](const glm::dvec2& p) { return p.y < place.y || (p.y == place.y && p.x < place.x); };
    // Around the place from the positive x axis on.
    const auto precedes = [&](const Ray& a, const Ray& b) {
        const bool a_below = is_below(a.towards), b_below = is_below(b.towards);
        return a_below != b_below ? b_below : turn(place, a.towards, b.towards) > 0.0;
    };
    std::sort(rays_.begin(), rays_.end(), precedes);
    // From an outgoing ray on, the inside lies between it and the next one, which must come in.
    for (std::size_t r = 0; r < rays_.size(); ++r) {
        const Ray &ray = rays_[r], &next = rays_[(r + 1) % rays_.size()];
        if (ray.is_outgoing == next.is_outgoing || (r + 1 < rays_.size() && !precedes(ray, next))) return;
    }
    bool changed = false;
    for (std::size_t r = 0; r < rays_.size(); ++r) {
        const Ray &ray = rays_[r], &next = rays_[(r + 1) % rays_.size()];
        if (!ray.is_outgoing) continue;
        changed = changed || succession_.after[next.edge] != ray.edge;
        succession_.after[next.edge] = ray.edge;
    }
    if (changed) succession_.shared.insert(succession_.shared.end(), points.begin(), points.end());
}

}  // namespace kerf::core
