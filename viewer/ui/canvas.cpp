#include "viewer/ui/canvas.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <limits>
#include <string>

namespace kerf::ui {

namespace {

ImU32 packed(const glm::vec3& colour, float opacity)
{
    return ImGui::ColorConvertFloat4ToU32(ImVec4(colour.r, colour.g, colour.b, std::clamp(opacity, 0.0f, 1.0f)));
}

ImVec2 vec(const glm::vec2& v)
{
    return {v.x, v.y};
}

}  // namespace

Canvas::Canvas(const Typeface& typeface, const glm::vec2& size)
    : typeface_(typeface), size_(size), list_(ImGui::GetBackgroundDrawList())
{
    constexpr float kFar = std::numeric_limits<float>::max();
    reach_ = {{kFar, kFar}, {-kFar, -kFar}};
}

/// The letters that are enlarged least.
static ImFont* font_for(const Typeface& typeface, float height)
{
    if (height <= 26.0f) return typeface.text;
    return height <= 44.0f ? typeface.large : typeface.huge;
}

glm::vec2 Canvas::measure(std::string_view text, float height) const
{
    const ImVec2 size = font_for(typeface_, height)
                            ->CalcTextSizeA(height * unit(), std::numeric_limits<float>::max(), 0.0f, text.data(),
                                            text.data() + text.size());
    return {size.x, size.y};
}

std::string Canvas::wrapped(std::string_view text, float height, float width) const
{
    std::string lines;
    std::size_t begin = 0;
    while (begin < text.size()) {
        std::size_t end = begin, space = begin;
        while (end < text.size()) {
            std::size_t next = end + 1;  // whole letters: those of UTF-8 go on with 10xxxxxx
            while (next < text.size() && (static_cast<unsigned char>(text[next]) & 0xC0u) == 0x80u) ++next;
            if (end > begin && measure(text.substr(begin, next - begin), height).x > width) break;
            if (text[end] == ' ') space = end;
            end = next;
        }
        if (end < text.size() && space > begin) end = space;
        if (!lines.empty()) lines += '\n';
        lines += text.substr(begin, end - begin);
        begin = end;
        while (begin < text.size() && text[begin] == ' ') ++begin;
    }
    return lines;
}

void Canvas::text(const glm::vec2& place, const glm::vec2& anchor, std::string_view text, float height,
                  const glm::vec3& colour, float opacity)
{
    if (text.empty() || opacity <= 0.0f) return;
    ImFont* const font = font_for(typeface_, height);
    const glm::vec2 whole = measure(text, height);
    const glm::vec2 corner = place - anchor * whole;
    reach_ = {glm::min(reach_.low, corner), glm::max(reach_.high, corner + whole)};
    // Small letters are read better with a thin rim.
    const bool is_small = height <= 26.0f;
    const float rim = std::max(is_small ? 0.7f : 1.0f, (is_small ? 0.045f : 0.035f) * height * unit());
    // Copies of the outline lie over one another, and behind the letters too. Letters that fade over it would turn dark
    // and muddy before they vanish: it goes first. Of n copies 1 - (1 - a)^n is seen, so the share is an exponent.
    const float share = std::pow(std::min(opacity, 1.0f), 4.0f);
    const float ink_opacity = 1.0f - std::pow(is_small ? 0.62f : 0.38f, share);
    const ImU32 ink = packed(kInk, ink_opacity), fill = packed(colour, opacity);

    // Dark letters are for bright grounds.
    const bool is_dark = colour.x + colour.y + colour.z < 0.6f;
    // Lines are centred on one another as the anchor says.
    float y = corner.y;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        const std::string_view line = text.substr(begin, end - begin);
        const glm::vec2 size = measure(line, height);
        const glm::vec2 start(corner.x + anchor.x * (whole.x - size.x), y);
        const auto draw = [&](const glm::vec2& offset, ImU32 tone) {
            list_->AddText(font, height * unit(), vec(start + offset), tone, line.data(), line.data() + line.size());
        };
        if (!is_dark)
            for (const glm::vec2 side : {glm::vec2(-1, 0), glm::vec2(1, 0), glm::vec2(0, -1), glm::vec2(0, 1.6f),
                                         glm::vec2(0.7f, 0.9f), glm::vec2(-0.7f, 0.9f)})
                draw(rim * side, ink);
        draw({0.0f, 0.0f}, fill);
        y += height * unit();
        begin = end + 1;
    }
}

void Canvas::fill(const Box2& box, const glm::vec3& colour, float opacity, float rounding)
{
    list_->AddRectFilled(vec(box.low), vec(box.high), packed(colour, opacity), rounding);
}

