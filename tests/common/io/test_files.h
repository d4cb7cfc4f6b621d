#pragma once

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "common/io/mesh_file.h"
#include "common/mesh/indexed_mesh.h"
#include "support/temporary_folder.h"

// Vocabulary of the tests of mesh files.

namespace kerf::core::io {

class MeshFileTest : public test::FolderTest
{
protected:
    TriangleSoup soup_of(const std::string& name, std::string_view bytes) const
    {
        return read_soup(write(name, bytes));
    }

    /// A file as it was read, and what was put right.
    struct Read
    {
        TriangleSoup soup;
        std::string notes;
    };
    Read read(const std::string& name, std::string_view bytes) const
    {
        ReadingNotes notes;
        TriangleSoup soup = read_soup(write(name, bytes), &notes);
        return {std::move(soup), notes.describe()};
    }

    /// What FileError says about a file; fails the test when there is none.
    std::string error_of(const std::string& name, std::string_view bytes) const { return error_of(write(name, bytes)); }
    static std::string error_of(const std::filesystem::path& path)
    {
        try {
            read_soup(path);
        } catch (const FileError& error) {
            EXPECT_NE(std::string(error.what()).find(path.filename().string()), std::string::npos) << error.what();
            EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
            return error.what();
        }
        ADD_FAILURE() << path << " was read";
        return {};
    }
};

inline bool contains(const std::string& text, const std::string& part)
{
    return text.find(part) != std::string::npos;
}

/// All that a corner carries, as bits: position, normal, uv, streams in order.
using CornerBits = std::vector<std::uint32_t>;

inline CornerBits corner_bits(const Buffer<Vertex>& vertices, const std::vector<VertexStream>& streams, std::uint32_t v)
{
    CornerBits bits(8);
    std::memcpy(bits.data(), &vertices[v], sizeof(Vertex));
    for (const VertexStream& stream : streams)
        for (std::uint32_t i = 0; i < stream.width; ++i)
            bits.push_back(std::bit_cast<std::uint32_t>(stream.values[v * stream.width + i]));
    return bits;
}

/// Corners of all triangles in order: equal for two meshes that differ only in how their vertices are numbered.
template <class Mesh>
std::vector<CornerBits> all_corners(const Mesh& mesh, bool with_streams = true)
{
    static const std::vector<VertexStream> kNone;
    std::vector<CornerBits> corners;
    for (const Triangle& triangle : mesh.triangles)
        for (const std::uint32_t v : triangle)
            corners.push_back(corner_bits(mesh.vertices, with_streams ? mesh.streams : kNone, v));
    return corners;
}

inline std::size_t count_positions(const Buffer<Vertex>& vertices)
{
    std::map<std::array<std::uint32_t, 3>, int> positions;
    for (const Vertex& v : vertices)
        ++positions[{std::bit_cast<std::uint32_t>(v.position.x), std::bit_cast<std::uint32_t>(v.position.y),
                     std::bit_cast<std::uint32_t>(v.position.z)}];
    return positions.size();
}

/// A tetrahedron with a seam, two materials, a cap triangle and two streams; numbers that need all their digits.
inline IndexedMesh sample_mesh()
{
    IndexedMesh mesh;
    const std::array<glm::vec3, 4> corners{
        {{0.1f, 1.0f / 3.0f, 1e-20f}, {1234567.9f, 0.0f, 0.0f}, {0.0f, -3.4e38f, 2e-45f}, {0.7f, 0.3f, 16777216.0f}}};
    const std::array<Triangle, 4> faces{{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
    for (std::uint32_t f = 0; f < 4; ++f) {
        for (std::uint32_t k = 0; k < 3; ++k) {
            const float third = 1.0f / static_cast<float>(f + k + 2);
            mesh.vertices.push_back({corners[faces[f][k]], {0.6f, -0.8f, 0.0f}, {third, -1.0f - third}});
            mesh.points.push_back(faces[f][k]);
        }
        mesh.triangles.push_back({3 * f, 3 * f + 1, 3 * f + 2});
        mesh.sources.push_back(f);
    }
    mesh.point_count = 4;
    mesh.groups = {
        {0, 2, 0, 0, TriangleKind::surface}, {2, 1, 1, 0, TriangleKind::surface}, {3, 1, 2, 0, TriangleKind::cap}};
    mesh.materials = {{"skin", {0.25f, 0.5f, 1.0f, 1.0f}, "peel.png"},
                      {"", glm::vec4(1.0f), ""},
                      {"flesh", {1.0f, 0.1f, 0.2f, 0.5f}, ""}};
    mesh.streams = {{"color", 3, {}}, {"heat", 1, {}}, {"tangent", 4, {}}, {"x", 1, {}}, {"lod_0", 1, {}}};
    for (VertexStream& stream : mesh.streams)
        for (std::size_t i = 0; i < stream.width * mesh.vertices.size(); ++i)
            stream.values.push_back(1.0f / static_cast<float>(i + stream.name.size()));
    return mesh;
}

}  // namespace kerf::core::io
