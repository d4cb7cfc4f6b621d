#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <nlohmann/json.hpp>
#include <string>

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

/// Prints a JSON document, or what `text` holds, to standard output.
/// @throws std::runtime_error  it cannot be written
void print(const std::string& text);
void print(const Json& document);

}  // namespace kerf::tools
