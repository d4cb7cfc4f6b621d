#include "viewer/ui/typeface.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <system_error>

namespace kerf::ui {

namespace {

constexpr float kUnitsHigh = 720.0f;
/// Letters smaller than this cannot be read, and larger ones do not fit into a texture. Pixels of a unit.
constexpr float kSmallestUnit = 0.3f, kLargestUnit = 4.0f;

constexpr std::array kTextFiles{"/usr/share/fonts/truetype/lato/Lato-Semibold.ttf",
                                "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf"};
constexpr std::array kTitleFiles{"/usr/share/fonts/truetype/lato/Lato-Black.ttf",
                                 "/usr/share/fonts/truetype/dejavu/DejaVuSans-Bold.ttf"};

float unit_of(int picture_height)
{
    return std::clamp(static_cast<float>(picture_height) / kUnitsHigh, kSmallestUnit, kLargestUnit);
}

/// @param glyphs  pairs of first and last code point, ending in 0; they must outlive the atlas
template <std::size_t Count>
ImFont* load(const std::array<const char*, Count>& files, float pixels, const ImWchar* glyphs)
{
    ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
    ImFontConfig how;
    how.OversampleH = pixels > 40.0f ? 1 : 2;
    for (const char* const file : files) {
        std::error_code ignored;
        if (!std::filesystem::is_regular_file(file, ignored)) continue;
        if (ImFont* const font = atlas.AddFontFromFileTTF(file, std::round(pixels), &how, glyphs)) return font;
    }
    how.SizePixels = pixels;
    return atlas.AddFontDefault(&how);
}

}  // namespace

Typeface load_typeface(int picture_height)
{
    static constexpr std::array<ImWchar, 7> kLatin{0x20, 0xFF, 0x2013, 0x2026, 0x2190, 0x2193, 0};
    static constexpr std::array<ImWchar, 5> kAscii{0x20, 0x7E, 0xD7, 0xD7, 0};
    ImGui::GetIO().Fonts->Clear();
    Typeface typeface;
    typeface.unit = unit_of(picture_height);
    typeface.text = load(kTextFiles, 20.0f * typeface.unit, kLatin.data());
    typeface.large = load(kTitleFiles, 36.0f * typeface.unit, kLatin.data());
    typeface.huge = load(kTitleFiles, 84.0f * typeface.unit, kAscii.data());
    return typeface;
}

bool fits(const Typeface& typeface, int picture_height)
{
    return typeface.text != nullptr && std::abs(unit_of(picture_height) / typeface.unit - 1.0f) < 0.04f;
}

}  // namespace kerf::ui
