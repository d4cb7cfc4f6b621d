#include "viewer/render/picture.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <limits>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

// stb is a library in headers; Debian compiles it as well, with the declarations below.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wsign-conversion"
#include <stb_image_write.h>
#pragma GCC diagnostic pop

#include "common/files/file_error.h"
#include "common/files/output_file.h"

namespace kerf::render {

namespace {

/// stb hands over what it has compressed piece by piece; its own code must not see an exception.
void append(void* out, void* data, int size)
{
    static_cast<std::string*>(out)->append(static_cast<const char*>(data), static_cast<std::size_t>(size));
}

std::vector<std::uint8_t> rgb_of(const Picture& picture)
{
    std::vector<std::uint8_t> rgb;
    rgb.reserve(picture.rgba.size() / 4 * 3);
    for (std::size_t i = 0; i + 3 < picture.rgba.size(); i += 4)
        rgb.insert(rgb.end(), picture.rgba.begin() + static_cast<std::ptrdiff_t>(i),
                   picture.rgba.begin() + static_cast<std::ptrdiff_t>(i) + 3);
    return rgb;
}

void write_whole(const std::filesystem::path& path, const std::string& bytes)
{
    core::io::OutputFile file(path);
    file.write(bytes);
    file.finish();
    file.commit();
}

std::string frame_name(int number)
{
    std::array<char, 32> name{};
    std::snprintf(name.data(), name.size(), "frame_%05d.png", number);
    return name.data();
}

}  // namespace

void write_png(const std::filesystem::path& path, const Picture& picture)
{
    std::string bytes;
    const int is_good = stbi_write_png_to_func(append, &bytes, picture.width, picture.height, 3, rgb_of(picture).data(),
                                               3 * picture.width);
    if (is_good == 0) throw core::io::FileError(path.string() + ": the picture cannot be compressed");
    write_whole(path, bytes);
}

void write_jpeg(const std::filesystem::path& path, const Picture& picture, int quality)
{
    std::string bytes;
    const int is_good =
        stbi_write_jpg_to_func(append, &bytes, picture.width, picture.height, 3, rgb_of(picture).data(), quality);
    if (is_good == 0) throw core::io::FileError(path.string() + ": the picture cannot be compressed");
    write_whole(path, bytes);
}

Recording::Recording(std::filesystem::path folder) : folder_(std::move(folder))
{
    std::error_code error;
    std::filesystem::create_directories(folder_, error);
    for (int i = 0; !error && std::filesystem::remove(folder_ / frame_name(i), error); ++i) {
    }
    if (error)
        throw core::io::FileError(folder_.string() + ": it is no folder to write pictures to: " + error.message());
}

bool Recording::is_frame(const std::filesystem::path& name)
{
    constexpr std::string_view kHead = "frame_", kTail = ".png";
    const std::string text = name.filename().string();
    if (text.size() <= kHead.size() + kTail.size() || !text.starts_with(kHead) || !text.ends_with(kTail)) return false;
    return std::all_of(text.begin() + kHead.size(), text.end() - kTail.size(),
                       [](char c) { return c >= '0' && c <= '9'; });
}

std::vector<std::filesystem::path> Recording::frames_in(const std::filesystem::path& folder)
{
    std::vector<std::filesystem::path> frames;
    std::error_code error;
    for (std::filesystem::directory_iterator at(folder, error), end; !error && at != end; at.increment(error))
        if (is_frame(at->path())) frames.push_back(at->path());
    return frames;
}

void Recording::add(const Picture& picture)
{
    write_png(folder_ / frame_name(count_), picture);
    ++count_;
}

}  // namespace kerf::render
