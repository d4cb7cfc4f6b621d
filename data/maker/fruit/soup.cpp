#include "maker/fruit/soup.h"

#include <algorithm>
#include <array>
#include <map>
#include <stdexcept>
#include <string>

#include "maker/corners.h"
#include "maker/fruit/fruit.h"
#include "maker/triangulate.h"

namespace kerf::maker {
namespace {

core::Material material_named(std::string_view name)
{
    const auto found = std::find_if(kFruitMaterials.begin(), kFruitMaterials.end(),
                                    [&](const FruitMaterial& m) { return m.name == name; });
    if (found == kFruitMaterials.end()) throw std::logic_error("there is no material '" + std::string(name) + "'");
    core::Material material;
    material.name = name;
    material.colour = glm::vec4(found->colour, 1.0f);
    return material;
}

/// Vertices and materials, each once.
class SoupMaker
{
public:
    explicit SoupMaker(const PolyMesh& source) : mesh_(with_rounded_points(source)), normals_(corner_normals(mesh_)) {}

    core::TriangleSoup make()
    {
        for (std::size_t f = 0; f < mesh_.facets.size(); ++f) add(f);
        return std::move(soup_);
    }

private:
    void add(std::size_t f)
    {
        const Facet& facet = mesh_.facets[f];
        std::vector<glm::dvec3> loop;
        std::vector<std::uint32_t> corners;
        for (std::size_t i = 0; i < facet.points.size(); ++i) {
            const glm::dvec3 p = mesh_.points[std::size_t(facet.points[i])];
            loop.push_back(p);
            const glm::dvec2 uv = facet.uvs.empty() ? box_uv(p, mesh_.facet_normal(facet)) : facet.uvs[i];
            corners.push_back(vertex(p, normals_[f][i], uv));
        }
        for (const auto& t : triangulate(loop)) {
            soup_.triangles.push_back(
                {corners[std::size_t(t[0])], corners[std::size_t(t[1])], corners[std::size_t(t[2])]});
            soup_.triangle_materials.push_back(material(facet.material));
        }
    }

    std::uint32_t vertex(const glm::dvec3& p, const glm::dvec3& n, const glm::dvec2& uv)
    {
        const auto number = [](double x) { return static_cast<float>(rounded(x)); };
        const std::array<float, 8> key{number(p.x), number(p.y), number(p.z),  number(n.x),
                                       number(n.y), number(n.z), number(uv.x), number(uv.y)};
        const auto [at, is_new] = vertices_.try_emplace(key, std::uint32_t(soup_.vertices.size()));
        if (is_new) soup_.vertices.push_back({{key[0], key[1], key[2]}, {key[3], key[4], key[5]}, {key[6], key[7]}});
        return at->second;
    }

    std::uint32_t material(std::string_view name)
    {
        for (std::size_t m = 0; m < soup_.materials.size(); ++m)
            if (soup_.materials[m].name == name) return std::uint32_t(m);
        soup_.materials.push_back(material_named(name));
        return std::uint32_t(soup_.materials.size() - 1);
    }

    const PolyMesh mesh_;
    const std::vector<std::vector<glm::dvec3>> normals_;
    std::map<std::array<float, 8>, std::uint32_t> vertices_;
    core::TriangleSoup soup_;
};

}  // namespace

core::TriangleSoup soup_of(const PolyMesh& mesh)
{
    return SoupMaker(mesh).make();
}

}  // namespace kerf::maker
