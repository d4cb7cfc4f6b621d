#pragma once

#include <vector>

#include "viewer/sound/sounds.h"

namespace kerf::sound {

/// Samples a second of everything that is synthesised.
inline constexpr int kSampleRate = 44'100;
/// Nothing is louder; 1 is what a loudspeaker can do.
inline constexpr float kPeak = 0.89f;
/// Nothing lasts longer, seconds.
inline constexpr double kLongest = 2.5;

/// The samples of a sound, one channel, -kPeak to kPeak. It starts and ends in silence, so that it can follow and be
/// followed by anything without a click; Sound::fuse ends as it starts instead, to be repeated. The same samples on
/// every run. Up to 50 ms of work.
std::vector<float> synthesise(Sound sound);

}  // namespace kerf::sound
