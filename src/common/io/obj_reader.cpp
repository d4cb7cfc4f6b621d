#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "common/io/mtl_reader.h"
#include "common/io/plain_text.h"
#include "common/io/read_formats.h"
#include "common/io/soup_builder.h"
#include "common/io/text_scanner.h"

namespace kerf::core::io {

namespace {

constexpr std::int64_t kAbsent = -1;

/// The entries that a corner of a face names: positions in the lists of v, vt and vn, or kAbsent.
struct Corner
{
    std::int64_t v = kAbsent, vt = kAbsent, vn = kAbsent;
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

/// Statements of grouping, smoothing and display: the mesh loses nothing without them.
bool is_about_grouping(std::string_view keyword)
{
    constexpr std::array<std::string_view, 12> kKeywords{
        "g", "s", "o", "mg", "lod", "bevel", "c_interp", "d_interp", "shadow_obj", "trace_obj", "maplib", "usemap"};
    return std::find(kKeywords.begin(), kKeywords.end(), keyword) != kKeywords.end();
}

/// Statements of free-form curves and surfaces, with those of older versions.
bool is_free_form(std::string_view keyword)
{
    constexpr std::array<std::string_view, 22> kKeywords{
        "vp",   "cstype", "deg", "bmat", "step",  "curv",  "curv2", "surf", "parm", "trim", "hole",
        "scrv", "sp",     "end", "con",  "ctech", "stech", "bsp",   "bzp",  "cdc",  "cdp",  "res"};
    return std::find(kKeywords.begin(), kKeywords.end(), keyword) != kKeywords.end();
}

class ObjReader
{
public:
    ObjReader(const std::filesystem::path& path, std::string_view text, ReadingNotes& notes)
        : path_(path),
          notes_(notes),
          line_(path, text, {.comment = '#', .continuations = true}, &notes),
          builder_(path, notes)
    {
    }

    TriangleSoup read()
    {
        while (line_.next_line()) {
            const std::string_view keyword = line_.word();
            if (keyword == "f")
                read_face();
            else if (read_list_item(line_, keyword, is_read_ahead_))
                continue;
            else if (keyword == "usemtl")
                builder_.use_material(std::string(line_.rest()));
            else if (keyword == "mtllib")
                read_libraries();
            else if (keyword == "fo") {
                notes_.add("faces in the old spelling fo read");
                read_face();
            } else if (keyword == "l" || keyword == "p")
                notes_.add("lines and points passed over");
            else if (is_free_form(keyword))
                notes_.add("statements of free-form curves and surfaces passed over");
            else if (!is_about_grouping(keyword))
                notes_.add("statements of other kinds passed over");
        }
        if (positions_.empty())
            fail(path_, "there is no vertex in it; export it again, or mend its extension if it is no OBJ file");
        add_notes();
        add_colours();
        for (Material& material : builder_.soup.materials)
            if (const auto found = library_.find(material.name); found != library_.end()) material = found->second;
        return builder_.finish();
    }

private:
    /// The numbers of v, vt and vn that the walk has passed.
    struct Passed
    {
        std::size_t v = 0, vt = 0, vn = 0;
    };

    /// Reads a v, a vt or a vn; false for other statements. One that was read ahead is only counted.
    bool read_list_item(TextScanner& line, std::string_view keyword, bool is_known)
    {
        if (keyword == "v") {
            ++passed_.v;
            if (!is_known) read_position(line);
        } else if (keyword == "vt") {
            ++passed_.vt;
            if (!is_known) read_uv(line);
        } else if (keyword == "vn") {
            ++passed_.vn;
            if (!is_known) read_normal(line);
        } else {
            return false;
        }
        return true;
    }

    /// Reads the lists to their ends, because faces may come before the entries they name. The walk goes on from where
    /// it was, because negative indices count from there.
    void read_ahead()
    {
        if (std::exchange(is_read_ahead_, true)) return;
        const Passed here = passed_;
        TextScanner ahead = line_;
        while (ahead.next_line()) read_list_item(ahead, ahead.word(), false);
        passed_ = here;
    }

