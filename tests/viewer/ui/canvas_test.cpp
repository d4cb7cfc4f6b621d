#include "viewer/ui/canvas.h"

#include <gtest/gtest.h>
#include <imgui.h>

#include <algorithm>
#include <vector>

namespace kerf::test {

namespace {

/// A frame of Dear ImGui that nothing is drawn of: what a canvas puts down is read from its list.
class CanvasText : public ::testing::Test
{
protected:
    CanvasText()
    {
        ImGui::CreateContext();
        ImGui::GetIO().IniFilename = nullptr;
        ImGui::GetIO().DisplaySize = {640.0f, 360.0f};
        typeface = ui::load_typeface(360);
        ImGui::GetIO().Fonts->Build();
        ImGui::NewFrame();
    }
    ~CanvasText() override
    {
        ImGui::EndFrame();
        ImGui::DestroyContext();
    }

    /// The opacities of the copies of a single letter, in the order they are drawn: the letter itself is the last. What
    /// cannot be seen is not drawn.
    std::vector<float> copies(float height, float opacity)
    {
        const ImDrawList& list = *ImGui::GetBackgroundDrawList();
        const int before = list.VtxBuffer.Size;
        ui::Canvas canvas(typeface, {640.0f, 360.0f});
        canvas.text({320.0f, 180.0f}, {0.5f, 0.5f}, "I", height, ui::kPaper, opacity);
        std::vector<float> found;
        for (int i = before; i < list.VtxBuffer.Size; i += 4)  // a letter has four corners
            found.push_back(static_cast<float>(list.VtxBuffer[i].col >> IM_COL32_A_SHIFT) / 255.0f);
        return found;
    }

    ui::Typeface typeface;
};

/// What one sees of the ground where all of them lie over one another.
float let_through(const std::vector<float>& opacities)
{
    float share = 1.0f;
    for (const float opacity : opacities) share *= 1.0f - opacity;
    return share;
}

}  // namespace

TEST_F(CanvasText, IsNeverDarkerThanItsGroundWhileItFades)
{
    // Bright letters on a ground of half the brightness: the outline is behind them too, in several copies.
    constexpr float kLetter = 0.75f, kGround = 0.5f;
    for (const float height : {20.0f, 34.0f, 58.0f})
        for (int i = 1; i <= 100; ++i) {
            std::vector<float> opacities = copies(height, 0.01f * static_cast<float>(i));
            ASSERT_FALSE(opacities.empty());
            const float letter = opacities.back();
            opacities.pop_back();
            const float seen = (1.0f - letter) * let_through(opacities) * kGround + letter * kLetter;
            EXPECT_GE(seen, kGround - 0.01f) << "letters of " << height << ", opacity " << 0.01 * i;
        }
}

TEST_F(CanvasText, HasAnOutlineThatVanishesWithIt)
{
    for (const float height : {20.0f, 34.0f}) {
        EXPECT_GT(copies(height, 1.0f).front(), 0.3f) << "letters are read on any ground";
        float before = 1.0f;
        for (int i = 100; i >= 1; --i) {
            const std::vector<float> opacities = copies(height, 0.01f * static_cast<float>(i));
            ASSERT_FALSE(opacities.empty());
            const float outline = opacities.size() > 1 ? opacities.front() : 0.0f;
            EXPECT_LE(outline, before);
            EXPECT_LE(outline, opacities.back());
            before = outline;
        }
        EXPECT_EQ(before, 0.0f);
    }
}

}  // namespace kerf::test
