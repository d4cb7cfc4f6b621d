#include <algorithm>
#include <array>
#include <cstring>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "common/io/text_writer.h"
#include "common/io/write_formats.h"

namespace kerf::core::io {

namespace {

/// A v, vt or vn line for each different value, by its bits; indices count from 1.
template <std::size_t N>
class Lines
{
public:
    std::uint32_t index_of(const std::array<float, N>& value)
    {
        std::array<std::uint32_t, N> bits;
        std::memcpy(bits.data(), value.data(), sizeof bits);
        const auto [found, is_new] = index_.emplace(bits, static_cast<std::uint32_t>(index_.size() + 1));
        is_new_ = is_new;
        return found->second;
    }
    bool last_was_new() const { return is_new_; }

private:
    struct Hash
    {
        std::size_t operator()(const std::array<std::uint32_t, N>& bits) const
        {
            std::uint64_t h = 0;
            for (const std::uint32_t b : bits) h = ((h ^ b) * 0x9E3779B97F4A7C15u) ^ (h >> 29);
            return static_cast<std::size_t>(h ^ (h >> 32));
        }
    };

    std::unordered_map<std::array<std::uint32_t, N>, std::uint32_t, Hash> index_;
    bool is_new_ = false;
};

std::string_view group_name(TriangleKind kind)
{
    return kind == TriangleKind::surface ? "surface" : "cap";
}

/// Names for usemtl: one line each, none empty, no two equal. An unnamed material gets the name of the group that has
/// it. O(n), however many share a name.
std::vector<std::string> material_names(const IndexedMesh& mesh)
{
    std::vector<std::string> names;
    for (const Material& material : mesh.materials) {
        std::string name;
        for (const char c : material.name) name += c >= 0 && c < ' ' ? '_' : c;
        // The reader takes the line without blanks around it, and a backslash at its end would join the next one.
        const std::size_t first = name.find_first_not_of(' '), last = name.find_last_not_of(" \\");
        names.push_back(first == std::string::npos || last == std::string::npos ? std::string()
                                                                                : name.substr(first, last + 1 - first));
    }
    for (const TriangleGroup& group : mesh.groups)
        if (group.material < names.size() && names[group.material].empty())
            names[group.material] = group_name(group.kind);
    std::unordered_set<std::string> used;
    // For each name the number to try next. Those before it are taken, and stay so.
    std::unordered_map<std::string, std::uint32_t> next_number;
    for (std::string& name : names) {
        if (name.empty()) name = "material";
        if (used.insert(name).second) continue;
        const std::string base = name;
        std::uint32_t& number = next_number.try_emplace(base, 2).first->second;
        do name = base + "_" + std::to_string(number++);
        while (!used.insert(name).second);
    }
    return names;
}

}  // namespace

void write_obj(ByteSink& file, const IndexedMesh& mesh, const std::string& materials)
{
    TextWriter out(file);
    out << "# Written by Kerf\n";
    if (!materials.empty()) out << "mtllib " << materials << "\n";

    // One position for each point, so that other programs see the same connectivity.
    std::vector<std::uint32_t> line_of_point(mesh.point_count, 0);
    std::uint32_t position_count = 0;
    std::vector<std::array<std::uint32_t, 3>> corner(mesh.vertices.size());
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        std::uint32_t& line = line_of_point[mesh.points[i]];
        if (line == 0) {
            line = ++position_count;
            const glm::vec3& p = mesh.vertices[i].position;
            out << "v " << p.x << " " << p.y << " " << p.z << "\n";
        }
        corner[i][0] = line;
    }
    Lines<2> uvs;
    Lines<3> normals;
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        const glm::vec2& uv = mesh.vertices[i].uv;
        corner[i][1] = uvs.index_of({uv.x, uv.y});
        if (uvs.last_was_new()) out << "vt " << uv.x << " " << uv.y << "\n";
    }
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        const glm::vec3& n = mesh.vertices[i].normal;
        corner[i][2] = normals.index_of({n.x, n.y, n.z});
        if (normals.last_was_new()) out << "vn " << n.x << " " << n.y << " " << n.z << "\n";
    }

    const std::vector<std::string> names = material_names(mesh);
    const TriangleGroup* previous = nullptr;
    for (const TriangleGroup& group : mesh.groups) {
        if (group.count == 0) continue;
        const bool new_kind = previous == nullptr || previous->kind != group.kind;
        if (new_kind) out << "g " << group_name(group.kind) << "\n";
        if (new_kind || previous->material != group.material) out << "usemtl " << names[group.material] << "\n";
        for (std::uint32_t t = group.first; t < group.first + group.count; ++t) {
            out << "f";
            for (const std::uint32_t v : mesh.triangles[t])
                out << " " << corner[v][0] << "/" << corner[v][1] << "/" << corner[v][2];
            out << "\n";
        }
        previous = &group;
    }
    out.flush();
}

bool needs_mtl(const IndexedMesh& mesh)
{
    for (const Material& material : mesh.materials)
        if (material.colour != Material{}.colour || !material.texture.empty()) return true;
    return false;
}

std::filesystem::path mtl_path(const std::filesystem::path& obj_path)
{
    return std::filesystem::path(obj_path).replace_extension(".mtl");
}

bool can_name_mtl(const std::filesystem::path& obj_path)
{
    const std::string name = mtl_path(obj_path).filename().string();
    return name.front() != ' ' &&
           std::none_of(name.begin(), name.end(), [](unsigned char c) { return c < ' ' || c == 0x7F; });
}

void write_mtl(ByteSink& file, const IndexedMesh& mesh)
{
    TextWriter out(file);
    out << "# Written by Kerf\n";
    const std::vector<std::string> names = material_names(mesh);
    for (std::size_t i = 0; i < mesh.materials.size(); ++i) {
        const Material& material = mesh.materials[i];
        const glm::vec4& c = material.colour;
        out << "newmtl " << names[i] << "\nKd " << c.r << " " << c.g << " " << c.b << "\nd " << c.a << "\n";
        if (!material.texture.empty() && material.texture.find_first_of("\r\n") == std::string::npos)
            out << "map_Kd " << material.texture << "\n";
    }
    out.flush();
}

}  // namespace kerf::core::io
