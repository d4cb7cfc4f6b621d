#include "common/repair/triangle_faults.h"

#include <algorithm>
#include <cstdlib>
#include <tuple>
#include <utility>

#include "common/geometry/disjoint_sets.h"
#include "common/mesh/index.h"
#include "common/repair/halfedges_by_edge.h"
#include "common/repair/orient_sheets.h"

namespace kerf::core {

namespace {

/// A triangle in the bucket of its smallest point: the other two in its orientation.
struct Entry
{
    std::uint32_t second, third, triangle;

    bool operator<(const Entry& other) const
    {
        return std::tie(second, third, triangle) < std::tie(other.second, other.third, other.triangle);
    }
};

/// A triangle that has the same points as an earlier one, in the same orientation.
struct Repeat
{
    std::uint32_t triangle;
    std::uint32_t layer;  ///< the number of earlier ones, less one
};

/// Decides which repeats can be dropped.
class RepeatJudge
{
public:
    RepeatJudge(std::uint32_t point_count, std::span<const Triangle> corners, std::span<const Repeat> repeats)
        : repeats_(repeats), clusters_(static_cast<std::uint32_t>(repeats.size())), is_needed_(repeats.size(), 0)
    {
        list_edges(point_count, corners);
        for (auto first = edges_.begin(), last = first; first != edges_.end(); first = last) {
            while (last != edges_.end() && layer_of(*last) == layer_of(*first)) ++last;
            judge_layer({first, last});
        }
    }

    /// Whether turning triangles over may balance an edge: an unbalanced one with an even number of them, over
    /// different points.
    bool may_be_turned_over() const { return may_be_turned_over_; }

    /// `repeat` is a number in `repeats`.
    bool is_needed(std::uint32_t repeat) { return is_needed_[clusters_.find(repeat)] != 0; }

private:
    /// An edge of a repeat.
    struct RepeatEdge
    {
        std::uint32_t repeat, edge;
        int direction;  ///< 1 if it runs from the smaller point to the larger one, otherwise -1
    };

    std::uint32_t layer_of(const RepeatEdge& edge) const { return repeats_[edge.repeat].layer; }

    /// Fills `edges_`, by layer from the last to the first and then by edge, and `balance_`.
    void list_edges(std::uint32_t point_count, std::span<const Triangle> corners)
    {
        Buffer<std::uint8_t> is_met(point_count, 0);
        for (const Repeat& repeat : repeats_)
            for (const std::uint32_t point : corners[repeat.triangle]) is_met[point] = 1;

        // Only triangles with two points of repeats can have an edge of theirs.
        Buffer<Triangle> near;
        Buffer<std::uint32_t> repeat_of;
        std::uint32_t next = 0;
        for (std::uint32_t t = 0; t < corners.size(); ++t) {
            const auto& [a, b, c] = corners[t];
            const bool is_repeat = next < repeats_.size() && repeats_[next].triangle == t;
            if (a != b && b != c && c != a && is_met[a] + is_met[b] + is_met[c] >= 2) {
                near.push_back(corners[t]);
                repeat_of.push_back(is_repeat ? next : kNone);
            }
            next += is_repeat;
        }

        HalfedgesByEdge(point_count, near).for_each([&](std::span<const HalfedgesByEdge::Entry> edge) {
            int balance = 0;
            bool has_repeat = false;
            for (const auto& [larger_point, h] : edge) {
                const int direction = near[h / 3][h % 3] == larger_point ? -1 : 1;
                balance += direction;
                if (repeat_of[h / 3] == kNone) continue;
                has_repeat = true;
                edges_.push_back({repeat_of[h / 3], static_cast<std::uint32_t>(balance_.size()), direction});
            }
            if (!has_repeat) return;
            balance_.push_back(balance);
            const auto apex = [&](const HalfedgesByEdge::Entry& entry) {
                return near[entry.halfedge / 3][previous_halfedge(entry.halfedge) % 3];
            };
            may_be_turned_over_ |= balance != 0 && edge.size() % 2 == 0 &&
                                   std::any_of(edge.begin() + 1, edge.end(), [&](const HalfedgesByEdge::Entry& entry) {
                                       return apex(entry) != apex(edge[0]);
                                   });
        });
        std::stable_sort(edges_.begin(), edges_.end(),
                         [&](const RepeatEdge& a, const RepeatEdge& b) { return layer_of(a) > layer_of(b); });
    }

