#pragma once

#include <string>

#include "viewer/sim/simulation.h"

namespace kerf::app {

/// What a user chooses for the next throw, one after another, and says so: each gives a sentence for the user.
class ThrowChoices
{
public:
    /// @param simulation  outlives it
    explicit ThrowChoices(sim::Simulation& simulation) : simulation_(simulation) {}

    /// From the half-edge back end to the baseline that was chosen last, and back.
    std::string next_backend();
    std::string next_lookup();
    std::string next_proxy();
    std::string next_gesture();

private:
    sim::Simulation& simulation_;
    std::string last_baseline_ = "baseline";
};

}  // namespace kerf::app
