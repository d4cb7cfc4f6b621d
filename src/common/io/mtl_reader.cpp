#include "common/io/mtl_reader.h"
#include "common/files/read_file.h"

#include <algorithm>
#include <string_view>

#include "common/io/mesh_file.h"
#include "common/io/plain_text.h"
#include "common/io/read_formats.h"
#include "common/io/text_scanner.h"

namespace kerf::core::io {

namespace {

/// The most arguments that a texture option has, by the MTL description: one unless named here.
std::size_t option_arguments(std::string_view option)
{
    if (option == "-o" || option == "-s" || option == "-t") return 3;
    if (option == "-mm") return 2;
    return 1;
}

bool is_number(std::string_view word)
{
    float ignored = 0.0f;
    return parse_float(word, ignored) == NumberError::none;
}

/// The file name at the end of a map line; options before it are skipped. It may contain blanks.
std::string texture_name(std::string_view rest)
{
    const auto next_word = [](std::string_view text) { return text.substr(0, text.find_first_of(" \t")); };
    const auto skip_word = [](std::string_view text) {
        const std::size_t end = text.find_first_of(" \t");
        if (end == std::string_view::npos) return std::string_view();
        const std::size_t next = text.find_first_not_of(" \t", end);
        return next == std::string_view::npos ? std::string_view() : text.substr(next);
    };
    while (rest.starts_with('-')) {
        const std::size_t most = option_arguments(next_word(rest));
        rest = skip_word(rest);
        // -o, -s and -t may leave out their last numbers.
        for (std::size_t i = 0; i < most && !rest.empty(); ++i) {
            if (i > 0 && !is_number(next_word(rest))) break;
            rest = skip_word(rest);
        }
    }
    return std::string(rest);
}

bool read_numbers(TextScanner& line, float* values, int count)
{
    for (int i = 0; i < count; ++i)
        if (parse_float(line.word(), values[i]) != NumberError::none) return false;
    return true;
}

}  // namespace

void read_mtl(const std::filesystem::path& path, MaterialLibrary& materials)
{
    std::string bytes;
    try {
        bytes = read_bytes(path);
    } catch (const FileError&) {
        return;
    }
    parse_mtl(path, bytes, materials);
}

void parse_mtl(const std::filesystem::path& path, std::string_view bytes, MaterialLibrary& materials)
{
    ReadingNotes unheard;
    const PlainText text(bytes, unheard);
    TextScanner line(path, without_padding(text.view(), unheard), {.comment = '#', .continuations = true});
    Material* material = nullptr;
    while (line.next_line()) {
        const std::string_view keyword = line.word();
        float numbers[3];
        if (keyword == "newmtl") {
            const std::string name(line.rest());
            material = &materials[name];
            *material = Material{};
            material->name = name;
        } else if (material == nullptr) {
            continue;
        } else if (keyword == "Kd") {
            if (read_numbers(line, numbers, 3))
                material->colour = {numbers[0], numbers[1], numbers[2], material->colour.a};
        } else if (keyword == "d") {
            if (read_numbers(line, numbers, 1)) material->colour.a = numbers[0];
        } else if (keyword == "Tr") {
            if (read_numbers(line, numbers, 1)) material->colour.a = 1.0f - numbers[0];
        } else if (keyword == "map_Kd") {
            material->texture = texture_name(line.rest());
        }
    }
}

}  // namespace kerf::core::io
