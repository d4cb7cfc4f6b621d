#include "tools/dice_planes.h"

#include <CLI/CLI.hpp>
#include <cmath>
#include <fstream>
#include <sstream>

#include "tools/flat_mesh.h"
#include "tools/heights.h"
#include "tools/mesh_files.h"
#include "tools/text.h"

namespace kerf::tools {

namespace {

constexpr unsigned kMostLayers = 1000;  // along an axis

constexpr const char* kAxisNames = "xyz";

}  // namespace

void PlaneFamilies::add_to_direction(const Normal& normal, double height)
{
    const auto unit = [](const Normal& n) { return to_glm(Plane::at(Point(0, 0, 0), n)->normal()); };
    const glm::dvec3 own = unit(normal);
    for (std::size_t i = 0; i < normals_.size(); ++i) {
        const glm::dvec3 other = unit(normals_[i]);
        if (own != other && own != -other) continue;
        heights_[i].push_back(own == other ? height : -height);
        return;
    }
    add(normal, {height});
}

PlaneFamilies grid_of(const Box& box, const glm::uvec3& layers)
{
    const glm::dvec3 lo = to_glm(box.lo), hi = to_glm(box.hi);
    PlaneFamilies families;
    for (int axis = 0; axis < 3; ++axis) {
        std::vector<double> heights;
        for (unsigned i = 1; i < layers[axis]; ++i)
            heights.push_back(lo[axis] + (hi[axis] - lo[axis]) * double(i) / double(layers[axis]));
        glm::dvec3 normal{0.0};
        normal[axis] = 1.0;
        families.add(Normal(normal), std::move(heights));
    }
    return families;
}

glm::uvec3 layers_of_size(const Box& box, const glm::dvec3& size)
{
    const glm::dvec3 extent = glm::dvec3(to_glm(box.hi)) - glm::dvec3(to_glm(box.lo));
    glm::uvec3 layers{1};
    for (int axis = 0; axis < 3; ++axis) {
        if (size[axis] == 0.0) continue;
        const double count = std::max(1.0, std::ceil(extent[axis] / size[axis]));
        if (!(count <= double(kMostLayers)))
            throw std::runtime_error("cells of " + rounded(size[axis]) + " are more than " +
                                     std::to_string(kMostLayers) + " along " + kAxisNames[axis] +
                                     "; choose larger ones");
        layers[axis] = static_cast<unsigned>(count);
    }
    return layers;
}

PlaneFamilies read_planes(const std::string& path)
{
    std::ifstream file(path);
    if (!file) throw FileError(path + ": it cannot be read");
    PlaneFamilies families;
    std::string line;
    for (std::size_t number = 1; std::getline(file, line); ++number) {
        const std::size_t first = line.find_first_not_of(" \t\r");
        if (first == std::string::npos || line[first] == '#') continue;
        std::istringstream numbers(line);
        glm::dvec3 normal{0.0};
        double height = 0.0;
        std::string rest;
        const bool has_four = bool(numbers >> normal.x >> normal.y >> normal.z >> height) && !(numbers >> rest);
        if (!has_four || !Plane::at(Point(0, 0, 0), Normal(normal)) || !std::isfinite(height))
            throw FileError(path + ": line " + std::to_string(number) +
                            " is not a plane: it needs a normal of three numbers, and its distance from the origin");
        families.add_to_direction(Normal(normal), height);
    }
    return families;
}

glm::uvec3 parse_grid(const std::string& option, const std::string& text)
{
    std::istringstream numbers(text);
    glm::ivec3 layers{0};
    char by = 0, by_too = 0;
    std::string rest;
    const bool has_three = bool(numbers >> layers.x >> by >> layers.y >> by_too >> layers.z) && !(numbers >> rest);
    for (int axis = 0; axis < 3; ++axis)
        if (!has_three || by != 'x' || by_too != 'x' || layers[axis] < 1 || layers[axis] > int(kMostLayers))
            throw CLI::ValidationError(option, "'" + text + "' is not of the form AxBxC, such as 4x4x2, with 1 to " +
                                                   std::to_string(kMostLayers) + " cells along each axis");
    return glm::uvec3(layers);
}

glm::dvec3 parse_size(const std::string& option, const std::string& text)
{
    const glm::dvec3 size = parse_vector(option, text);
    if (size.x < 0.0 || size.y < 0.0 || size.z < 0.0)
        throw CLI::ValidationError(option, "'" + text + "' has a size below 0");
    return size;
}

}  // namespace kerf::tools
