#pragma once

#include <kerf/plane.h>
#include <kerf/status.h>

#include <cstdint>
#include <glm/vec3.hpp>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

// How the program writes numbers and reads vectors.

namespace kerf::tools {

/// Members stay in the order in which they are added, so that people can read it.
using Json = nlohmann::ordered_json;

/// 1234567 as "1,234,567".
std::string grouped(std::uint64_t value);

/// With six significant digits.
std::string rounded(double value);

/// "3 triangles", "1 triangle".
std::string counted(std::uint64_t count, const std::string& noun);

std::string vector_text(const glm::dvec3& v);
Json vector_json(const glm::dvec3& v);

/// Three finite numbers separated by commas: "1,-2.5,0".
/// @throws CLI::ValidationError
glm::dvec3 parse_vector(const std::string& option, const std::string& text);

/// The same for a point, each coordinate rounded to float as those of meshes are: digits copied from a file mean that
/// vertex.
/// @throws CLI::ValidationError
glm::dvec3 parse_point(const std::string& option, const std::string& text);

/// The plane through three points, each "1,-2.5,0", rounded like those of parse_point(); they run counter-clockwise if they
/// are seen from its positive side.
/// @throws CLI::ValidationError
Plane parse_plane_through(const std::string& option, const std::vector<std::string>& points);

/// "x=0.5": the plane through that coordinate, rounded like a point's, across the axis; its normal points along it, or
/// against it with a minus in front.
/// @throws CLI::ValidationError
Plane parse_axis_plane(const std::string& option, const std::string& text);

/// JSON for people, over many lines, and as one line.
/// @{
std::string document_text(const Json& document);
std::string line_text(const Json& document);
/// @}

/// Standard output cannot be written. what() is one sentence.
class OutputError : public std::runtime_error
{
public:
    OutputError() : std::runtime_error("the result cannot be written to standard output") {}
};

/// Prints a JSON document, or what `text` holds, to standard output.
/// @throws OutputError
void print(const std::string& text);
void print(const Json& document);
/// A sentence on the standard error, as the program's own.
void complain(const std::string& sentence);

}  // namespace kerf::tools
