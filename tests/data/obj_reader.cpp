#include "data/obj_reader.h"

#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>

namespace kerf::core::test {
namespace {

template <std::size_t N>
std::array<double, N> numbers(std::istringstream& line)
{
    std::array<double, N> values{};
    for (double& value : values) {
        std::string word;
        line >> word;
        std::size_t used = 0;
        value = std::stof(word, &used);  // rounded to float as a renderer would
        if (used != word.size()) throw std::runtime_error("bad number " + word);
    }
    return values;
}

ObjFile::Corner corner(const std::string& word, const ObjFile& file)
{
    std::istringstream text(word);
    ObjFile::Corner c{};
    char slash[2]{};
    if (!(text >> c.position >> slash[0] >> c.uv >> slash[1] >> c.normal) || slash[0] != '/' || slash[1] != '/')
        throw std::runtime_error("bad corner " + word);
    --c.position, --c.uv, --c.normal;
    const auto in = [](int i, std::size_t size) { return i >= 0 && std::size_t(i) < size; };
    if (!in(c.position, file.positions.size()) || !in(c.uv, file.uvs.size()) || !in(c.normal, file.normals.size()))
        throw std::runtime_error("corner out of range " + word);
    return c;
}

}  // namespace

ObjFile read_obj(const std::string& path)
{
    std::istringstream text(read_bytes(path));
    ObjFile file;
    std::string row;
    while (std::getline(text, row)) {
        std::istringstream line(row);
        std::string keyword, word;
        line >> keyword;
        if (keyword == "v") {
            file.positions.push_back(numbers<3>(line));
        } else if (keyword == "vn") {
            file.normals.push_back(numbers<3>(line));
        } else if (keyword == "vt") {
            file.uvs.push_back(numbers<2>(line));
        } else if (keyword == "f") {
            std::array<ObjFile::Corner, 3> triangle{};
            for (auto& c : triangle) {
                line >> word;
                c = corner(word, file);
            }
            file.triangles.push_back(triangle);
        } else if (keyword == "usemtl") {
            line >> word;
            file.materials.push_back(word);
        } else if (keyword == "mtllib") {
            line >> file.library;
        } else if (keyword != "#" && keyword != "o") {
            throw std::runtime_error(path + ": unexpected " + keyword);
        }
        if (keyword == "f" && line >> word) throw std::runtime_error(path + ": not a triangle");
    }
    return file;
}

std::string read_bytes(const std::string& path)
{
    std::ifstream file(path, std::ios::binary);
    if (!file) throw std::runtime_error("cannot read " + path);
    return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace kerf::core::test
