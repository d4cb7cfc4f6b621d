#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "common/io/plain_text.h"
#include "common/io/reading_notes.h"

namespace kerf::core::io {

enum class PlyFormat : std::uint8_t
{
    ascii,
    little_endian,
    big_endian
};
enum class PlyType : std::uint8_t
{
    int8,
    uint8,
    int16,
    uint16,
    int32,
    uint32,
    int64,
    uint64,
    float32,
    float64
};

std::size_t size_of(PlyType type);

struct PlyProperty
{
    std::string name;
    PlyType type = PlyType::float32;
    bool is_list = false;
    PlyType count_type = PlyType::uint8;  ///< lists: type of the number in front of the items
};

struct PlyElement
{
    std::string name;
    std::uint64_t count = 0;
    std::vector<PlyProperty> properties;
};

struct PlyHeader
{
    PlyFormat format = PlyFormat::ascii;
    std::vector<PlyElement> elements;
    std::size_t size = 0;   ///< bytes up to and including the end of its last line
    std::size_t lines = 0;  ///< lines of the header
};

/// Reads "ply ... end_header", and checks the counts that it claims against the size of the file.
/// @throws FileError
PlyHeader read_ply_header(const std::filesystem::path& path, const PlainText& text, ReadingNotes& notes);

}  // namespace kerf::core::io
