#include "common/cutting/joined_pieces.h"

#include <limits>

namespace kerf::core {

JoinedPieces::JoinedPieces(const BySide<std::uint32_t>& count)
    : pieces_(count), joined_(count[Side::negative] + count[Side::positive])
{
}

void JoinedPieces::part(const BySide<std::uint32_t>& pieces)
{
    const BySide<std::uint32_t> nodes{node(Side::negative, pieces[Side::negative]),
                                      node(Side::positive, pieces[Side::positive])};
    // A loop has many edges between the same two pieces.
    if (cut_.empty() || cut_.back()[Side::negative] != nodes[Side::negative] ||
        cut_.back()[Side::positive] != nodes[Side::positive])
        cut_.push_back(nodes);
}

bool JoinedPieces::find()
{
    constexpr std::uint32_t kUnknown = std::numeric_limits<std::uint32_t>::max();
    // Which sides of cut edges a set lies on: a bit for each.
    std::vector<std::uint8_t> bounded(joined_.size(), 0);
    for (const BySide<std::uint32_t>& nodes : cut_)
        for (const Side side : kSides)
            bounded[joined_.find(nodes[side])] |= static_cast<std::uint8_t>(1 << static_cast<int>(side));
    constexpr std::uint8_t kBoth = 1 << static_cast<int>(Side::negative) | 1 << static_cast<int>(Side::positive);
    std::vector<std::uint8_t> has_negative(joined_.size(), 0);
    for (std::uint32_t piece = 0; piece < pieces_[Side::negative]; ++piece) has_negative[joined_.find(piece)] = 1;

    std::vector<Place> of_set(joined_.size(), Place{Side::negative, kUnknown});
    places_.resize(joined_.size());
    for (std::uint32_t i = 0; i < joined_.size(); ++i) {
        const std::uint32_t set = joined_.find(i);
        if (bounded[set] == kBoth) return false;
        Place& place = of_set[set];
        if (place.number == kUnknown) {
            const bool positive =
                bounded[set] != 0 ? bounded[set] >> static_cast<int>(Side::positive) & 1 : has_negative[set] == 0;
            place.side = positive ? Side::positive : Side::negative;
            place.number = counts_[place.side]++;
        }
        places_[i] = place;
    }
    return true;
}

}  // namespace kerf::core
