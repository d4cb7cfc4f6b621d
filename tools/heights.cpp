#include "tools/heights.h"

#include <CLI/CLI.hpp>
#include <cmath>

#include "tools/text.h"

namespace kerf::tools {

namespace {

/// Share of a step by which rounding may move the last height beyond the end.
constexpr double kRoundedStep = 1e-9;
/// More than that is a mistake in a step rather than a wish.
constexpr double kMostHeights = 1e6;

}  // namespace

double parse_height(const std::string& option, const std::string& text)
{
    if (text.find(',') != std::string::npos) throw CLI::ValidationError(option, "'" + text + "' is not a number");
    try {
        return parse_vector(option, text + ",0,0").x;
    } catch (const CLI::ValidationError&) {
        throw CLI::ValidationError(option, "'" + text + "' is not a number");
    }
}

double parse_width(const std::string& option, const std::string& text)
{
    const double width = parse_height(option, text);
    if (width < 0.0) throw CLI::ValidationError(option, "'" + text + "' is below 0");
    return width;
}

std::vector<double> parse_heights(const std::string& option, const std::string& text)
{
    std::string numbers = text;
    for (char& c : numbers)
        if (c == ':') c = ',';
    if (numbers == text || text.find(',') != std::string::npos)
        throw CLI::ValidationError(option, "'" + text + "' is not of the form FROM:TO:STEP, such as 0:1:0.02");
    const glm::dvec3 parts = parse_vector(option, numbers);
    const double from = parts.x, to = parts.y, step = parts.z;
    if (!(step != 0.0) || (to - from) / step < 0.0)
        throw CLI::ValidationError(option, "the step of '" + text + "' leads away from its end");
    const double count = std::floor((to - from) / step + kRoundedStep) + 1.0;
    if (!(count <= kMostHeights)) throw CLI::ValidationError(option, "'" + text + "' are more than a million heights");
    std::vector<double> heights;
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) heights.push_back(from + double(i) * step);
    return heights;
}

std::vector<double> heights_between(double lowest, double highest, std::size_t count)
{
    std::vector<double> heights;
    for (std::size_t i = 0; i < count; ++i)
        heights.push_back(lowest + (double(i) + 0.5) * ((highest - lowest) / double(count)));
    return heights;
}

}  // namespace kerf::tools
