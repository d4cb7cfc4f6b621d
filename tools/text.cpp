#include "tools/text.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <optional>
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

namespace {

/// Reads a number at the beginning of a text that ends with a zero byte. Null if there is none; otherwise where it
/// ends. What is smaller than any double is 0, what is larger is infinite; words such as "inf" are no numbers.
const char* parse_number(const char* at, const char* end, double& value)
{
    if (at != end && *at == '+' && end - at > 1 && at[1] != '-') ++at;
    const auto [behind, error] = std::from_chars(at, end, value);
    if (error == std::errc::invalid_argument || (error == std::errc() && !std::isfinite(value))) return nullptr;
    if (error == std::errc::result_out_of_range) value = std::strtod(at, nullptr);
    return behind;
}

/// The same, rounded once from the decimal digits to what a mesh's coordinate of these digits is. Numbers that no mesh
/// has stay what they are.
const char* parse_coordinate(const char* at, const char* end, double& value)
{
    const char* const behind = parse_number(at, end, value);
    if (behind == nullptr) return nullptr;
    if (*at == '+') ++at;
    float coordinate = 0.0f;
    const auto [ignored, error] = std::from_chars(at, behind, coordinate);
    if (error == std::errc() || std::abs(value) < 1.0) value = double(coordinate);  // 0 below the smallest
    return behind;
}

using ParseNumber = const char* (*)(const char*, const char*, double&);

void refuse_too_large(const std::string& option, const std::string& text, double value)
{
    if (!std::isfinite(value))
        throw CLI::ValidationError(option, "'" + text + "' has a number that is too large; the largest is 1.7e308");
}

glm::dvec3 parse_three(const std::string& option, const std::string& text, ParseNumber parse)
{
    glm::dvec3 v;
    const char* at = text.data();
    const char* const end = text.data() + text.size();
    for (int axis = 0; axis < 3 && at != nullptr; ++axis) {
        if (axis > 0) at = at != end && *at == ',' ? at + 1 : nullptr;
        if (at != nullptr) at = parse(at, end, v[axis]);
    }
    if (at != end)
        throw CLI::ValidationError(option,
                                   "'" + text + "' is not three numbers with commas between them, like 0,1.5,-2");
    for (int axis = 0; axis < 3; ++axis) refuse_too_large(option, text, v[axis]);
    return v;
}

}  // namespace

glm::dvec3 parse_vector(const std::string& option, const std::string& text)
{
    return parse_three(option, text, parse_number);
}

glm::dvec3 parse_point(const std::string& option, const std::string& text)
{
    return parse_three(option, text, parse_coordinate);
}

Plane parse_plane_through(const std::string& option, const std::vector<std::string>& points)
{
    if (points.size() != 3) throw CLI::ValidationError(option, "it needs three points");
    std::vector<Vec3d> at;
    for (const std::string& text : points) {
        const glm::dvec3 p = parse_point(option, text);
        at.push_back({p.x, p.y, p.z});
    }
    const std::optional<Plane> plane = Plane::through(at[0], at[1], at[2]);
    if (!plane) throw CLI::ValidationError(option, "the three points lie on one line, or are too far away");
    return *plane;
}

Plane parse_axis_plane(const std::string& option, const std::string& text)
{
    const char* at = text.data();
    const char* const end = text.data() + text.size();
    const bool is_turned = at != end && *at == '-';
    if (is_turned) ++at;
    double offset = 0.0;
    if (end - at > 2 && *at >= 'x' && *at <= 'z' && at[1] == '=' && parse_coordinate(at + 2, end, offset) == end) {
        refuse_too_large(option, text, offset);
        const auto plane = *at == 'x' ? Plane::x(offset) : *at == 'y' ? Plane::y(offset) : Plane::z(offset);
        return is_turned ? plane.value().flipped() : plane.value();
    }
    throw CLI::ValidationError(option, "'" + text + "' is no axis with a coordinate, like x=0.5 or z=-2");
}

void print(const std::string& text)
{
    if (!(std::cout << text << std::flush)) throw OutputError();
}

void print(const Json& document)
{
    print(document_text(document));
}

std::string document_text(const Json& document)
{
    return document.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string line_text(const Json& document)
{
    return document.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

void complain(const std::string& sentence)
{
    std::cerr << "kerf: " << sentence << "\n";
}

}  // namespace kerf::tools