    /// Calls visit(edge, repeat, change) for each edge of a layer: with any repeat at it, and the layer's share of its
    /// balance.
    template <class Visit>
    static void for_each_edge(std::span<const RepeatEdge> layer, Visit&& visit)
    {
        for (std::size_t first = 0, last = 0; first < layer.size(); first = last) {
            int change = 0;
            for (; last < layer.size() && layer[last].edge == layer[first].edge; ++last)
                change += layer[last].direction;
            visit(layer[first].edge, layer[first].repeat, change);
        }
    }

    void judge_layer(std::span<const RepeatEdge> layer)
    {
        for (std::size_t i = 1; i < layer.size(); ++i)
            if (layer[i].edge == layer[i - 1].edge) clusters_.unite(layer[i].repeat, layer[i - 1].repeat);
        // The layer's triangles at one edge are in one cluster, so clusters do not depend on one another.
        for_each_edge(layer, [&](std::uint32_t edge, std::uint32_t repeat, int change) {
            if (std::abs(balance_[edge] - change) > std::abs(balance_[edge])) is_needed_[clusters_.find(repeat)] = 1;
        });
        for_each_edge(layer, [&](std::uint32_t edge, std::uint32_t repeat, int change) {
            if (!is_needed(repeat)) balance_[edge] -= change;
        });
    }

