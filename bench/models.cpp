#include "bench/models.h"

#include <filesystem>

#include "bench/checked_cut.h"
#include "common/io/mesh_file.h"

namespace kerf::bench {

const std::vector<Model>& models()
{
    static const std::vector<Model> all = [] {
        std::vector<Model> loaded;
        for (const char* name : {"car", "cube", "rook", "pedestal", "horse", "icosphere", "bishop", "cylinder", "pawn",
                                 "cone", "barrel", "king", "sphere", "queen", "monkey"})
            loaded.push_back(
                {name, io::read_mesh(std::filesystem::path(KERF_MODELS_DIR) / (std::string(name) + ".obj")).mesh});
        return loaded;
    }();
    return all;
}

std::vector<Plane> planes_of_model(const Model& model)
{
    constexpr std::uint32_t kCuts = 10;
    constexpr std::uint64_t kPlaneSeed = 2024;
    return planes_through_the_middle(model.mesh->bounds(), kCuts, kPlaneSeed);
}

}  // namespace kerf::bench
