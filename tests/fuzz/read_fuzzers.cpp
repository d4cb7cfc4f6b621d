// Files of any bytes, one fuzzer a format: a usable mesh, or an error of one line that names the file.

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <string_view>

#include "common/io/mesh_file.h"
#include "common/io/mtl_reader.h"
#include "common/io/read_formats.h"
#include "common/repair/mesh_facts.h"
#include "common/repair/repair.h"
#include "fuzz/fuzzers.h"
#include "fuzz/require.h"

namespace kerf::core::fuzz {

namespace {

using Reader = TriangleSoup (*)(const std::filesystem::path&, std::string_view, io::ReadingNotes&);

/// A folder that is not there: files that the bytes name are not found.
const std::filesystem::path kFolder = "no_such_folder";

std::string_view text(Bytes bytes)
{
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

bool has_control_characters(const std::string& text)
{
    return std::any_of(text.begin(), text.end(), [](unsigned char c) { return c < ' ' || c == 0x7F; });
}

void require_clause(const std::string& note)
{
    require(!note.empty() && note.size() < 200, "a note is a clause, not a copy of the file");
    require(!has_control_characters(note), "a note has no control characters");
}

void require_sentence(const std::string& message, const std::filesystem::path& path)
{
    require(message.starts_with(path.string() + ": "), "an error names its file: " + message);
    require(message.size() < path.string().size() + 300, "an error is a sentence, not a copy of the file");
    require(!has_control_characters(message), "an error has no control characters");
}

void require_usable(const TriangleSoup& soup)
{
    require(!soup.triangles.empty(), "a mesh has triangles");
    for (const Triangle& t : soup.triangles)
        for (const std::uint32_t v : t) require(v < soup.vertices.size(), "corners are vertices");
    for (const Vertex& v : soup.vertices)
        require(std::isfinite(v.position.x) && std::isfinite(v.position.y) && std::isfinite(v.position.z),
                "coordinates are finite");
    for (const Vertex& v : soup.vertices)
        require(std::isfinite(v.uv.x) && std::isfinite(v.uv.y) && !std::isnan(v.normal.x + v.normal.y + v.normal.z),
                "normals and texture coordinates are finite");
    for (const VertexStream& stream : soup.streams)
        require(stream.values.size() == std::size_t{stream.width} * soup.vertices.size(), "streams have all vertices");
    require(soup.triangle_materials.empty() || soup.triangle_materials.size() == soup.triangles.size(),
            "all triangles or none have a material");
    for (const std::uint32_t m : soup.triangle_materials)
        require(m < soup.materials.size(), "materials of triangles are materials");
}

void read(Reader reader, const char* name, Bytes bytes)
{
    const std::filesystem::path path = kFolder / name;
    TriangleSoup soup;
    try {
        io::ReadingNotes notes;
        soup = reader(path, text(bytes), notes);
        for (const io::ReadingNote& note : notes.list()) require_clause(note.what);
    } catch (const io::FileError& error) {
        require_sentence(error.what(), path);
        return;
    }
    require_usable(soup);
    measure(soup);
    const Repaired repaired = repair(std::move(soup));
    if (repaired.error.empty()) require(check(repaired.mesh).empty(), "what is read and repaired is a mesh");
}

}  // namespace

void fuzz_read_gltf(Bytes bytes)
{
    read(io::read_gltf, "a.gltf", bytes);
}

void fuzz_read_mtl(Bytes bytes)
{
    io::MaterialLibrary materials;
    io::parse_mtl(kFolder / "a.mtl", text(bytes), materials);
    for (const auto& [name, material] : materials) {
        require(name == material.name, "a material has its name");
        for (int i = 0; i < 4; ++i) require(std::isfinite(material.colour[i]), "a colour is finite");
    }
}

void fuzz_read_obj(Bytes bytes)
{
    read(io::read_obj, "a.obj", bytes);
}

void fuzz_read_off(Bytes bytes)
{
    read(io::read_off, "a.off", bytes);
}

void fuzz_read_ply(Bytes bytes)
{
    read(io::read_ply, "a.ply", bytes);
}

void fuzz_read_stl(Bytes bytes)
{
    read(io::read_stl, "a.stl", bytes);
}

}  // namespace kerf::core::fuzz
