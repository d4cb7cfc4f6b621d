#include "common/drawings/write_drawing.h"

#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <new>

#include "common/files/file_error.h"
#include "common/files/output_file.h"

namespace kerf::core::drawings {

namespace {

using Writer = void (*)(io::ByteSink&, const Drawing&);

Writer writer_for(const std::filesystem::path& path)
{
    std::string extension = path.extension().string();
    for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    if (extension == ".svg") return write_svg;
    if (extension == ".dxf") return write_dxf;
    if (extension == ".obj") return write_obj_lines;
    io::fail(path, "drawings are written as .svg, .dxf and .obj");
}

}  // namespace

void write_drawing(const std::filesystem::path& path, const Drawing& drawing)
{
    const Writer write = writer_for(path);
    try {
        io::OutputFile file(path);
        write(file, drawing);
        file.finish();
        file.commit();
    } catch (const std::bad_alloc&) {
        io::fail_without_memory(path, "write it; free some");
    }
}

std::string drawing_bytes(const Drawing& drawing, std::string_view format)
{
    io::MemorySink sink("drawing." + std::string(format));
    try {
        writer_for(sink.path())(sink, drawing);
        return sink.take();
    } catch (const std::bad_alloc&) {
        io::fail_without_memory(sink.path(), "write it; free some");
    }
}

std::string number_text(double value)
{
    std::array<char, 32> text;
    const auto number = static_cast<float>(value + 0.0);
    const bool fits = std::isfinite(number) && (number != 0.0f || value == 0.0);
    const std::to_chars_result written = fits ? std::to_chars(text.data(), text.data() + text.size(), number)
                                              : std::to_chars(text.data(), text.data() + text.size(), value);
    return {text.data(), written.ptr};
}

}  // namespace kerf::core::drawings
