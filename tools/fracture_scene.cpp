#include "tools/fracture_scene.h"

#include <kerf/io.h>

#include <algorithm>
#include <utility>

#include "tools/mesh_files.h"

namespace kerf::tools {

namespace {

/// With as many digits as the last one needs, so that names sort.
std::string name_of(std::size_t number, std::size_t count)
{
    const std::string digits = std::to_string(number);
    const std::size_t width = std::max<std::size_t>(3, std::to_string(count - 1).size());
    std::string name("piece.");
    name.append(width - digits.size(), '0');
    return name.append(digits);
}

/// For each piece those that it touches. O(pieces + bonds)
std::vector<Json> neighbours_of(const std::vector<FracturePiece>& pieces, std::span<const FractureBond> bonds)
{
    std::vector<Json> neighbours(pieces.size(), Json::array());
    const auto add = [&](std::uint32_t of, std::uint32_t other, const FractureBond& bond, const glm::dvec3& normal) {
        neighbours[of].push_back({{"piece", pieces[other].name},
                                  {"area", bond.area},
                                  {"centre", vector_json(to_glm(bond.centre))},
                                  {"normal", vector_json(normal)}});
    };
    for (const FractureBond& bond : bonds) {
        add(bond.first, bond.second, bond, to_glm(bond.normal));
        add(bond.second, bond.first, bond, -to_glm(bond.normal));
    }
    return neighbours;
}

std::string extras_of(const FracturePiece& piece, Json neighbours, const std::string& material)
{
    return Json{{"cells", piece.cells},
                {"volume", piece.facts.volume},
                {"centre_of_mass", vector_json(piece.facts.centre_of_mass)},
                {"neighbours", std::move(neighbours)},
                {"interior_material", material}}
        .dump();
}

}  // namespace

std::vector<FracturePiece> pieces_of(Fracture& fracture)
{
    std::vector<FracturePiece> pieces;
    for (std::size_t i = 0; Object* const object = fracture.piece(i); ++i) {
        const auto cells = fracture.cells(i);
        FracturePiece& piece = pieces.emplace_back(
            FracturePiece{name_of(i, fracture.count()), mesh_of(*object), {cells.begin(), cells.end()}, {}});
        piece.facts = measure_fragment(flat(piece.mesh), object->mass_properties());
    }
    return pieces;
}

Json contact_json(const FractureBond& bond)
{
    return {{"pieces", {bond.first, bond.second}},
            {"area", bond.area},
            {"centre", vector_json(to_glm(bond.centre))},
            {"normal", vector_json(to_glm(bond.normal))}};
}

std::string scene_of(const std::vector<FracturePiece>& pieces, std::span<const FractureBond> bonds,
                     const glm::dvec3& centre, double explode, const std::string& material)
{
    std::vector<Json> neighbours = neighbours_of(pieces, bonds);
    std::vector<std::string> extras;
    for (std::size_t i = 0; i < pieces.size(); ++i)
        extras.push_back(extras_of(pieces[i], std::move(neighbours[i]), material));
    std::vector<SceneNode> nodes;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const glm::dvec3 away = explode * (pieces[i].facts.centre_of_mass - centre);
        nodes.push_back({pieces[i].name.c_str(), &pieces[i].mesh, {away.x, away.y, away.z}, extras[i].c_str()});
    }
    const Result<FileBytes> file = scene_file_bytes(nodes);
    if (!file) throw std::runtime_error(file.reason());
    const auto bytes = file->bytes();
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

}  // namespace kerf::tools
