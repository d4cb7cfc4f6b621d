#include "viewer/ui/texts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace kerf::ui {

std::string clock_text(double seconds)
{
    const int whole = static_cast<int>(std::ceil(std::max(seconds, 0.0)));
    std::array<char, 24> text{};
    std::snprintf(text.data(), text.size(), "%d:%02d", whole / 60, whole % 60);
    return text.data();
}

std::string number_text(std::int64_t number)
{
    std::string text = std::to_string(number);
    const std::size_t first = number < 0 ? 1 : 0;
    for (std::size_t i = text.size(); i > first + 3;) text.insert(i -= 3, 1, ' ');
    return text;
}

std::string milliseconds_text(double ms)
{
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), ms < 10.0 ? "%.1f ms" : "%.0f ms", ms);
    return text.data();
}

}  // namespace kerf::ui
