#include "common/fans.h"

namespace kerf {

namespace {

constexpr std::uint32_t kNoFan = std::numeric_limits<std::uint32_t>::max();

void renumber(const LinkedSurface& surface, std::uint32_t corner, Fans& fans)
{
    const std::uint32_t number = fans.count++;
    for_each_in_fan(surface, corner, [&](std::uint32_t c) { fans.fan[c] = number; });
}

/// Exchanging the partners of two links that the same cycle passes divides the cycle in two, and never joins two fans:
/// one pass over all edges is enough.
void separate_repeats(LinkedSurface& surface, const NonmanifoldEdge& edge, Fans& fans)
{
    for (std::size_t i = 0; i < edge.size(); ++i)
        for (std::size_t j = i + 1; j < edge.size(); ++j) {
            const std::uint32_t a = edge[i], b = edge[j];
            if (fans.fan[a] != fans.fan[b] || fans.fan[next_half_edge(a)] != fans.fan[next_half_edge(b)]) continue;
            const std::uint32_t mate_a = surface.mates[a], mate_b = surface.mates[b];
            surface.mates[a] = surface.mates[b] = kNoTwin;
            surface.link(a, mate_b);
            surface.link(b, mate_a);
            renumber(surface, a, fans);
            renumber(surface, next_half_edge(a), fans);
        }
}

}  // namespace

Fans find_fans(LinkedSurface& surface, std::span<const NonmanifoldEdge> resolved)
{
    Fans fans;
    fans.fan.assign(surface.mates.size(), kNoFan);
    for (std::uint32_t h = 0; h < surface.mates.size(); ++h) {
        if (fans.fan[h] != kNoFan) continue;
        const std::uint32_t number = fans.count++;
        std::uint32_t corner = h;
        do {
            fans.fan[corner] = number;
            corner = surface.mates[previous_half_edge(corner)];
        } while (corner != kNoTwin && corner != h);
        if (corner == h) continue;
        for (std::uint32_t mate = surface.mates[h]; mate != kNoTwin; mate = surface.mates[corner]) {
            corner = next_half_edge(mate);
            fans.fan[corner] = number;
        }
    }
    for (const NonmanifoldEdge& edge : resolved) separate_repeats(surface, edge, fans);
    return fans;
}

}  // namespace kerf
