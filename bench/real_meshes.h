#pragma once

#include <kerf/mesh.h>

#include <string>
#include <vector>

// Meshes that are not round, with sections of many loops. Scanned and modelled ones are read from a folder beside the
// project, if it is there. In any case there are generated ones of the same kinds: `folded`, a wall that is rolled up,
// and `tunnels`, a sponge.

namespace kerf::bench {

struct RealMesh
{
    std::string name;
    std::string file;  ///< in the folder; empty: `shape` is made
    std::string shape;
    std::uint64_t triangles = 0;  ///< about so many
};

/// Those that are there.
std::vector<RealMesh> real_meshes();

/// Read or made when it is first asked for. The last one is kept: benchmarks of one follow one another.
const Mesh& mesh_of(const RealMesh& real);

}  // namespace kerf::bench
