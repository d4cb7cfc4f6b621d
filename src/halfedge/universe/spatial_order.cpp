#include "halfedge/universe/spatial_order.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <vector>

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

ScratchArray<Item> items_of(const ProvenMesh& proven, const Layout& layout)
{
    const IndexedMesh& mesh = proven;
    const Box& box = proven.bounds();
    const glm::dvec3 lo(box.lo), size = glm::dvec3(box.hi) - lo;
    const double longest = std::max({size.x, size.y, size.z});
    const double cells = double((1u << layout.bits_of_axis) - 1);
    const double scale = longest > 0.0 ? cells / (3.0 * longest) : 0.0;
    ScratchArray<Item> items(mesh.triangles.size());
    for (std::size_t i = 0; i < items.size(); ++i) {
        const Triangle& t = mesh.triangles[i];
        const glm::dvec3 centre = (glm::dvec3(mesh.vertices[t[0]].position) - lo) +
                                  (glm::dvec3(mesh.vertices[t[1]].position) - lo) +
                                  (glm::dvec3(mesh.vertices[t[2]].position) - lo);
        const glm::dvec3 cell = centre * scale;
        const std::uint64_t code =
            spread(std::uint32_t(cell.x)) | (spread(std::uint32_t(cell.y)) << 1) | (spread(std::uint32_t(cell.z)) << 2);
        items[i] = (code << layout.bits_of_number) | i;
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

ScratchArray<Index> spatial_order(const ProvenMesh& proven, std::span<const Index> group_of, std::size_t groups)
{
    const Layout layout(proven->triangles.size());
    ScratchArray<Item> items = items_of(proven, layout);
    sort_by_cell(items, layout);
    ScratchArray<Index> order(items.size());
    for (std::size_t i = 0; i < items.size(); ++i) order[i] = layout.number(items[i]);

    const Adjacency& adjacency = proven.adjacency();
    if (adjacency.shell_count > 1)
        sort_by(order, adjacency.shell_count, [&](Index triangle) { return adjacency.shell[triangle]; });
    if (groups > 1) sort_by(order, groups, [&](Index triangle) { return group_of[triangle]; });
    return order;
}

}  // namespace kerf::core::halfedge