    void read_position(TextScanner& line)
    {
        glm::vec3 position;
        for (int i = 0; i < 3; ++i) {
            const std::string_view word = line.word();
            // A missing or invalid coordinate matters only if a face uses it: the line is one vertex all the same.
            position[i] = TextScanner::to_attribute(word);
            if (!std::isfinite(position[i])) unfit_.push_back({positions_.size(), line.line(), word});
        }
        positions_.push_back(position);
        // Behind the coordinates: nothing, a weight, or a colour (not in the description, but widespread).
        const std::array<std::string_view, 3> more{line.word(), line.word(), line.word()};
        if (more[2].empty()) {
            weights_ += !more[0].empty() && (!more[1].empty() || TextScanner::to_attribute(more[0]) != 1.0f) ? 1 : 0;
            return;
        }
        colours_.resize(positions_.size(), glm::vec3(1.0f));
        for (std::size_t i = 0; i < 3; ++i) colours_.back()[static_cast<int>(i)] = TextScanner::to_attribute(more[i]);
    }

    void read_uv(TextScanner& line)
    {
        const float u = TextScanner::to_attribute(line.word());
        const std::string_view v = line.word();
        uvs_.push_back({u, v.empty() ? 0.0f : TextScanner::to_attribute(v)});
        if (std::isfinite(uvs_.back().x) && std::isfinite(uvs_.back().y)) return;
        uvs_.back() = {};
        ++bad_uvs_;
    }

    void read_normal(TextScanner& line)
    {
        glm::vec3 n;
        for (int i = 0; i < 3; ++i) n[i] = TextScanner::to_attribute(line.word());
        const bool is_good = std::isfinite(n.x) && std::isfinite(n.y) && std::isfinite(n.z);
        bad_normals_ += is_good ? 0 : 1;
        normals_.push_back(is_good ? n : kNoNormal);
    }

    void read_face()
    {
        face_.clear();
        for (std::string_view word = line_.word(); !word.empty(); word = line_.word())
            face_.push_back(vertex_of(read_corner(word)));
        builder_.add_face(face_);
    }

    /// v, v/vt, v//vn or v/vt/vn.
    Corner read_corner(std::string_view word)
    {
        Corner corner;
        const std::size_t first = word.find('/');
        corner.v = read_vertex_index(word.substr(0, first));
        if (first == std::string_view::npos) return corner;
        const std::string_view rest = word.substr(first + 1);
        const std::size_t second = rest.find('/');
        corner.vt = read_attribute_index(rest.substr(0, second), passed_.vt, uvs_);
        if (second != std::string_view::npos)
            corner.vn = read_attribute_index(rest.substr(second + 1), passed_.vn, normals_);
        return corner;
    }

    /// Counted from 1, or backwards from the latest one with -1.
    std::int64_t read_vertex_index(std::string_view word)
    {
        const std::int64_t index = line_.to_integer(word, "the index of a vertex");
        if (const std::int64_t place = find(index, passed_.v, positions_); place != kAbsent) return place;
        const std::string name = "vertex " + std::to_string(index) + " is out of range: ";
        if (index > 0)
            line_.fail(name + "there are " + std::to_string(positions_.size()) +
                       "; count from 1, and mend the face or take it out");
        line_.fail(name + (index == 0 ? "the first is 1" : "there are " + std::to_string(passed_.v) + " before it") +
                   "; mend the face or take it out");
    }

    /// The same for attributes, which the surface does not need: kAbsent for one that is not there.
    template <class List>
    std::int64_t read_attribute_index(std::string_view word, std::size_t passed, const List& list)
    {
        if (word.empty()) return kAbsent;
        const std::optional<std::int64_t> index = line_.integer_if(word);
        const std::int64_t place = index ? find(*index, passed, list) : kAbsent;
        absent_ += place == kAbsent ? 1 : 0;
        return place;
    }

