#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <numeric>
#include <type_traits>
#include <vector>

namespace kerf {

/// Edges by the point that they leave, to be followed one after the other: each is used once. `tag_of(edge)` is what
/// edges that follow one another have in common: it compares, and is the same on every call.
///
/// Building and following all edges cost O(points + e log d) for e edges, d of which leave one point at most.
template <class TagOf>
class OutgoingEdges
{
public:
    using Tag = std::invoke_result_t<TagOf, std::uint32_t>;
    static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

    /// `from_of(edge)` is the point that an edge leaves.
    template <class FromOf>
    OutgoingEdges(std::size_t point_count, std::size_t edge_count, FromOf from_of, TagOf tag_of)
        : tag_of_(tag_of), row_(point_count + 1, 0), edges_(edge_count), is_used_(edge_count, false)
    {
        for (std::uint32_t i = 0; i < edge_count; ++i) ++row_[from_of(i) + 1];
        std::partial_sum(row_.begin(), row_.end(), row_.begin());
        std::vector<std::uint32_t> fill(row_.begin(), row_.end() - 1);
        for (std::uint32_t i = 0; i < edge_count; ++i) edges_[fill[from_of(i)]++] = i;
        // Nearly always one edge leaves a point.
        for (std::size_t p = 0; p < point_count; ++p) {
            if (row_[p + 1] - row_[p] < 2) continue;
            std::stable_sort(edges_.begin() + row_[p], edges_.begin() + row_[p + 1],
                             [&](std::uint32_t a, std::uint32_t b) { return tag_of_(a) < tag_of_(b); });
            if (next_.empty()) {
                tags_.resize(edge_count);
                next_.resize(edge_count);
            }
            for (std::uint32_t i = row_[p]; i < row_[p + 1]; ++i) {
                tags_[i] = tag_of_(edges_[i]);
                next_[i] = i;
            }
        }
    }

    void use(std::uint32_t edge) { is_used_[edge] = true; }
    bool is_used(std::uint32_t edge) const { return is_used_[edge]; }

    /// All edges that leave a point, by number. O(d log d).
    std::vector<std::uint32_t> leaving(std::uint32_t point) const
    {
        std::vector<std::uint32_t> edges(edges_.begin() + row_[point], edges_.begin() + row_[point + 1]);
        std::sort(edges.begin(), edges.end());
        return edges;
    }

    /// The first edge by number that leaves a point, has this tag and is not used; kNone when there is none. O(log d),
    /// amortised.
    std::uint32_t next(std::uint32_t point, const Tag& tag)
    {
        const std::uint32_t begin = row_[point], end = row_[point + 1];
        if (end - begin < 2) {
            if (begin == end || is_used_[edges_[begin]] || tag_of_(edges_[begin]) != tag) return kNone;
            return edges_[begin];
        }
        const auto first = static_cast<std::uint32_t>(
            std::lower_bound(tags_.begin() + begin, tags_.begin() + end, tag) - tags_.begin());
        if (first == end || tags_[first] != tag) return kNone;
        // The first edge of the tag remembers how far its kind is used up.
        std::uint32_t& at = next_[first];
        while (at < end && tags_[at] == tag && is_used_[edges_[at]]) ++at;
        return at < end && tags_[at] == tag ? edges_[at] : kNone;
    }

private:
    TagOf tag_of_;
    std::vector<std::uint32_t> row_;    ///< first of each point's edges in `edges_`, and their number at the end
    std::vector<std::uint32_t> edges_;  ///< of each point by tag, then by number
    std::vector<bool> is_used_;
    // Where several edges leave a point, by place in `edges_`:
    std::vector<Tag> tags_;
    std::vector<std::uint32_t> next_;
};

}  // namespace kerf
