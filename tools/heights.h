#pragma once

#include <string>
#include <vector>

namespace kerf::tools {

/// "0.5" as a number.
/// @throws CLI::ValidationError
double parse_height(const std::string& option, const std::string& text);

/// The same of a width: a number that is not below 0.
/// @throws CLI::ValidationError
double parse_width(const std::string& option, const std::string& text);

/// "0:1:0.25" as 0, 0.25, 0.5, 0.75, 1: from the first number to the second in steps of the third. The last height is
/// there if it is missed by rounding alone.
/// @throws CLI::ValidationError
std::vector<double> parse_heights(const std::string& option, const std::string& text);

/// So many heights between two, each in the middle of as many layers of one thickness.
std::vector<double> heights_between(double lowest, double highest, std::size_t count);

}  // namespace kerf::tools
