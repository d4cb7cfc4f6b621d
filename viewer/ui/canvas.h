#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <string>
#include <string_view>

#include "viewer/ui/typeface.h"

struct ImDrawList;

namespace kerf::ui {

/// A rectangle in pixels from the picture's upper left corner.
struct Box2
{
    glm::vec2 low{0.0f}, high{0.0f};

    glm::vec2 size() const { return high - low; }
    glm::vec2 middle() const { return 0.5f * (low + high); }
    bool holds(const glm::vec2& p) const { return p.x >= low.x && p.x < high.x && p.y >= low.y && p.y < high.y; }
    bool holds(const Box2& other) const
    {
        return other.low.x >= low.x && other.low.y >= low.y && other.high.x <= high.x && other.high.y <= high.y;
    }
};

// sRGB, as everything is drawn here.
inline constexpr glm::vec3 kPaper{0.99f, 0.97f, 0.92f}, kAccent{1.0f, 0.66f, 0.28f}, kDim{0.74f, 0.76f, 0.74f},
    kDanger{1.0f, 0.30f, 0.24f}, kLead{0.55f, 0.95f, 0.45f}, kIce{0.62f, 0.88f, 1.0f}, kInk{0.03f, 0.04f, 0.045f};

/// What the game's texts and panels are drawn with: letters with an outline that can be read before anything, cards,
/// bars, hearts. Over the picture, in the current frame of Dear ImGui. It remembers how far text reached, so that tests
/// can see that all of it fits.
class Canvas
{
public:
    Canvas(const Typeface& typeface, const glm::vec2& size);

    const glm::vec2& size() const { return size_; }
    float unit() const { return typeface_.unit; }
    const Typeface& typeface() const { return typeface_; }

    /// Size of a text in pixels. @param height  of its letters, in units
    glm::vec2 measure(std::string_view text, float height) const;

    /// The text with line breaks where it would be wider than `width` pixels: between words, and within one that is
    /// wider itself, as paths are.
    std::string wrapped(std::string_view text, float height, float width) const;

    /// @param anchor  which part of the text is at `place`: (0, 0) its upper left corner, (1, 1) its lower right one
    /// @param height  of the letters, in units
    void text(const glm::vec2& place, const glm::vec2& anchor, std::string_view text, float height,
              const glm::vec3& colour, float opacity = 1.0f);

    void card(const Box2& box, float opacity = 0.82f);
    /// A frame around what is chosen.
    void frame(const Box2& box, const glm::vec3& colour);
    void fill(const Box2& box, const glm::vec3& colour, float opacity, float rounding = 0.0f);
    void bar(const Box2& box, float share, const glm::vec3& colour);
    void heart(const glm::vec2& middle, float radius, const glm::vec3& colour, float opacity);
    /// A sight for what is steered by keys; closer and brighter while it cuts.
    void cross(const glm::vec2& middle, bool is_cutting);
    /// A single value is a dot.
    void plot(const Box2& box, const float* values, int count, int offset, float most, const glm::vec3& colour);
    /// A frosty rim around a part of the picture.
    void rim(const Box2& box, const glm::vec3& colour, float opacity);

    /// What all texts so far cover; `low` beyond `high`: none.
    const Box2& reach() const { return reach_; }

private:
    const Typeface& typeface_;
    glm::vec2 size_;
    ImDrawList* list_;
    Box2 reach_;
};

}  // namespace kerf::ui
