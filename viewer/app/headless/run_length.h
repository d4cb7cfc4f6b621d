#pragma once

#include "viewer/app/options.h"
#include "viewer/sim/script.h"

namespace kerf::app {

/// Frames of a run without a window: as many as were asked for, or else until a second after the script's last input,
/// time to see what it did.
std::int64_t frames_of(const Options& options, const sim::Script& script);

}  // namespace kerf::app
