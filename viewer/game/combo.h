#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <optional>

#include "viewer/sim/state_hash.h"
#include "viewer/sim/ticks.h"

namespace kerf::game {

/// Counts the fruit of one swipe. A combo is over when its swipe is, or when kComboGap went by without another fruit;
/// then the same swipe may begin another one.
class Combo
{
public:
    struct Closed
    {
        int fruit = 0;          ///< at least kSmallestCombo
        glm::dvec2 place{0.0};  ///< the middle of its cuts, on the stage
    };

    /// A swipe has cut a fruit. Gives the combo of an earlier swipe that this one ends.
    std::optional<Closed> add(std::uint32_t swipe, sim::Tick now, const glm::dvec2& place);
    /// Once a tick: gives the combo that has ended.
    /// @param swipe, pressed  of the blade: its last swipe, and whether that is still under way
    std::optional<Closed> tick(std::uint32_t swipe, bool pressed, sim::Tick now);
    /// Ends it now.
    std::optional<Closed> close();

    /// Fruit so far.
    int fruit() const { return fruit_; }
    void hash(sim::StateHash& hash) const;

private:
    std::uint32_t swipe_ = 0;
    int fruit_ = 0;
    sim::Tick last_ = 0;
    glm::dvec2 sum_of_places_{0.0};
};

}  // namespace kerf::game
