#include "viewer/sim/piece_choice.h"

#include <algorithm>
#include <numeric>

namespace kerf::sim {

PieceChoice choose_heaviest(std::span<const Candidate> pieces, const World& world, std::size_t most_neighbours)
{
    const std::size_t others = world.bodies().size();
    const std::size_t room = std::max<std::size_t>(kMostBodies - std::min(kMostBodies, others), 2);
    std::vector<std::size_t> order(pieces.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        const double first = pieces[a].mass, second = pieces[b].mass;
        return first > second || (first == second && a < b);
    });
    PieceChoice choice;
    choice.stays.resize(pieces.size(), false);
    if (others + std::min(room, pieces.size()) <= most_neighbours + 1) {
        for (std::size_t i = 0; i < std::min(room, order.size()); ++i) choice.stays[order[i]] = true;
        return choice;
    }
    Crowd crowd(world);
    for (const std::size_t i : order) {
        if (crowd.size() >= others + room) break;
        if (crowd.size() > others && crowd.is_thick_at(pieces[i].box, most_neighbours)) {
            ++choice.crowded;
            continue;
        }
        choice.stays[i] = true;
        crowd.add(pieces[i].box);
    }
    return choice;
}

}  // namespace kerf::sim
