#pragma once

#include <string>
#include <vector>

#include "common/mesh/plane.h"
#include "common/repair/proven_mesh.h"

namespace kerf::bench {

/// One of the report's fifteen models.
struct Model
{
    std::string name;
    ProvenMesh mesh;
};

/// The models of data/models in the order of the report's tables.
/// @throws io::FileError
const std::vector<Model>& models();

/// The report's ten cuts of a model: planes with seeded random directions through its middle.
std::vector<Plane> planes_of_model(const Model& model);

}  // namespace kerf::bench
