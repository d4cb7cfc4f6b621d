#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace kerf::core::io {

/// Something in a file that says nothing about the surface and that a reader put right or passed over.
struct ReadingNote
{
    std::string what;         ///< a clause without the number: "texture coordinates that are not finite set to 0"
    std::uint64_t count = 1;  ///< how often
};

/// "3 normals that are not finite made anew".
std::string describe(const ReadingNote& note);

// Faults that several readers put right, in the same words for all.
inline constexpr std::string_view kBadNormals = "normals that are not finite numbers made anew";
inline constexpr std::string_view kBadUvs = "texture coordinates that are not finite numbers set to 0";
inline constexpr std::string_view kBadValues = "values of further attributes that are not finite numbers set to 0";
inline constexpr std::string_view kLongLines = "lines with more numbers than they need read without them";
inline constexpr std::string_view kBytesBehind = "bytes behind the end passed over";
inline constexpr std::string_view kUnusedVertices = "vertices of no face that are not finite numbers passed over";

/// What a reader was lenient about, each kind with its count, in the order in which it was first met. A file with notes
/// is read in full: the notes tell what else it held.
class ReadingNotes
{
public:
    /// Counts one kind of leniency. `what` is a literal, or has words of the file in_quotes(): its length is bounded.
    /// Beyond kMostKinds kinds all further ones are counted as one, "other things": a file must not fill memory with
    /// them.
    void add(std::string_view what, std::uint64_t count = 1);

    const std::vector<ReadingNote>& list() const { return notes_; }
    bool none() const { return notes_.empty(); }

    /// One clause for each kind, for people: "3 normals that are not finite made anew, ..."; empty if there are none.
    std::string describe() const;

private:
    static constexpr std::size_t kMostKinds = 32;

    std::vector<ReadingNote> notes_;
};

}  // namespace kerf::core::io
