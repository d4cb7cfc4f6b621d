#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "common/io/polygon.h"
#include "common/io/reading_notes.h"
#include "common/io/text_scanner.h"
#include "common/mesh/index.h"
#include "common/mesh/triangle_soup.h"
#include "common/repair/clean_soup.h"

// What the readers of all formats have in common. Numbers are cleaned by common/repair/clean_soup.h.

namespace kerf::core::io {

/// Collects what a reader finds, and completes it in one way for all formats.
class SoupBuilder
{
public:
    SoupBuilder(const std::filesystem::path& path, ReadingNotes& notes) : path_(path), notes_(notes) {}

    TriangleSoup soup;  ///< readers add vertices and streams themselves

    /// Adds a vertex and returns its index. Streams are the caller's.
    std::uint32_t add_vertex(const Vertex& vertex);

    /// A coordinate of the vertex that is added next, from a text. One that is not finite is remembered, so that the
    /// message of finish() names its line.
    float read_coordinate(const TextScanner& text, std::string_view word)
    {
        const float value = text.to_float(word, "a coordinate");
        if (!std::isfinite(value)) add_unfit(static_cast<std::uint32_t>(soup.vertices.size()), text.line(), word);
        return value;
    }

    /// Records that this vertex has a coordinate that is not finite, with its word and its line in the text.
    void add_unfit(std::uint32_t vertex, std::size_t line, std::string_view word)
    {
        unfit_.push_back({vertex, line, word});
    }

    /// Adds a face with any number of corners, with the current material. Fewer than three bound no surface and are
    /// passed over. @throws FileError  an index out of range, or an outline that takes too long to triangulate
    void add_face(std::span<const std::uint32_t> corners);

    /// Following faces have the material of this name, which is made if it is new.
    void use_material(const std::string& name);

    /// Following faces have this material of `soup.materials`.
    void use_material(std::uint32_t index) { material_ = index; }

    /// Checks coordinates and cleans numbers: clean(). Values that are not finite and do not matter for the surface are
    /// noted and replaced: a normal is made anew, other attributes are 0, and a vertex without faces moves to one that
    /// has some.
    /// @throws FileError  no triangle; a coordinate of a face that is not finite
    TriangleSoup finish();

private:
    struct Unfit
    {
        std::uint32_t vertex = 0;
        std::size_t line = 0;
        std::string_view word;
    };

    void finish_positions();
    [[noreturn]] void fail_at_unfit(std::uint32_t vertex) const;
    void finish_attributes();

    const std::filesystem::path& path_;
    ReadingNotes& notes_;
    ConcaveBudget concave_budget_;
    std::vector<Unfit> unfit_;
    std::uint64_t faces_ = 0, faces_without_surface_ = 0;
    std::uint32_t material_ = kNone;  ///< none is named yet
    std::unordered_map<std::string, std::uint32_t> material_of_name_;
};

}  // namespace kerf::core::io
