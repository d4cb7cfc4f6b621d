#include "tools/text.h"

#include <CLI/CLI.hpp>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <stdexcept>
#include <string_view>

namespace kerf::tools {

std::string grouped(std::uint64_t value)
{
    std::string digits = std::to_string(value);
    for (std::size_t at = digits.size(); at > 3;) digits.insert(at -= 3, 1, ',');
    return digits;
}

std::string rounded(double value)
{
    char text[32];
    std::snprintf(text, sizeof text, "%.6g", value);
    return text;
}

std::string counted(std::uint64_t count, const std::string& noun)
{
    return grouped(count) + " " + noun + (count == 1 ? "" : "s");
}

std::string vector_text(const glm::dvec3& v)
{
    return "(" + rounded(v.x) + ", " + rounded(v.y) + ", " + rounded(v.z) + ")";
}

Json vector_json(const glm::dvec3& v)
{
    return {v.x, v.y, v.z};
}

glm::dvec3 parse_vector(const std::string& option, const std::string& text)
{
    const auto refuse = [&]() -> CLI::ValidationError {
        return CLI::ValidationError(option,
                                    "'" + text + "' is not three numbers with commas between them, like 0,1.5,-2");
    };
    glm::dvec3 v;
    const char* at = text.data();
    const char* const end = text.data() + text.size();
    for (int axis = 0; axis < 3; ++axis) {
        if (axis > 0 && (at == end || *at++ != ',')) throw refuse();
        if (at != end && *at == '+') ++at;
        const auto [behind, error] = std::from_chars(at, end, v[axis]);
        if (error != std::errc() || !std::isfinite(v[axis])) throw refuse();
        at = behind;
    }
    if (at != end) throw refuse();
    return v;
}

void print(const std::string& text)
{
    if (!(std::cout << text << std::flush)) throw std::runtime_error("the result cannot be written to standard output");
}

void print(const Json& document)
{
    print(document.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

}  // namespace kerf::tools
