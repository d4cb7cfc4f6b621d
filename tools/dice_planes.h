#pragma once

#include <kerf/dice.h>

#include <glm/vec3.hpp>
#include <string>
#include <vector>

// The planes of `kerf dice`.

namespace kerf::tools {

/// Families of parallel planes that hold their own heights.
class PlaneFamilies
{
public:
    void add(const Normal& normal, std::vector<double> heights)
    {
        normals_.push_back(normal);
        heights_.push_back(std::move(heights));
    }

    /// To the family of this direction or the opposite one, if there is one: heights are distances from the origin along
    /// the normal.
    void add_to_direction(const Normal& normal, double height);

    /// Valid as long as this, and until one is added.
    std::vector<DicePlanes> planes() const
    {
        std::vector<DicePlanes> planes;
        for (std::size_t i = 0; i < normals_.size(); ++i) planes.push_back({normals_[i], heights_[i]});
        return planes;
    }

private:
    std::vector<Normal> normals_;
    std::vector<std::vector<double>> heights_;
};

/// So many layers of one thickness along each axis of a box.
PlaneFamilies grid_of(const Box& box, const glm::uvec3& layers);

/// As many layers along each axis as make them no thicker than that; 1 along an axis with 0.
/// @throws std::runtime_error  they are more than a mesh is worth dicing to
glm::uvec3 layers_of_size(const Box& box, const glm::dvec3& size);

/// Lines of four numbers: a normal, and the distance from the origin along it. Empty lines and lines that begin with # are
/// passed over. Planes of one direction, or of opposite ones, are a family.
/// @throws FileError  that names the line
PlaneFamilies read_planes(const std::string& path);

/// "4x4x2". @throws CLI::ValidationError
glm::uvec3 parse_grid(const std::string& option, const std::string& text);
/// "200,200,180", none below 0. @throws CLI::ValidationError
glm::dvec3 parse_size(const std::string& option, const std::string& text);

}  // namespace kerf::tools
