#include "tools/fragment_facts.h"

#include <glm/geometric.hpp>

#include "tools/open_edges.h"

namespace kerf::tools {

namespace {

double area_of(const FlatMesh& mesh, const Triangle& t)
{
    const auto position = [&](std::size_t i) { return glm::dvec3(mesh.vertices[t[i]].position); };
    return 0.5 * glm::length(glm::cross(position(1) - position(0), position(2) - position(0)));
}

}  // namespace

void FragmentFacts::add(const FragmentFacts& other)
{
    const double whole = volume + other.volume;
    if (whole != 0.0)
        centre_of_mass = (volume * centre_of_mass + other.volume * other.centre_of_mass) / whole;
    else if (triangles == 0)
        centre_of_mass = other.centre_of_mass;
    triangles += other.triangles;
    surface_area += other.surface_area;
    cap_area += other.cap_area;
    volume = whole;
    closed = closed && other.closed;
}

FragmentFacts measure_fragment(const FlatMesh& mesh, const MassProperties& mass)
{
    FragmentFacts facts;
    facts.triangles = mesh.triangles.size();
    for (const TriangleGroup& group : mesh.groups) {
        double& area = group.kind == TriangleKind::cap ? facts.cap_area : facts.surface_area;
        for (std::uint32_t t = group.first; t < group.first + group.count; ++t)
            area += area_of(mesh, mesh.triangles[t]);
    }
    facts.volume = mass.volume;
    facts.centre_of_mass = to_glm(mass.centre);
    facts.closed = open_edges(mesh) == 0;
    return facts;
}

Json facts_json(const FragmentFacts& facts)
{
    return {
        {"triangles", facts.triangles}, {"area", facts.area()},   {"surface_area", facts.surface_area},
        {"cap_area", facts.cap_area},   {"volume", facts.volume}, {"centre_of_mass", vector_json(facts.centre_of_mass)},
        {"closed", facts.closed}};
}

std::string facts_text(const FragmentFacts& facts)
{
    return counted(facts.triangles, "triangle") + ", area " + rounded(facts.area()) + ", volume " +
           rounded(facts.volume) + (facts.closed ? ", closed" : ", not closed");
}

}  // namespace kerf::tools
