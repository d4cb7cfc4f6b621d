#include "halfedge/universe/spatial_order.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <vector>

#include "halfedge/universe/side_by_side.h"

namespace kerf::core::halfedge {

namespace {

/// A triangle in one number, so that sorting moves eight bytes: the cell of its centre in the high bits, its own number
/// in the low ones.
using Item = std::uint64_t;

/// How the bits of an item are shared out.
struct Layout
{
    std::uint32_t bits_of_axis;  ///< of a cell, for each axis
    std::uint32_t digits;        ///< of a cell: what it is sorted by, one after another
    std::uint32_t bits_of_digit;
    std::uint32_t bits_of_number;  ///< of a triangle

    explicit Layout(std::size_t triangles)
    {
        constexpr std::size_t kMany = std::size_t(1) << 17, kTooManyForShort = std::size_t(1) << 21,
                              kTooManyForLong = std::size_t(1) << 28;
        // A surface passes through some 6 * 4^bits cells. Triangles of one cell keep the order that they had, so a few
        // to a cell are as good as one. Each digit costs a pass over all, which is worth saving if they are many.
        const bool is_short = kMany <= triangles && triangles <= kTooManyForShort;
        bits_of_axis = is_short ? 8 : triangles <= kTooManyForLong ? 12 : 11;
        digits = is_short ? 2 : 3;
        bits_of_digit = 3 * bits_of_axis / digits;
        bits_of_number = 64 - 3 * bits_of_axis;
    }
    Index number(Item item) const { return static_cast<Index>(item & ((Item(1) << bits_of_number) - 1)); }
};

constexpr std::uint32_t kBitsAtOnce = 6;

/// Numbers of six bits with their bits spread to every third one.
constexpr auto kSpread = [] {
    std::array<std::uint32_t, std::size_t(1) << kBitsAtOnce> spread{};
    for (std::uint32_t v = 0; v < spread.size(); ++v)
        for (std::uint32_t bit = 0; bit < kBitsAtOnce; ++bit) spread[v] |= (v >> bit & 1u) << 3 * bit;
    return spread;
}();

/// Spreads the low 12 bits to every third bit.
std::uint64_t spread(std::uint32_t v)
{
    constexpr std::uint32_t kMask = (1u << kBitsAtOnce) - 1;
    return kSpread[v & kMask] | std::uint64_t(kSpread[v >> kBitsAtOnce & kMask]) << 3 * kBitsAtOnce;
}

/// Of the triangles from `first` on, up to `end`.
ScratchArray<Item> items_of(const ProvenMesh& proven, const Layout& layout, std::size_t first, std::size_t end)
{
    const IndexedMesh& mesh = proven;
    const Box& box = proven.bounds();
    const glm::dvec3 lo(box.lo), size = glm::dvec3(box.hi) - lo;
    const double longest = std::max({size.x, size.y, size.z});
    const double cells = double((1u << layout.bits_of_axis) - 1);
    const double scale = longest > 0.0 ? cells / (3.0 * longest) : 0.0;
    ScratchArray<Item> items(end - first);
    for (std::size_t i = first; i < end; ++i) {
        const Triangle& t = mesh.triangles[i];
        const glm::dvec3 centre = (glm::dvec3(mesh.vertices[t[0]].position) - lo) +
                                  (glm::dvec3(mesh.vertices[t[1]].position) - lo) +
                                  (glm::dvec3(mesh.vertices[t[2]].position) - lo);
        const glm::dvec3 cell = centre * scale;
        const std::uint64_t code =
            spread(std::uint32_t(cell.x)) | (spread(std::uint32_t(cell.y)) << 1) | (spread(std::uint32_t(cell.z)) << 2);
        items[i - first] = (code << layout.bits_of_number) | i;
    }
    return items;
}

/// With fewer triangles, counting to 4096 three times costs more than sorting by comparisons: 11 us and 0.2 us for 12
/// triangles, the same for 250 to 400.
constexpr std::size_t kFewTriangles = 256;

/// By cell and number. The items come in the order of their numbers.
void sort_by_cell(ScratchArray<Item>& items, const Layout& layout)
{
    if (items.size() < kFewTriangles) {
        std::sort(items.begin(), items.end());
        return;
    }
    // A pass of a counting sort for each digit, from the least. All digits are counted in one go.
    constexpr std::size_t kMostDigits = 3, kMostBits = 12;
    const std::size_t keys = std::size_t(1) << layout.bits_of_digit;
    const auto digit = [&](Item item, std::size_t d) {
        return (item >> (layout.bits_of_number + d * layout.bits_of_digit)) & (keys - 1);
    };
    std::array<std::array<std::uint32_t, std::size_t(1) << kMostBits>, kMostDigits> start{};
    for (const Item item : items)
        for (std::size_t d = 0; d < layout.digits; ++d) ++start[d][digit(item, d)];
    ScratchArray<Item> scratch(items.size());
    for (std::size_t d = 0; d < layout.digits; ++d) {
        std::exclusive_scan(start[d].begin(), start[d].end(), start[d].begin(), 0u);
        for (const Item item : items) scratch[start[d][digit(item, d)]++] = item;
        items.swap(scratch);
    }
}

using SortedItems = std::span<const Item>;

/// How many of the first `count` items of two sorted runs together are of the first run.
std::size_t share_of_first(SortedItems a, SortedItems b, std::size_t count)
{
    std::size_t least = count - std::min(count, b.size()), most = std::min(count, a.size());
    while (least < most) {
        const std::size_t middle = (least + most) / 2;
        if (a[middle] < b[count - middle - 1])
            least = middle + 1;
        else
            most = middle;
    }
    return least;
}

/// The triangles of two sorted runs in the order of both.
void merge_numbers(SortedItems a, SortedItems b, const Layout& layout, Index* to)
{
    auto x = a.begin(), y = b.begin();
    while (x != a.end() && y != b.end()) *to++ = layout.number(*x < *y ? *x++ : *y++);
    for (; x != a.end(); ++x) *to++ = layout.number(*x);
    for (; y != b.end(); ++y) *to++ = layout.number(*y);
}

/// By cell and number, half of them on another thread: each half is sorted, and each half of the result is merged.
ScratchArray<Index> order_by_cell_on_two_threads(const ProvenMesh& proven, const Layout& layout)
{
    const std::size_t n = proven->triangles.size(), half = n / 2;
    ScratchArray<Item> lower, upper;
    const auto sorted = [&](std::size_t first, std::size_t end) {
        ScratchArray<Item> items = items_of(proven, layout, first, end);
        sort_by_cell(items, layout);
        return items;
    };
    side_by_side(
        true, [&] { lower = sorted(0, half); }, [&] { upper = sorted(half, n); });
    const SortedItems a(lower.data(), lower.size()), b(upper.data(), upper.size());
    const std::size_t of_a = share_of_first(a, b, half), of_b = half - of_a;
    ScratchArray<Index> order(n);
    side_by_side(
        true, [&] { merge_numbers(a.first(of_a), b.first(of_b), layout, order.data()); },
        [&] { merge_numbers(a.subspan(of_a), b.subspan(of_b), layout, order.data() + half); });
    return order;
}

ScratchArray<Index> order_by_cell(const ProvenMesh& proven, const Layout& layout)
{
    ScratchArray<Item> items = items_of(proven, layout, 0, proven->triangles.size());
    sort_by_cell(items, layout);
    ScratchArray<Index> order(items.size());
    for (std::size_t i = 0; i < items.size(); ++i) order[i] = layout.number(items[i]);
    return order;
}

/// A stable sort of triangles by key(triangle) < keys.
template <class Key>
void sort_by(ScratchArray<Index>& order, std::size_t keys, Key key)
{
    std::vector<std::uint32_t> start(keys, 0);
    for (const Index t : order) ++start[key(t)];
    std::exclusive_scan(start.begin(), start.end(), start.begin(), 0u);
    ScratchArray<Index> sorted(order.size());
    for (const Index t : order) sorted[start[key(t)]++] = t;
    order.swap(sorted);
}

}  // namespace

ScratchArray<Index> spatial_order(const ProvenMesh& proven, std::span<const Index> group_of, std::size_t groups,
                                  bool on_two_threads)
{
    const Layout layout(proven->triangles.size());
    ScratchArray<Index> order =
        on_two_threads ? order_by_cell_on_two_threads(proven, layout) : order_by_cell(proven, layout);
    const Adjacency& adjacency = proven.adjacency();
    if (adjacency.shell_count > 1)
        sort_by(order, adjacency.shell_count, [&](Index triangle) { return adjacency.shell[triangle]; });
    if (groups > 1) sort_by(order, groups, [&](Index triangle) { return group_of[triangle]; });
    return order;
}

}  // namespace kerf::core::halfedge
