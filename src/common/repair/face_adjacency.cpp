#include "common/repair/face_adjacency.h"

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>

#include "common/mesh/tolerances.h"
#include "common/repair/turned_sheets.h"

namespace kerf {

namespace {

/// Patches of triangles that are joined by edges with two triangles.
struct Patches
{
    Buffer<std::uint32_t> patch;  ///< for each triangle
    Buffer<std::uint8_t> flip;    ///< for each triangle whether to turn it over so that its patch agrees
};

/// Floods each patch from its first triangle. Neighbours that agree come before neighbours that do not, so a surface
/// that no orientation fits (a Moebius strip) opens along edges that are inconsistent already, if there are any.
class PatchFlood
{
public:
    explicit PatchFlood(const LinkedSurface& surface) : surface_(surface), turned_(surface.corners.size(), 0)
    {
        result_.patch.assign(surface.corners.size(), kNoPatch);
    }

    Patches run()
    {
        for (std::uint32_t t = 0; t < surface_.corners.size(); ++t) {
            if (result_.patch[t] != kNoPatch) continue;
            flood(t);
            ++patch_count_;
        }
        choose_smaller_part();
        return std::move(result_);
    }

private:
    static constexpr std::uint32_t kNoPatch = std::numeric_limits<std::uint32_t>::max();

    struct Step
    {
        std::uint32_t triangle;
        std::uint8_t turned;  ///< relative to the patch's first triangle
    };

    void enter(Step step)
    {
        if (result_.patch[step.triangle] != kNoPatch) return;
        result_.patch[step.triangle] = patch_count_;
        turned_[step.triangle] = step.turned;
        agreeing_.push_back(step.triangle);
    }

    void flood(std::uint32_t first)
    {
        agreeing_.clear();
        disagreeing_.clear();
        enter({first, 0});
        std::size_t next_agreeing = 0, next_disagreeing = 0;
        while (true) {
            if (next_agreeing < agreeing_.size())
                visit(agreeing_[next_agreeing++]);
            else if (next_disagreeing < disagreeing_.size())
                enter(disagreeing_[next_disagreeing++]);
            else
                break;
        }
    }

    void visit(std::uint32_t t)
    {
        for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h) {
            const std::uint32_t across = surface_.opposite[h];
            if (across == kNone) continue;
            if (surface_.start(h) != surface_.start(across))
                enter({across / 3, turned_[t]});
            else if (result_.patch[across / 3] == kNoPatch)
                disagreeing_.push_back({across / 3, static_cast<std::uint8_t>(1 - turned_[t])});
        }
    }

    void choose_smaller_part()
    {
        std::vector<std::array<std::uint32_t, 2>> sizes(patch_count_, {0, 0});
        for (std::size_t t = 0; t < turned_.size(); ++t) ++sizes[result_.patch[t]][turned_[t]];
        for (std::size_t t = 0; t < turned_.size(); ++t) {
            // In a draw the first triangle stays as it is.
            const auto& [kept, turned] = sizes[result_.patch[t]];
            turned_[t] = static_cast<std::uint8_t>(turned_[t] != (turned > kept ? 1 : 0));
        }
        result_.flip = std::move(turned_);
    }

