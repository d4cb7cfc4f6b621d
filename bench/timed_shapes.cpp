#include "bench/timed_shapes.h"

#include <utility>

#include "common/assemble.h"
#include "common/shapes.h"

namespace kerf::bench {

const IndexedMesh& timed_shape(const std::string& name, std::uint64_t triangles)
{
    constexpr std::uint64_t kSeed = 1;
    static std::pair<std::string, std::uint64_t> key;
    static IndexedMesh mesh;
    if (key != std::pair{name, triangles}) {
        mesh = {};
        TriangleSoup soup = shapes::asteroid(triangles, kSeed);
        if (name == "shuffled") soup = shapes::shuffled(std::move(soup), kSeed);
        mesh = assemble(std::move(soup)).mesh;
        key = {name, triangles};
    }
    return mesh;
}

}  // namespace kerf::bench
