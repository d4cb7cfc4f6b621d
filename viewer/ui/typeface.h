#pragma once

struct ImFont;

namespace kerf::ui {

/// The letters of the game, in sizes that suit the height of the picture. Lato (package fonts-lato) where it is
/// installed, then DejaVu Sans, then Dear ImGui's own.
struct Typeface
{
    float unit = 1.0f;  ///< pixels of a unit; all measures of the game are in units, of which a picture is 720 high
    ImFont* text = nullptr;   ///< 20 units high
    ImFont* large = nullptr;  ///< 36
    ImFont* huge = nullptr;   ///< 84; digits, letters and punctuation of ASCII only
};

/// Loads the letters into the current Dear ImGui context, in place of all others. They are in the atlas when the next
/// frame begins. A third of a second at 3840x2160.
Typeface load_typeface(int picture_height);

/// Whether a typeface for another height fits so badly that it should be loaded anew.
bool fits(const Typeface& typeface, int picture_height);

}  // namespace kerf::ui
