#include "bench/models.h"

#include <kerf/io.h>

#include "bench/checked_cut.h"
#include "bench/objects.h"

namespace kerf::bench {

const std::vector<Model>& models()
{
    static const std::vector<Model> all = [] {
        std::vector<Model> loaded;
        for (const std::string name : {"car", "cube", "rook", "pedestal", "horse", "icosphere", "bishop", "cylinder",
                                       "pawn", "cone", "barrel", "king", "sphere", "queen", "monkey"})
            loaded.push_back({name, value_of(read_mesh((KERF_MODELS_DIR "/" + name + ".obj").c_str()))});
        return loaded;
    }();
    return all;
}

std::vector<Plane> planes_of_model(const Model& model)
{
    constexpr std::uint32_t kCuts = 10;
    constexpr std::uint64_t kPlaneSeed = 2024;
    return planes_through_the_middle(model.mesh.bounds(), kCuts, kPlaneSeed);
}

}  // namespace kerf::bench
