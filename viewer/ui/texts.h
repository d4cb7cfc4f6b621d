#pragma once

#include <string>

namespace kerf::ui {

/// Seconds as a clock that counts down shows them, rounded up: "0:09". Less than none is none.
std::string clock_text(double seconds);

/// "2.3 ms", "460 ms".
std::string milliseconds_text(double ms);

}  // namespace kerf::ui