    template <class List>
    std::int64_t find(std::int64_t index, std::size_t passed, const List& list)
    {
        const auto count = static_cast<std::int64_t>(passed);
        if (index < 0) return index >= -count ? count + index : kAbsent;
        if (index > static_cast<std::int64_t>(list.size())) read_ahead();
        // 0 becomes kAbsent.
        return index <= static_cast<std::int64_t>(list.size()) ? index - 1 : kAbsent;
    }

    std::uint32_t vertex_of(const Corner& corner)
    {
        const auto [found, is_new] = vertices_.emplace(corner, 0);
        if (!is_new) return found->second;
        Vertex v;
        v.position = positions_[static_cast<std::size_t>(corner.v)];
        v.uv = corner.vt == kAbsent ? glm::vec2(0.0f) : uvs_[static_cast<std::size_t>(corner.vt)];
        v.normal = corner.vn == kAbsent ? kNoNormal : normals_[static_cast<std::size_t>(corner.vn)];
        position_of_vertex_.push_back(static_cast<std::size_t>(corner.v));
        found->second = builder_.add_vertex(v);
        if (!std::isfinite(v.position.x + v.position.y + v.position.z)) note_use_of_unfit(corner.v, found->second);
        return found->second;
    }

    void note_use_of_unfit(std::int64_t position, std::uint32_t vertex)
    {
        const auto of = [](const Unfit& unfit, std::size_t p) { return unfit.position < p; };
        const std::size_t place = static_cast<std::size_t>(position);
        const auto unfit = std::lower_bound(unfit_.begin(), unfit_.end(), place, of);
        if (unfit != unfit_.end() && unfit->position == place) builder_.add_unfit(vertex, unfit->line, unfit->word);
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

    /// Reads each file once, however often and by however many names it is requested.
    void read_library(const std::filesystem::path& file)
    {
        std::error_code error;
        const std::filesystem::path canonical = std::filesystem::canonical(file, error);
        if (!error && libraries_read_.insert(canonical).second) read_mtl(canonical, library_);
    }

    void add_notes()
    {
        notes_.add(kBadNormals, bad_normals_);
        notes_.add(kBadUvs, bad_uvs_);
        notes_.add("references to normals and texture coordinates that are not there left out", absent_);
        notes_.add("weights and other words behind coordinates passed over", weights_);
        notes_.add(kUnusedVertices, count_unused_unfit());
    }

    /// Positions that are not finite and that no corner names.
    std::uint64_t count_unused_unfit() const
    {
        if (unfit_.empty()) return 0;
        std::vector<bool> is_used(positions_.size(), false);
        for (const std::size_t position : position_of_vertex_) is_used[position] = true;
        std::uint64_t count = 0;
        for (std::size_t i = 0; i < unfit_.size(); ++i) {
            const bool is_first = i == 0 || unfit_[i].position != unfit_[i - 1].position;
            count += is_first && !is_used[unfit_[i].position] ? 1 : 0;
        }
        return count;
    }

    /// Positions without a colour are white if others have one.
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

    /// A coordinate that is no finite number, until a corner names its position.
    struct Unfit
    {
        std::size_t position = 0;
        std::size_t line = 0;
        std::string_view word;
    };

    const std::filesystem::path& path_;
    ReadingNotes& notes_;
    TextScanner line_;
    SoupBuilder builder_;
    Passed passed_;
    bool is_read_ahead_ = false;
    std::vector<Unfit> unfit_;
    std::uint64_t bad_normals_ = 0, bad_uvs_ = 0, absent_ = 0, weights_ = 0;
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
    const PlainText text(bytes, notes);
    return ObjReader(path, without_padding(text.view(), notes), notes).read();
}

}  // namespace kerf::core::io
