#include "common/repair/linked_surface.h"

#include <algorithm>
#include <utility>

#include "common/repair/edge_pairing.h"
#include "common/repair/orient_patches.h"
#include "common/repair/orient_sheets.h"

namespace kerf::core {

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
LinkedSurface link_patches(Buffer<Triangle> corners, HalfedgesByEdge& edges, std::uint32_t point_count,
                           std::vector<NonmanifoldEdge>& resolved, Buffer<std::uint32_t>& patch)
{
    LinkedSurface surface;
    surface.corners = std::move(corners);
    surface.opposite.assign(surface.corners.size() * 3, kNone);
    surface.flipped.assign(surface.corners.size(), 0);

    std::vector<NonmanifoldEdge> doubled;
    bool consistent = true;
    edges.for_each([&](std::span<const HalfedgesByEdge::Entry> edge) {
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
            for (const HalfedgesByEdge::Entry& entry : edge) sides.push_back(entry.halfedge);
        }
    });
    surface.nonmanifold_edges = resolved.size();
    if (consistent && resolved.empty()) return surface;

    Patches patches = orient_patches(surface);
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

bool link_plainly(std::span<const Triangle> corners, HalfedgesByEdge& edges, Buffer<std::uint32_t>& opposite)
{
    opposite.resize(corners.size() * 3);
    return edges.for_each_while([&](std::span<const HalfedgesByEdge::Entry> edge) {
        const std::uint32_t a = edge[0].halfedge;
        if (edge.size() == 1) {
            opposite[a] = kNone;
            return true;
        }
        const std::uint32_t b = edge[1].halfedge;
        if (edge.size() > 2 || start_of(corners, a) == start_of(corners, b)) return false;
        opposite[a] = b;
        opposite[b] = a;
        return true;
    });
}

LinkedSurface plain_surface(Buffer<Triangle> corners, Buffer<std::uint32_t> opposite)
{
    LinkedSurface surface;
    surface.flipped.assign(corners.size(), 0);
    surface.corners = std::move(corners);
    surface.opposite = std::move(opposite);
    return surface;
}

LinkedSurface link_surface(Buffer<Triangle> corners, HalfedgesByEdge& edges, std::span<const glm::vec3> positions,
                           std::vector<NonmanifoldEdge>& resolved)
{
    Buffer<std::uint32_t> patch;
    LinkedSurface surface =
        link_patches(std::move(corners), edges, static_cast<std::uint32_t>(positions.size()), resolved, patch);
    pair_at_edges(surface, resolved, positions, patch);
    return surface;
}

std::uint64_t count_open_edges(Buffer<Triangle> corners, std::uint32_t point_count)
{
    std::vector<NonmanifoldEdge> resolved;
    Buffer<std::uint32_t> patch;
    HalfedgesByEdge edges(point_count, corners);
    const LinkedSurface surface = link_patches(std::move(corners), edges, point_count, resolved, patch);
    auto open = std::count(surface.opposite.begin(), surface.opposite.end(), kNone);
    for (const NonmanifoldEdge& edge : resolved) {
        const auto forward = count_forward(surface, edge);
        open -= 2 * std::min(forward, std::ssize(edge) - forward);
    }
    return static_cast<std::uint64_t>(open);
}

}  // namespace kerf::core
