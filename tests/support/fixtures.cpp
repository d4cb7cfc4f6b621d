#include "support/fixtures.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <stdexcept>

#include "common/repair/repair.h"
#include "common/shapes/shapes.h"
#include "support/brief.h"

namespace kerf::core::test {

IndexedMesh repaired(TriangleSoup soup)
{
    Repaired result = repair(std::move(soup));
    if (!result.error.empty()) throw std::runtime_error(result.error);
    return *std::move(result.mesh);
}

TriangleSoup joined(TriangleSoup a, const TriangleSoup& b)
{
    const auto offset = static_cast<std::uint32_t>(a.vertices.size());
    a.vertices.insert(a.vertices.end(), b.vertices.begin(), b.vertices.end());
    for (const Triangle& t : b.triangles) a.triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
    return a;
}

TriangleSoup with_colours(TriangleSoup soup)
{
    VertexStream stream{"colour", 3, {}};
    for (const Vertex& v : soup.vertices)
        for (int axis = 0; axis < 3; ++axis) stream.values.push_back(0.5f + 0.25f * v.position[axis]);
    soup.streams.push_back(std::move(stream));
    return soup;
}

TriangleSoup with_two_materials(TriangleSoup soup)
{
    soup.materials = {{"lower", glm::vec4(1.0f), {}}, {"upper", glm::vec4(1.0f), {}}};
    soup.triangle_materials.clear();
    for (const Triangle& t : soup.triangles)
        soup.triangle_materials.push_back(soup.vertices[t[0]].position.z > 0.1f ? 1u : 0u);
    return soup;
}

namespace {

TriangleSoup moved(TriangleSoup soup, const glm::vec3& by)
{
    for (Vertex& v : soup.vertices) v.position += by;
    return soup;
}

std::vector<NamedMesh> make_closed_shapes()
{
    using namespace shapes;
    std::vector<NamedMesh> all;
    const auto add = [&](std::string name, TriangleSoup soup) {
        all.push_back({std::move(name), repaired(std::move(soup))});
    };
    add("cube", box({1, 1, 1}, {1, 1, 1}));
    add("grid_cube", box({2, 2, 2}, {4, 4, 4}));
    add("icosphere", icosphere(1.0f, 4));
    add("uv_sphere", with_colours(uv_sphere(1.0f, 12, 8)));
    add("cylinder", cylinder(1.0f, 2.0f, 12, 2));
    add("cone", cone(1.0f, 2.0f, 12));
    add("torus", with_two_materials(torus(1.0f, 0.4f, 16, 10)));
    add("pipe", pipe(1.0f, 0.6f, 2.0f, 12, 2));
    add("comb", comb(5));
    add("spiral_wall", spiral_wall(2.0f, 12));
    add("menger_sponge", menger_sponge(1));
    add("sphere_in_sphere", sphere_in_sphere(1.0f, 0.5f, 3));
    add("two_spheres", joined(icosphere(1.0f, 3), moved(icosphere(0.7f, 3), {3, 0.25f, 0})));
    add("overlapping_spheres", joined(icosphere(1.0f, 3), moved(icosphere(0.8f, 3), {0.75f, 0.25f, 0.125f})));
    add("asteroid", with_colours(asteroid(500, 7)));
    return all;
}

std::vector<NamedMesh> make_open_shapes()
{
    std::vector<NamedMesh> all;
    const auto without = [](TriangleSoup soup, auto&& is_dropped) {
        std::erase_if(soup.triangles, [&](const Triangle& t) {
            return is_dropped(
                (soup.vertices[t[0]].position + soup.vertices[t[1]].position + soup.vertices[t[2]].position) / 3.0f);
        });
        return soup;
    };
    all.push_back(
        {"bowl", repaired(without(shapes::icosphere(1.0f, 4), [](const glm::vec3& p) { return p.z > 0.3f; }))});
    all.push_back({"box_without_a_side", repaired(without(shapes::box({2, 2, 2}, {2, 2, 2}),
                                                          [](const glm::vec3& p) { return p.x > 0.99f; }))});
    all.push_back({"torus_with_holes", repaired(without(shapes::torus(1.0f, 0.4f, 16, 10),
                                                        [](const glm::vec3& p) { return std::abs(p.x) > 1.2f; }))});
    return all;
}

}  // namespace

const std::vector<NamedMesh>& closed_shapes()
{
    static const std::vector<NamedMesh> all = make_closed_shapes();
    return all;
}

const IndexedMesh& closed_shape(const std::string& name)
{
    for (const NamedMesh& shape : closed_shapes())
        if (shape.name == name) return shape.mesh;
    throw std::runtime_error("there is no closed shape called " + name);
}

const std::vector<NamedMesh>& open_shapes()
{
    static const std::vector<NamedMesh> all = make_open_shapes();
    return all;
}

std::uint32_t Random::below(std::uint32_t bound)
{
    return static_cast<std::uint32_t>(next() % bound);
}

glm::dvec3 Random::direction()
{
    for (;;) {
        const glm::dvec3 v{2 * uniform() - 1, 2 * uniform() - 1, 2 * uniform() - 1};
        const double square = glm::dot(v, v);
        if (square > 1e-4 && square <= 1.0) return v / std::sqrt(square);
    }
}

std::vector<NamedPlane> planes_for(const IndexedMesh& mesh, std::uint32_t count, std::uint64_t seed)
{
    Random random(seed);
    std::vector<NamedPlane> planes;
    const auto add = [&](std::string name, const glm::dvec3& point, const glm::dvec3& normal) {
        if (const auto plane = Plane::through(point, normal)) planes.push_back({std::move(name), *plane});
    };
    const auto corner = [&](std::uint32_t triangle, std::size_t i) {
        return glm::dvec3(mesh.vertices[mesh.triangles[triangle][i]].position);
    };
    const Box box = mesh.bounds();
    const glm::dvec3 centre = box.centre(), size = glm::dvec3(box.hi) - glm::dvec3(box.lo);
    for (int axis = 0; axis < 3; ++axis) {
        glm::dvec3 normal{0};
        normal[axis] = 1;
        add("through the centre along axis " + std::to_string(axis), centre, normal);
    }
    add("through the centre along (1,1,1)", centre, {1, 1, 1});

    const auto triangle_count = static_cast<std::uint32_t>(mesh.triangles.size());
    const std::uint32_t rounds = kBrief ? (count + 1) / 2 : count;
    for (std::uint32_t i = 0; i < rounds; ++i) {
        const std::string number = " #" + std::to_string(i);
        const glm::dvec3 jitter{random.uniform() - 0.5, random.uniform() - 0.5, random.uniform() - 0.5};
        add("random" + number, centre + 0.5 * jitter * size, random.direction());

        const std::uint32_t t = random.below(triangle_count), u = random.below(triangle_count);
        add("through a vertex" + number, corner(t, 0), random.direction());
        const glm::dvec3 edge = corner(t, 1) - corner(t, 0);
        add("along an edge" + number, corner(t, 0), glm::cross(edge, random.direction()));
        add("through three vertices" + number, corner(t, 0), glm::cross(edge, corner(u, 2) - corner(t, 0)));
        add("in a face" + number, corner(t, 0), glm::cross(edge, corner(t, 2) - corner(t, 0)));
        glm::dvec3 axis{0};
        axis[static_cast<int>(random.below(3))] = random.below(2) ? 1 : -1;
        add("through a vertex along an axis" + number, corner(u, 1), axis);
    }
    return planes;
}

}  // namespace kerf::core::test
