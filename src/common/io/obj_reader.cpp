#include <algorithm>
#include <array>
#include <filesystem>
#include <set>
#include <string>
#include <unordered_map>
#include <vector>

#include "common/io/mtl_reader.h"
#include "common/io/read_formats.h"
#include "common/io/soup_builder.h"
#include "common/io/text_scanner.h"

namespace kerf::io {

namespace {

constexpr std::int64_t kNone = -1;

/// What a corner of a face names: positions in the lists of v, vt and vn, or kNone.
struct Corner
{
    std::int64_t v = kNone, vt = kNone, vn = kNone;
    bool operator==(const Corner&) const = default;
};

struct CornerHash
{
    std::size_t operator()(const Corner& c) const
    {
        std::uint64_t h = static_cast<std::uint64_t>(c.v) * 0x9E3779B97F4A7C15u;
        h = (h ^ (h >> 32) ^ static_cast<std::uint64_t>(c.vt)) * 0xBF58476D1CE4E5B9u;
        h = (h ^ (h >> 29) ^ static_cast<std::uint64_t>(c.vn)) * 0x94D049BB133111EBu;
        return static_cast<std::size_t>(h ^ (h >> 31));
    }
};

class ObjReader
{
public:
    ObjReader(const std::filesystem::path& path, std::string_view bytes, ReadingNotes& notes)
        : path_(path), line_(path, bytes, {.comment = '#', .continuations = true}), builder_(path, notes)
    {
    }

    TriangleSoup read()
    {
        while (line_.next_line()) {
            const std::string_view keyword = line_.word();
            if (keyword == "v")
                read_position();
            else if (keyword == "vt")
                read_uv();
            else if (keyword == "vn")
                read_normal();
            else if (keyword == "f")
                read_face();
            else if (keyword == "usemtl")
                builder_.use_material(std::string(line_.rest()));
            else if (keyword == "mtllib")
                read_libraries();
            // Groups, smoothing, curves, lines and points bound no surface.
        }
        add_colours();
        for (Material& material : builder_.soup.materials)
            if (const auto found = library_.find(material.name); found != library_.end()) material = found->second;
        return builder_.finish();
    }

private:
    void read_position()
    {
        const float x = line_.number("a coordinate"), y = line_.number("a coordinate");
        positions_.push_back({x, y, line_.number("a coordinate")});
        // Behind the coordinates: nothing, a weight, or a colour (not in the description, but widespread).
        std::array<std::string_view, 3> more{line_.word(), line_.word(), line_.word()};
        if (more[2].empty()) return;
        colours_.resize(positions_.size(), glm::vec3(1.0f));
        for (int i = 0; i < 3; ++i) colours_.back()[i] = line_.to_number(more[static_cast<std::size_t>(i)], "a colour");
    }

    void read_uv()
    {
        const float u = line_.number("a texture coordinate");
        const std::string_view v = line_.word();
        uvs_.push_back({u, v.empty() ? 0.0f : line_.to_number(v, "a texture coordinate")});
    }

    void read_normal()
    {
        const float x = line_.number("a normal"), y = line_.number("a normal");
        normals_.push_back({x, y, line_.number("a normal")});
    }

    void read_face()
    {
        face_.clear();
        for (std::string_view word = line_.word(); !word.empty(); word = line_.word())
            face_.push_back(vertex_of(read_corner(word)));
        if (face_.size() < 3) line_.fail("a face has fewer than three corners; give it more or take it out");
        builder_.add_face(face_);
    }

    /// v, v/vt, v//vn or v/vt/vn.
    Corner read_corner(std::string_view word)
    {
        Corner corner;
        const std::size_t first = word.find('/');
        corner.v = read_index(word.substr(0, first), positions_.size(), "vertex");
        if (first == std::string_view::npos) return corner;
        const std::string_view rest = word.substr(first + 1);
        const std::size_t second = rest.find('/');
        if (const auto vt = rest.substr(0, second); !vt.empty())
            corner.vt = read_index(vt, uvs_.size(), "texture coordinate");
        if (second != std::string_view::npos && second + 1 < rest.size())
            corner.vn = read_index(rest.substr(second + 1), normals_.size(), "normal");
        return corner;
    }

    /// Counted from 1, or backwards from the latest one with -1.
    std::int64_t read_index(std::string_view word, std::size_t size, const std::string& what)
    {
        const std::int64_t count = static_cast<std::int64_t>(size);
        const std::int64_t index = line_.to_integer(word, "the index of a " + what);
        if (index == 0 || index > count || index < -count)
            line_.fail(what + " " + std::to_string(index) + " is out of range: there are " + std::to_string(count) +
                       " so far; count from 1, and put them before the faces");
        return index > 0 ? index - 1 : count + index;
    }

    std::uint32_t vertex_of(const Corner& corner)
    {
        const auto [found, is_new] = vertices_.emplace(corner, 0);
        if (!is_new) return found->second;
        Vertex v;
        v.position = positions_[static_cast<std::size_t>(corner.v)];
        v.uv = corner.vt == kNone ? glm::vec2(0.0f) : uvs_[static_cast<std::size_t>(corner.vt)];
        v.normal = corner.vn == kNone ? kNoNormal : normals_[static_cast<std::size_t>(corner.vn)];
        position_of_vertex_.push_back(static_cast<std::size_t>(corner.v));
        return found->second = builder_.add_vertex(v);
    }

    /// The names of a mtllib line are separated by blanks, but one name may have blanks as well.
    void read_libraries()
    {
        const std::string rest(line_.rest());
        std::error_code ignored;
        if (const auto whole = file_beside(path_, rest); whole && std::filesystem::is_regular_file(*whole, ignored)) {
            read_library(*whole);
            return;
        }
        for (std::size_t at = 0; at < rest.size();) {
            const std::size_t end = std::min(rest.find_first_of(" \t", at), rest.size());
            if (end > at)
                if (const auto file = file_beside(path_, rest.substr(at, end - at))) read_library(*file);
            at = end + 1;
        }
    }

    /// Each file once, however often and under however many names it is called for.
    void read_library(const std::filesystem::path& file)
    {
        std::error_code error;
        const std::filesystem::path canonical = std::filesystem::canonical(file, error);
        if (!error && libraries_read_.insert(canonical).second) read_mtl(canonical, library_);
    }

    /// Positions without a colour are white where others have one.
    void add_colours()
    {
        if (colours_.empty()) return;
        colours_.resize(positions_.size(), glm::vec3(1.0f));
        VertexStream stream;
        stream.name = "color";
        stream.width = 3;
        stream.values.reserve(3 * position_of_vertex_.size());
        for (const std::size_t position : position_of_vertex_)
            for (int i = 0; i < 3; ++i) stream.values.push_back(colours_[position][i]);
        builder_.soup.streams.push_back(std::move(stream));
    }

    const std::filesystem::path& path_;
    TextScanner line_;
    SoupBuilder builder_;
    std::vector<glm::vec3> positions_, normals_, colours_;
    std::vector<glm::vec2> uvs_;
    std::unordered_map<Corner, std::uint32_t, CornerHash> vertices_;
    std::vector<std::size_t> position_of_vertex_;
    std::vector<std::uint32_t> face_;
    MaterialLibrary library_;
    std::set<std::filesystem::path> libraries_read_;
};

}  // namespace

TriangleSoup read_obj(const std::filesystem::path& path, std::string_view bytes, ReadingNotes& notes)
{
    return ObjReader(path, bytes, notes).read();
}

}  // namespace kerf::io
