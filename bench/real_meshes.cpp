#include "bench/real_meshes.h"

#include <kerf/io.h>
#include <kerf/shapes.h>

#include <filesystem>
#include <utility>

#include "bench/objects.h"

namespace kerf::bench {

const Mesh& mesh_of(const RealMesh& real)
{
    static std::pair<std::string, Mesh> last;
    if (last.first != real.name) {
        last.second = {};
        last.second = real.file.empty()
                          ? value_of(make_shape(real.shape.c_str(), real.triangles))
                          : value_of(read_mesh((std::filesystem::path(KERF_SHARED_MESHES_DIR) / real.file).c_str()));
        last.first = real.name;
    }
    return last.second;
}

std::vector<RealMesh> real_meshes()
{
    std::vector<RealMesh> all;
    for (const auto& [name, file] : {std::pair("brain", "mni_t1iso60_804k.ply"), std::pair("skull", "skull.obj"),
                                     std::pair("cheese", "cheese.off"), std::pair("sponge", "mengerSponge3.glb")})
        if (std::filesystem::exists(std::filesystem::path(KERF_SHARED_MESHES_DIR) / file))
            all.push_back({name, file, "", 0});
    all.push_back({"folded", "", "spiral_wall", 100'000});
    all.push_back({"tunnels", "", "menger_sponge", 20'000});
    return all;
}

}  // namespace kerf::bench
