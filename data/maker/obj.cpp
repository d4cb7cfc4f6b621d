#include "maker/obj.h"

#include <charconv>
#include <map>
#include <utility>

#include "maker/corners.h"
#include "maker/triangulate.h"

namespace kerf::maker {
namespace {

std::string text(double x)
{
    char buffer[32];
    const auto end = std::to_chars(buffer, buffer + sizeof buffer, float(rounded(x)));
    return {buffer, end.ptr};
}

/// Lines of one kind, each written once; gives their OBJ numbers, which start at 1.
class Lines
{
public:
    explicit Lines(std::string keyword) : keyword_(std::move(keyword)) {}

    int number(std::initializer_list<double> values)
    {
        std::string line = keyword_;
        for (const double v : values) line += ' ' + text(v);
        const auto [at, is_new] = numbers_.try_emplace(line + '\n', int(numbers_.size()) + 1);
        if (is_new) all_ += at->first;
        return at->second;
    }

    const std::string& all() const { return all_; }

private:
    std::string keyword_;
    std::string all_;
    std::map<std::string, int> numbers_;
};

}  // namespace

int triangle_count(const PolyMesh& mesh)
{
    int count = 0;
    for (const Facet& facet : mesh.facets) count += int(facet.points.size()) - 2;
    return count;
}

std::string obj_text(const PolyMesh& source, const std::string& name)
{
    const PolyMesh mesh = with_rounded_points(source);
    const auto normals = corner_normals(mesh);

    // Points are never merged by position: two that fall together would show up as a closedness fault in the tests.
    std::string positions;
    for (const glm::dvec3& p : mesh.points) positions += "v " + text(p.x) + ' ' + text(p.y) + ' ' + text(p.z) + '\n';
    Lines uv_lines("vt"), normal_lines("vn");
    std::string faces;
    std::string_view material;
    for (std::size_t f = 0; f < mesh.facets.size(); ++f) {
        const Facet& facet = mesh.facets[f];
        if (facet.material != material) {
            material = facet.material;
            faces += "usemtl " + std::string(material) + '\n';
        }
        std::vector<glm::dvec3> loop;
        std::vector<std::string> corners;
        for (std::size_t i = 0; i < facet.points.size(); ++i) {
            loop.push_back(mesh.points[std::size_t(facet.points[i])]);
            const glm::dvec3& n = normals[f][i];
            const glm::dvec2 uv = facet.uvs.empty() ? box_uv(loop.back(), mesh.facet_normal(facet)) : facet.uvs[i];
            corners.push_back(std::to_string(facet.points[i] + 1) + '/' +
                              std::to_string(uv_lines.number({uv.x, uv.y})) + '/' +
                              std::to_string(normal_lines.number({n.x, n.y, n.z})));
        }
        for (const auto& triangle : triangulate(loop)) {
            faces += 'f';
            for (const int c : triangle) faces += ' ' + corners[std::size_t(c)];
            faces += '\n';
        }
    }
    return "# Kerf model, made by make_models. MIT licence.\nmtllib models.mtl\no " + name + '\n' + positions +
           uv_lines.all() + normal_lines.all() + faces;
}

}  // namespace kerf::maker
