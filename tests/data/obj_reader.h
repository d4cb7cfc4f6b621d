#pragma once

#include <array>
#include <string>
#include <vector>

namespace kerf::core::test {

using Vec2 = std::array<double, 2>;
using Vec3 = std::array<double, 3>;

/// A triangle mesh as its OBJ file has it. Numbers count from 0.
struct ObjFile
{
    struct Corner
    {
        int position, uv, normal;
    };

    std::vector<Vec3> positions, normals;
    std::vector<Vec2> uvs;
    std::vector<std::array<Corner, 3>> triangles;
    std::vector<std::string> materials;  ///< every usemtl, in order
    std::string library;
};

/// Reads the part of OBJ that the models use and nothing else; anything unexpected throws std::runtime_error. It shares
/// no code with the writer or with kerf::io.
ObjFile read_obj(const std::string& path);

/// All bytes of a file; throws std::runtime_error.
std::string read_bytes(const std::string& path);

}  // namespace kerf::core::test
