#pragma once

#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "common/io/gltf_container.h"
#include "common/io/reading_notes.h"

namespace kerf::core::io {

using GltfJson = nlohmann::json;

/// The JSON of a glTF file, and access to its members. Nothing is checked before it is asked for, so parts that the
/// surface does not use cannot refuse a file. Members that break the format but have a plain meaning are noted: one
/// that is null is not there, a whole number may be written as 8.0, and -1 refers to nothing.
///
/// `where` names an object in messages: "accessor 3".
class GltfDocument
{
public:
    /// `path`, `bytes` and `notes` must outlive it. O(n).
    /// @throws FileError  no glTF 2.0
    GltfDocument(const std::filesystem::path& path, std::string_view bytes, ReadingNotes& notes);

    const std::filesystem::path& path() const { return path_; }
    const GltfParts& parts() const { return parts_; }
    const GltfJson& root() const { return root_; }
    ReadingNotes& notes() const { return notes_; }

    /// @throws FileError  with a remedy, unless the reason has one of its own behind a semicolon
    [[noreturn]] void refuse(const std::string& reason) const;

    /// The member of an object; nullptr if there is none.
    const GltfJson* member(const GltfJson& object, const char* name) const;

    /// The object of this name; nullptr if there is none, or something else.
    const GltfJson* object_if(const GltfJson& object, const char* name) const;

    /// An extension's object on something; nullptr if it has none.
    const GltfJson* extension(const GltfJson& object, const char* name) const;

    /// An array of the document; an empty one if there is none.
    const GltfJson& list(const char* name) const { return list(root_, name, "the document"); }
    const GltfJson& list(const GltfJson& object, const char* name, const std::string& where) const;

    /// The object at a place of a list of the document. @throws FileError  there is none
    const GltfJson& element(const char* list_name, std::uint64_t index, const std::string& kind,
                            const std::string& where) const;

    /// A whole number below 2^48. @throws FileError  anything else
    std::uint64_t number(const GltfJson& object, const char* name, const std::string& where) const;
    std::optional<std::uint64_t> number_if(const GltfJson& object, const char* name, const std::string& where) const;

    /// A place in a list. @throws FileError  neither a whole number nor -1
    std::uint64_t index(const GltfJson& object, const char* name, const std::string& where) const;
    std::optional<std::uint64_t> index_if(const GltfJson& object, const char* name, const std::string& where) const;

    /// A list of places in a list.
    std::vector<std::uint64_t> indices(const GltfJson& object, const char* name, const std::string& where) const;

private:
    void check_version() const;
    std::optional<std::uint64_t> whole(const GltfJson& value) const;
    bool is_nothing(const GltfJson& value) const;

    const std::filesystem::path& path_;
    ReadingNotes& notes_;
    GltfParts parts_;
    GltfJson root_;
};

}  // namespace kerf::core::io
