#pragma once

#include <kerf/mesh.h>
#include <kerf/plane.h>

#include <string>
#include <vector>

namespace kerf::bench {

/// One of the report's fifteen models.
struct Model
{
    std::string name;
    Mesh mesh;
};

/// The models of data/models in the order of the report's tables.
/// @throws std::runtime_error  a file cannot be used
const std::vector<Model>& models();

/// The report's ten cuts of a model: planes with seeded random directions through its middle.
std::vector<Plane> planes_of_model(const Model& model);

}  // namespace kerf::bench
