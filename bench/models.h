#pragma once

#include <string>
#include <vector>

#include "common/indexed_mesh.h"

namespace kerf::bench {

/// One of the report's fifteen models.
struct Model
{
    std::string name;
    IndexedMesh mesh;
};

/// The models of data/models in the order of the report's tables.
/// @throws io::FileError
const std::vector<Model>& models();

}  // namespace kerf::bench
