#include "common/repair/edge_pairing.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>

#include "common/mesh/tolerances.h"

namespace kerf::core {

namespace {

/// Pairs the triangles around one edge.
class EdgePairing
{
public:
    EdgePairing(LinkedSurface& surface, std::span<const glm::vec3> positions, std::span<const std::uint32_t> patch)
        : surface_(surface), positions_(positions), patch_(patch)
    {
    }

    void pair(const NonmanifoldEdge& edge)
    {
        sort_around(edge);
        std::vector<std::uint32_t> all(pages_.size());
        std::iota(all.begin(), all.end(), 0u);
        if (!alternates()) match_within_patches(all);
        match(all);
    }

private:
    /// A triangle at the edge, like a page at the spine of a book.
    struct Page
    {
        double angle;
        bool forward;  ///< runs along the edge: its solid is on the side of smaller angles
        std::uint32_t halfedge;
        bool matched = false;
    };

    /// Sorts by angle, counter-clockwise seen from the tip of the edge. Of pages at the same angle, those whose solid
    /// is before them come first, so that two solids that touch in a face stay two.
    void sort_around(const NonmanifoldEdge& edge)
    {
        const std::uint32_t first = edge.front();
        const glm::dvec3 tail = positions_[surface_.start(first)], tip = positions_[surface_.end(first)];
        const glm::dvec3 axis = glm::normalize(tip - tail);
        const auto across = [&](std::uint32_t h) {
            const glm::dvec3 d = glm::dvec3(positions_[surface_.start(previous_halfedge(h))]) - tail;
            return d - axis * glm::dot(axis, d);
        };
        // A triangle without area has no direction: measure angles from the one that reaches farthest.
        glm::dvec3 zero{0.0};
        for (const std::uint32_t h : edge)
            if (const glm::dvec3 d = across(h); glm::dot(d, d) > glm::dot(zero, zero)) zero = d;
        const glm::dvec3 quarter = glm::cross(axis, zero);

        pages_.clear();
        for (const std::uint32_t h : edge) {
            const glm::dvec3 d = across(h);
            pages_.push_back(
                {std::atan2(glm::dot(quarter, d), glm::dot(zero, d)), surface_.start(h) == surface_.start(first), h});
        }
        const auto by_angle = [](const Page& a, const Page& b) {
            return a.angle != b.angle ? a.angle < b.angle : a.halfedge < b.halfedge;
        };
        std::sort(pages_.begin(), pages_.end(), by_angle);

        // Start behind the widest gap, so that no run of equal angles goes across the jump from +pi to -pi.
        constexpr double kTurn = 6.283185307179586;
        std::size_t start = 0;
        double widest = pages_.front().angle + kTurn - pages_.back().angle;
        for (std::size_t i = 1; i < pages_.size(); ++i)
            if (const double gap = pages_[i].angle - pages_[i - 1].angle; gap > widest) widest = gap, start = i;
        for (std::size_t i = 0; i < start; ++i) pages_[i].angle += kTurn;
        std::rotate(pages_.begin(), pages_.begin() + static_cast<std::ptrdiff_t>(start), pages_.end());

        for (std::size_t i = 0; i < pages_.size();) {
            std::size_t last = i + 1;
            while (last < pages_.size() && pages_[last].angle - pages_[last - 1].angle <= kSameAngle) ++last;
            std::stable_sort(pages_.begin() + static_cast<std::ptrdiff_t>(i),
                             pages_.begin() + static_cast<std::ptrdiff_t>(last),
                             [](const Page& a, const Page& b) { return a.forward && !b.forward; });
            i = last;
        }
    }

    /// Whether solid and empty wedges alternate, each bounded by neighbours. Otherwise wedges overlap.
    bool alternates() const
    {
        for (std::size_t i = 0; i < pages_.size(); ++i)
            if (pages_[i].forward == pages_[(i + 1) % pages_.size()].forward) return false;
        return true;
    }

    /// Matches pages of the same patch first.
    void match_within_patches(std::vector<std::uint32_t> pages)
    {
        const auto patch_of = [&](std::uint32_t page) { return patch_[pages_[page].halfedge / 3]; };
        std::stable_sort(pages.begin(), pages.end(),
                         [&](std::uint32_t a, std::uint32_t b) { return patch_of(a) < patch_of(b); });
        for (std::size_t first = 0; first < pages.size();) {
            std::size_t last = first + 1;
            while (last < pages.size() && patch_of(pages[last]) == patch_of(pages[first])) ++last;
            match(std::span(pages).subspan(first, last - first));
            first = last;
        }
    }

    /// Matches some pages like brackets: one that opens a solid wedge with the next one that closes it. Goes around
    /// twice, because a wedge may reach over the start.
    void match(std::span<const std::uint32_t> pages)
    {
        open_.clear();
        for (const bool first_round : {true, false})
            for (const std::uint32_t index : pages) {
                Page& page = pages_[index];
                if (page.matched) continue;
                if (!page.forward) {
                    if (first_round) open_.push_back(index);
                } else if (!open_.empty()) {
                    Page& opening = pages_[open_.back()];
                    open_.pop_back();
                    page.matched = opening.matched = true;
                    surface_.link(page.halfedge, opening.halfedge);
                }
            }
    }

    LinkedSurface& surface_;
    std::span<const glm::vec3> positions_;
    std::span<const std::uint32_t> patch_;
    std::vector<Page> pages_;
    std::vector<std::uint32_t> open_;
};

}  // namespace

void pair_at_edges(LinkedSurface& surface, std::span<const NonmanifoldEdge> edges, std::span<const glm::vec3> positions,
                   std::span<const std::uint32_t> patch)
{
    EdgePairing pairing(surface, positions, patch);
    for (const NonmanifoldEdge& edge : edges) pairing.pair(edge);
}

}  // namespace kerf::core
