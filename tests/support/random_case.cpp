#include "support/random_case.h"

#include <rapidcheck.h>
#include <glm/geometric.hpp>

#include "common/shapes/shapes.h"

namespace kerf::core::test {

std::uint32_t below(std::uint32_t bound)
{
    return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange<std::uint32_t>(0, bound));
}

Motion any_motion(Random& random)
{
    Motion motion;
    motion.x = random.direction();
    motion.y = glm::normalize(glm::cross(motion.x, random.direction()));
    motion.z = glm::cross(motion.x, motion.y);
    motion.offset = 3.0 * random.uniform() * random.direction();
    return motion;
}

void move(IndexedMesh& mesh, const Motion& motion)
{
    for (Vertex& v : mesh.vertices) {
        v.position = glm::vec3(motion.turned(v.position) + motion.offset) + 0.0f;
        v.normal = glm::vec3(glm::normalize(motion.turned(v.normal)));
    }
}

Plane some_plane(const IndexedMesh& mesh, Random& random)
{
    const std::vector<NamedPlane> planes = planes_for(mesh, 1, random.next());
    return planes[random.below(static_cast<std::uint32_t>(planes.size()))].plane;
}

namespace {

void place(IndexedMesh& mesh, Random& random)
{
    const std::uint32_t kind = random.below(3);
    if (kind == 0) return;
    if (kind == 1)
        move(mesh, {{0, 1, 0}, {0, 0, -1}, {-1, 0, 0}, glm::dvec3(random.below(5), -1.0, 0.5)});
    else
        move(mesh, any_motion(random));
}

}  // namespace

Case make_case(std::string name, IndexedMesh mesh, std::uint64_t seed)
{
    Random random(seed);
    Case result{std::move(name), std::move(mesh), {}, seed};
    place(result.mesh, random);
    result.plane = some_plane(result.mesh, random);
    return result;
}

Case any_case()
{
    const std::uint64_t seed = *rc::gen::resize(rc::kNominalSize, rc::gen::arbitrary<std::uint64_t>());
    if (below(2) == 0) {
        const auto& fixtures = closed_shapes();
        const NamedMesh& fixture = fixtures[below(static_cast<std::uint32_t>(fixtures.size()))];
        return make_case(fixture.name, fixture.mesh, seed);
    }
    const auto& names = shapes::names();
    const std::string& name = names[below(static_cast<std::uint32_t>(names.size()))];
    return make_case(name, repaired(*shapes::make(name, 12 + below(200), seed)), seed);
}

}  // namespace kerf::core::test
