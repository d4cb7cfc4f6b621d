#pragma once

#include <algorithm>
#include <compare>
#include <optional>
#include <vector>

namespace kerf::core {

/// A place on a line at which it goes through a closed outline or surface.
struct LineHit
{
    double place = 0.0;  ///< along the line
    int turns = 0;       ///< by how much the winding number changes there

    auto operator<=>(const LineHit&) const = default;
};

/// The middle of the longest stretch of the line that lies inside, where the winding number is not 0; nothing if there
/// is none. Sorts the hits. O(h log h).
inline std::optional<double> middle_of_longest_inside(std::vector<LineHit>& hits)
{
    std::sort(hits.begin(), hits.end());
    std::optional<double> middle;
    int winding = 0;
    double longest = 0.0;
    for (std::size_t i = 0; i + 1 < hits.size(); ++i) {
        winding += hits[i].turns;
        const double length = hits[i + 1].place - hits[i].place;
        if (winding == 0 || length <= longest) continue;
        longest = length;
        middle = hits[i].place + length / 2;
    }
    return middle;
}

}  // namespace kerf::core
