#include "bench/timed_shapes.h"

#include <utility>

#include "bench/checked_cut.h"
#include "common/repair/repair.h"
#include "common/shapes/shapes.h"

namespace kerf::bench {

std::vector<Plane> planes_of_shape(const IndexedMesh& shape)
{
    constexpr std::uint64_t kPlaneSeed = 99;
    constexpr std::uint32_t kPlanes = 5;
    return planes_through_the_middle(shape.bounds(), kPlanes, kPlaneSeed);
}

const ProvenMesh& timed_shape(const std::string& name, std::uint64_t triangles)
{
    constexpr std::uint64_t kSeed = 1;
    static std::pair<std::string, std::uint64_t> key;
    static ProvenMesh mesh;
    if (key != std::pair{name, triangles}) {
        mesh = {};
        TriangleSoup soup = shapes::asteroid(triangles, kSeed);
        if (name == "shuffled") soup = shapes::shuffled(std::move(soup), kSeed);
        mesh = repair(std::move(soup)).mesh;
        key = {name, triangles};
    }
    return mesh;
}

}  // namespace kerf::bench