    std::span<const Repeat> repeats_;
    std::vector<RepeatEdge> edges_;
    bool may_be_turned_over_ = false;
    std::vector<int> balance_;             ///< of each edge of repeats, without dropped ones
    DisjointSets clusters_;                ///< of numbers in `repeats_`
    std::vector<std::uint8_t> is_needed_;  ///< of each cluster
};

/// Marks degenerate triangles, and returns the triangles that repeat others, in order.
std::vector<Repeat> find_repeats(std::uint32_t point_count, std::span<const Triangle> corners,
                                 std::vector<TriangleFault>& faults)
{
    Buffer<std::uint32_t> bucket_end(point_count, 0);
    for (std::size_t t = 0; t < corners.size(); ++t) {
        const auto& [a, b, c] = corners[t];
        if (a == b || b == c || c == a)
            faults[t] = TriangleFault::degenerate;
        else
            ++bucket_end[std::min({a, b, c})];
    }
    std::uint32_t sum = 0;
    for (std::uint32_t& slot : bucket_end) sum += std::exchange(slot, sum);

    Buffer<Entry> entries(sum);
    for (std::uint32_t t = 0; t < corners.size(); ++t) {
        if (faults[t] == TriangleFault::degenerate) continue;
        const auto& [a, b, c] = corners[t];
        if (a < b && a < c)
            entries[bucket_end[a]++] = {b, c, t};
        else if (b < c)
            entries[bucket_end[b]++] = {c, a, t};
        else
            entries[bucket_end[c]++] = {a, b, t};
    }
    std::vector<Repeat> repeats;
    std::uint32_t begin = 0;
    for (const std::uint32_t end : bucket_end) {
        if (end - begin > 1) {
            std::sort(entries.begin() + begin, entries.begin() + end);
            for (std::uint32_t i = begin + 1, copies = 0; i < end; ++i) {
                const bool is_repeat =
                    entries[i].second == entries[i - 1].second && entries[i].third == entries[i - 1].third;
                copies = is_repeat ? copies + 1 : 0;
                if (is_repeat) repeats.push_back({entries[i].triangle, copies - 1});
            }
        }
        begin = end;
    }
    std::sort(repeats.begin(), repeats.end(), [](const Repeat& a, const Repeat& b) { return a.triangle < b.triangle; });
    return repeats;
}

/// The corners after triangles have been turned over.
Buffer<Triangle> turn_over(std::span<const Triangle> corners, const Buffer<std::uint8_t>& turned_over)
{
    Buffer<Triangle> turned(corners.begin(), corners.end());
    for (std::size_t t = 0; t < turned_over.size(); ++t)
        if (turned_over[t]) std::swap(turned[t][1], turned[t][2]);
    return turned;
}

/// Marks which repeats are dropped.
void mark(RepeatJudge& judge, std::span<const Repeat> repeats, std::vector<TriangleFault>& faults)
{
    for (std::uint32_t i = 0; i < repeats.size(); ++i)
        faults[repeats[i].triangle] = judge.is_needed(i) ? TriangleFault::coinciding : TriangleFault::duplicate;
}

/// Turns some triangles over and finds the faults that remain.
Faults find_faults_of_turned(std::uint32_t point_count, std::span<const Triangle> corners,
                             Buffer<std::uint8_t> turned_over)
{
    const Buffer<Triangle> turned = turn_over(corners, turned_over);
    Faults faults{std::vector<TriangleFault>(corners.size(), TriangleFault::none), std::move(turned_over)};
    const std::vector<Repeat> repeats = find_repeats(point_count, turned, faults.of);
    RepeatJudge judge(point_count, turned, repeats);
    mark(judge, repeats, faults.of);
    return faults;
}

/// The number of sides without a partner, among the triangles that stay.
std::uint64_t count_open(std::uint32_t point_count, std::span<const Triangle> corners, const Faults& faults)
{
    Buffer<Triangle> kept = keep({corners.begin(), corners.end()}, faults).corners;
    if (faults.turned_over.empty()) kept = turn_over(kept, find_turned_sheets(point_count, kept));
    std::uint64_t open = 0;
    HalfedgesByEdge(point_count, kept).for_each([&](std::span<const HalfedgesByEdge::Entry> edge) {
        int balance = 0;
        for (const auto& [larger_point, h] : edge) balance += kept[h / 3][h % 3] == larger_point ? -1 : 1;
        open += static_cast<std::uint64_t>(std::abs(balance));
    });
    return open;
}

}  // namespace

Faults no_faults(std::size_t triangle_count)
{
    return {std::vector<TriangleFault>(triangle_count, TriangleFault::none), {}};
}

Faults find_faults(std::uint32_t point_count, std::span<const Triangle> corners)
{
    Faults faults = no_faults(corners.size());
    const std::vector<Repeat> repeats = find_repeats(point_count, corners, faults.of);
    faults.repeats = repeats.size();
    if (repeats.empty()) return faults;
    RepeatJudge judge(point_count, corners, repeats);
    mark(judge, repeats, faults.of);
    if (!judge.may_be_turned_over()) return faults;
    Buffer<std::uint8_t> turned_over = find_turned_sheets(point_count, corners);
    if (turned_over.empty()) return faults;
    Faults turned = find_faults_of_turned(point_count, corners, std::move(turned_over));
    if (count_open(point_count, corners, turned) > count_open(point_count, corners, faults)) return faults;
    turned.repeats = faults.repeats;
    return turned;
}

KeptTriangles keep(Buffer<Triangle> corners, const Faults& faults)
{
    KeptTriangles kept;
    if (!faults.turned_over.empty()) kept.turned_over.assign(corners.size(), 0);
    kept.from.resize(corners.size());
    std::uint32_t count = 0;
    for (std::uint32_t t = 0; t < corners.size(); ++t) {
        if (!is_kept(faults.of[t])) continue;
        corners[count] = corners[t];
        if (faults.is_turned_over(t)) {
            std::swap(corners[count][1], corners[count][2]);
            kept.turned_over[count] = 1;
        }
        kept.from[count++] = t;
    }
    corners.resize(count);
    kept.from.resize(count);
    kept.corners = std::move(corners);
    return kept;
}

}  // namespace kerf::core
