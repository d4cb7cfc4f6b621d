#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "viewer/render/gl_objects.h"
#include "viewer/render/picture.h"

namespace kerf::render {

/// Reads an image in any format that stb_image knows: PNG, JPEG, BMP, TGA, GIF and others.
/// @throws core::io::FileError  there is no such file, it is broken, or too large (64 million pixels)
Picture read_image(const std::string& path);

/// The images of materials on the graphics card, each once: sRGB, with mipmaps, repeated beyond their edges.
class ImageTable
{
public:
    /// Reads the image when it is new. 0 when it can't be used; the first time take_messages() says why.
    std::uint32_t index_of(const std::string& path);

    /// Of an index above 0.
    GLuint texture(std::uint32_t index) const { return textures_[index - 1].id(); }

    /// One sentence for each image that could not be used. Cleared by reading.
    std::vector<std::string> take_messages();

private:
    std::map<std::string, std::uint32_t> known_;
    std::vector<GlTexture> textures_;
    std::vector<std::string> messages_;
};

}  // namespace kerf::render
