#pragma once

namespace kerf::app {

inline constexpr int kDone = 0;
/// None of the models can be used (one of several is a message), a script, picture or other file cannot, or the
/// graphics driver complained.
inline constexpr int kUnusable = 1;
inline constexpr int kWrongUse = 2;
inline constexpr int kNoDisplay = 3;

}  // namespace kerf::app
