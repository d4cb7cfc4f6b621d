#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace kerf::render {

/// An sRGB picture, 4 bytes a pixel (red, green, blue, alpha), rows from the top.
struct Picture
{
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgba;

    const std::uint8_t* pixel(int x, int y) const
    {
        return rgba.data() +
               4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x));
    }
    friend bool operator==(const Picture&, const Picture&) = default;
};

/// Writes a PNG file, which appears complete or not at all. Alpha is left out.
/// @throws core::io::FileError
void write_png(const std::filesystem::path& path, const Picture& picture);

/// The same as a JPEG file, a tenth of the size: for documentation.
/// @param quality  1 to 100
/// @throws core::io::FileError
void write_jpeg(const std::filesystem::path& path, const Picture& picture, int quality = 88);

/// Pictures numbered from 0 in a folder: frame_00000.png and so on, which every video encoder understands.
class Recording
{
public:
    /// Makes the folder where there is none, and removes the frames of an earlier recording: a shorter one would end in
    /// them. @throws core::io::FileError
    explicit Recording(std::filesystem::path folder);

    /// @throws core::io::FileError
    void add(const Picture& picture);

    int size() const { return count_; }

    /// Whether the last part of a name is that of a frame, whatever its number.
    static bool is_frame(const std::filesystem::path& name);
    /// What has the name of a frame in a folder, which a recording would replace or remove. None if there is no folder.
    static std::vector<std::filesystem::path> frames_in(const std::filesystem::path& folder);

private:
    std::filesystem::path folder_;
    int count_ = 0;
};

}  // namespace kerf::render
