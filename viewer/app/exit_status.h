#pragma once

namespace kerf::app {

inline constexpr int kDone = 0;
inline constexpr int kUnusable = 1;  ///< a file cannot be used, or the graphics driver complained
inline constexpr int kWrongUse = 2;
inline constexpr int kNoDisplay = 3;

}  // namespace kerf::app