    const LinkedSurface& surface_;
    Patches result_;
    Buffer<std::uint8_t> turned_;
    std::uint32_t patch_count_ = 0;
    std::vector<std::uint32_t> agreeing_;
    std::vector<Step> disagreeing_;
};

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

void LinkedSurface::turn_over(std::span<const std::uint8_t> flip)
{
    const auto renumbered = [&](std::uint32_t h) { return h != kNone && flip[h / 3] ? turned_over(h) : h; };
    for (std::size_t t = 0; t < corners.size(); ++t) {
        std::uint32_t* const across = &opposite[3 * t];
        if (flip[t]) {
            std::swap(corners[t][1], corners[t][2]);
            std::swap(across[0], across[2]);
            flipped[t] ^= 1;
        }
        for (int i = 0; i < 3; ++i) across[i] = renumbered(across[i]);
    }
}

namespace {

void turn_sides_over(std::span<const std::uint8_t> flip, std::vector<NonmanifoldEdge>& edges)
{
    for (NonmanifoldEdge& edge : edges)
        for (std::uint32_t& h : edge)
            if (flip[h / 3]) h = turned_over(h);
}

/// The number of triangles that run along an edge in the direction of its first one.
std::ptrdiff_t count_forward(const LinkedSurface& surface, const NonmanifoldEdge& edge)
{
    return std::count_if(edge.begin(), edge.end(),
                         [&](std::uint32_t h) { return surface.start(h) == surface.start(edge.front()); });
}

/// Whether turning patches over may close an edge: an unbalanced one with an even number of triangles.
bool may_be_turned_over(const LinkedSurface& surface, std::span<const NonmanifoldEdge> resolved)
{
    return std::any_of(resolved.begin(), resolved.end(), [&](const NonmanifoldEdge& edge) {
        return edge.size() % 2 == 0 && 2 * count_forward(surface, edge) != std::ssize(edge);
    });
}

/// Links triangles and orients patches. Edges of more than two triangles go to `resolved` and are not linked yet.
/// `patch` stays empty if there is nothing to orient.
LinkedSurface link_patches(Buffer<Triangle> corners, std::uint32_t point_count, std::vector<NonmanifoldEdge>& resolved,
                           Buffer<std::uint32_t>& patch)
{
    LinkedSurface surface;
    surface.corners = std::move(corners);
    surface.opposite.assign(surface.corners.size() * 3, kNone);
    surface.flipped.assign(surface.corners.size(), 0);

    std::vector<NonmanifoldEdge> doubled;
    bool consistent = true;
    HalfedgesByEdge(point_count, surface.corners).for_each([&](std::span<const HalfedgesByEdge::Side> edge) {
        if (edge.size() == 2) {
            const std::uint32_t a = edge[0].halfedge, b = edge[1].halfedge;
            const bool agree = surface.start(a) != surface.start(b);
            if (!agree && surface.coincide(a, b)) {
                doubled.push_back({a, b});
                return;
            }
            surface.link(a, b);
            consistent = consistent && agree;
        } else if (edge.size() > 2) {
            NonmanifoldEdge& sides = resolved.emplace_back();
            for (const HalfedgesByEdge::Side& side : edge) sides.push_back(side.halfedge);
        }
    });
    surface.nonmanifold_edges = resolved.size();
    if (consistent && resolved.empty()) return surface;

    Patches patches = PatchFlood(surface).run();
    surface.turn_over(patches.flip);
    turn_sides_over(patches.flip, resolved);
    turn_sides_over(patches.flip, doubled);
    if (may_be_turned_over(surface, resolved))
        if (const Buffer<std::uint8_t> flip = find_turned_sheets(point_count, surface.corners); !flip.empty()) {
            surface.turn_over(flip);
            turn_sides_over(flip, resolved);
            turn_sides_over(flip, doubled);
        }
    // Of two triangles in one place, one may have become the other's back.
    for (const NonmanifoldEdge& edge : doubled)
        if (surface.start(edge[0]) != surface.start(edge[1])) surface.link(edge[0], edge[1]);
    for (std::uint32_t h = 0; h < surface.opposite.size(); ++h)
        if (const std::uint32_t across = surface.opposite[h];
            across != kNone && surface.start(h) == surface.start(across)) {
            surface.opposite[h] = surface.opposite[across] = kNone;
            ++surface.unorientable_edges;
        }
    patch = std::move(patches.patch);
    return surface;
}

}  // namespace

LinkedSurface link_surface(Buffer<Triangle> corners, std::span<const glm::vec3> positions,
                           std::vector<NonmanifoldEdge>& resolved)
{
    Buffer<std::uint32_t> patch;
    LinkedSurface surface =
        link_patches(std::move(corners), static_cast<std::uint32_t>(positions.size()), resolved, patch);
    EdgePairing pairing(surface, positions, patch);
    for (const NonmanifoldEdge& edge : resolved) pairing.pair(edge);
    return surface;
}

std::uint64_t count_open_edges(Buffer<Triangle> corners, std::uint32_t point_count)
{
    std::vector<NonmanifoldEdge> resolved;
    Buffer<std::uint32_t> patch;
    const LinkedSurface surface = link_patches(std::move(corners), point_count, resolved, patch);
    auto open = std::count(surface.opposite.begin(), surface.opposite.end(), kNone);
    for (const NonmanifoldEdge& edge : resolved) {
        const auto forward = count_forward(surface, edge);
        open -= 2 * std::min(forward, std::ssize(edge) - forward);
    }
    return static_cast<std::uint64_t>(open);
}

}  // namespace kerf
