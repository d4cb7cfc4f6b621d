#pragma once

#include <cstdint>
#include <string>

namespace kerf::ui {

/// Seconds as a clock that counts down shows them, rounded up: "0:09". Less than none is none.
std::string clock_text(double seconds);

/// 1234567 -> "1 234 567".
std::string number_text(std::int64_t number);

/// "2.3 ms", "460 ms".
std::string milliseconds_text(double ms);

}  // namespace kerf::ui