void Canvas::card(const Box2& box, float opacity)
{
    fill(box, {0.05f, 0.062f, 0.066f}, opacity, 14.0f * unit());
}

void Canvas::frame(const Box2& box, const glm::vec3& colour)
{
    list_->AddRect(vec(box.low), vec(box.high), packed(colour, 1.0f), 10.0f * unit(), 0, 2.5f * unit());
}

void Canvas::bar(const Box2& box, float share, const glm::vec3& colour)
{
    const float rounding = 0.5f * box.size().y;
    fill(box, kInk, 0.55f, rounding);
    const float width = std::max(std::clamp(share, 0.0f, 1.0f) * box.size().x, 2.0f * rounding);
    if (share > 0.0f) fill({box.low, {box.low.x + width, box.high.y}}, colour, 1.0f, rounding);
}

void Canvas::heart(const glm::vec2& middle, float radius, const glm::vec3& colour, float opacity)
{
    constexpr int kPoints = 40;
    const auto outline = [&](float size, ImU32 tone) {
        // Two halves, each convex enough to be filled.
        for (const float side : {-1.0f, 1.0f}) {
            list_->PathClear();
            for (int i = 0; i <= kPoints; ++i) {
                const float t = 3.14159265f * static_cast<float>(i) / static_cast<float>(kPoints);
                const float x = std::pow(std::sin(t), 3.0f);
                const float y =
                    (13.0f * std::cos(t) - 5.0f * std::cos(2.0f * t) - 2.0f * std::cos(3.0f * t) - std::cos(4.0f * t)) /
                    16.0f;
                list_->PathLineTo(vec(middle + size * glm::vec2(side * x, -y)));
            }
            list_->PathFillConvex(tone);
        }
    };
    outline(1.16f * radius, packed(kInk, 0.6f * opacity));
    outline(radius, packed(colour, opacity));
}

void Canvas::cross(const glm::vec2& middle, bool is_cutting)
{
    const float inner = (is_cutting ? 4.0f : 8.0f) * unit(), outer = (is_cutting ? 18.0f : 24.0f) * unit();
    const float half = 1.6f * unit(), rim = 1.2f * unit();
    const glm::vec3 colour = is_cutting ? kAccent : kPaper;
    for (const glm::vec2 along : {glm::vec2(1, 0), glm::vec2(-1, 0), glm::vec2(0, 1), glm::vec2(0, -1)}) {
        const glm::vec2 across(half * glm::abs(glm::vec2(along.y, along.x)));
        const glm::vec2 one = middle + inner * along, other = middle + outer * along;
        const Box2 box{glm::min(one, other) - across, glm::max(one, other) + across};
        fill({box.low - rim, box.high + rim}, kInk, 0.55f, half + rim);
        fill(box, colour, 0.95f, half);
    }
}

void Canvas::plot(const Box2& box, const float* values, int count, int offset, float most, const glm::vec3& colour)
{
    if (count < 1 || !(most > 0.0f)) return;
    if (count == 1) {
        const float height = std::clamp(values[0] / most, 0.0f, 1.0f);
        return list_->AddCircleFilled({box.low.x + 3.0f * unit(), box.high.y - height * box.size().y}, 3.0f * unit(),
                                      packed(colour, 1.0f));
    }
    list_->PathClear();
    for (int i = 0; i < count; ++i) {
        const float share = static_cast<float>(i) / static_cast<float>(count - 1);
        const float height = std::clamp(values[(i + offset) % count] / most, 0.0f, 1.0f);
        list_->PathLineTo({box.low.x + share * box.size().x, box.high.y - height * box.size().y});
    }
    list_->PathStroke(packed(colour, 1.0f), 0, 1.6f * unit());
}

void Canvas::rim(const Box2& box, const glm::vec3& colour, float opacity)
{
    const ImU32 full = packed(colour, opacity), none = packed(colour, 0.0f);
    const glm::vec2 deep = 0.16f * glm::vec2(box.size().y);
    list_->AddRectFilledMultiColor(vec(box.low), {box.high.x, box.low.y + deep.y}, full, full, none, none);
    list_->AddRectFilledMultiColor({box.low.x, box.high.y - deep.y}, vec(box.high), none, none, full, full);
    list_->AddRectFilledMultiColor(vec(box.low), {box.low.x + deep.x, box.high.y}, full, none, none, full);
    list_->AddRectFilledMultiColor({box.high.x - deep.x, box.low.y}, vec(box.high), none, full, full, none);
}

}  // namespace kerf::ui
