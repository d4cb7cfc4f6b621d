#include "viewer/render/image_table.h"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <system_error>
#include <utility>

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wsign-conversion"
#include <stb_image.h>
#pragma GCC diagnostic pop

#include "common/files/file_error.h"

namespace kerf::render {

namespace {

/// Some hundred bytes of a compressed file can claim any size: more than this is no texture of a model.
constexpr std::int64_t kMostPixels = 64'000'000;

struct FreePixels
{
    void operator()(stbi_uc* pixels) const { stbi_image_free(pixels); }
};

/// GL's rows begin at the bottom, as uv do.
void turn_over(Picture& picture)
{
    const auto row = std::ptrdiff_t{4} * picture.width;
    for (std::ptrdiff_t top = 0, bottom = picture.height - 1; top < bottom; ++top, --bottom)
        std::swap_ranges(picture.rgba.begin() + top * row, picture.rgba.begin() + (top + 1) * row,
                         picture.rgba.begin() + bottom * row);
}

GlTexture upload(const Picture& picture)
{
    GlTexture texture = GlTexture::create();
    glBindTexture(GL_TEXTURE_2D, texture.id());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    // Filters mix linear light: the card decodes sRGB before it interpolates.
    glTexImage2D(GL_TEXTURE_2D, 0, GL_SRGB8_ALPHA8, picture.width, picture.height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 picture.rgba.data());
    glGenerateMipmap(GL_TEXTURE_2D);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_REPEAT);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_REPEAT);
    glBindTexture(GL_TEXTURE_2D, 0);
    return texture;
}

}  // namespace

Picture read_image(const std::string& path)
{
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error)) throw core::io::FileError(path + ": there is no such image");
    Picture picture;
    int channels = 0;
    if (stbi_info(path.c_str(), &picture.width, &picture.height, &channels) == 0)
        throw core::io::FileError(path + ": this is no image (" + stbi_failure_reason() + ")");
    if (std::int64_t{picture.width} * picture.height > kMostPixels)
        throw core::io::FileError(path + ": the image is larger than 64 million pixels");
    const std::unique_ptr<stbi_uc, FreePixels> pixels(
        stbi_load(path.c_str(), &picture.width, &picture.height, &channels, 4));
    if (!pixels) throw core::io::FileError(path + ": the image cannot be read (" + stbi_failure_reason() + ")");
    const std::size_t size = 4 * static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height);
    picture.rgba.assign(pixels.get(), pixels.get() + size);
    return picture;
}

std::uint32_t ImageTable::index_of(const std::string& path)
{
    const auto [place, is_new] = known_.try_emplace(path, 0);
    if (!is_new) return place->second;
    try {
        Picture picture = read_image(path);
        GLint most = 0;
        glGetIntegerv(GL_MAX_TEXTURE_SIZE, &most);
        if (picture.width > most || picture.height > most)
            throw core::io::FileError(path + ": the image is larger than the " + std::to_string(most) +
                                      " pixels a side that the graphics driver offers");
        turn_over(picture);
        textures_.push_back(upload(picture));
        place->second = static_cast<std::uint32_t>(textures_.size());
    } catch (const core::io::FileError& error) {
        messages_.emplace_back(error.what());
    }
    return place->second;
}

std::vector<std::string> ImageTable::take_messages()
{
    return std::exchange(messages_, {});
}

}  // namespace kerf::render
