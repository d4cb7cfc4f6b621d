#include "viewer/effects/popups.h"

#include <gtest/gtest.h>

#include <cmath>

namespace kerf::test {

using effects::Popup;
using effects::Popups;

TEST(Popup, SpringsUpRisesAndFades)
{
    Popup popup;
    EXPECT_NEAR(popup.scale(), 0.0f, 1e-6f);
    EXPECT_EQ(popup.rise(), 0.0f);
    popup.age = 0.1f;
    EXPECT_GT(popup.scale(), 1.0f);
    popup.age = 0.5f;
    EXPECT_EQ(popup.scale(), 1.0f);
    EXPECT_EQ(popup.opacity(), 1.0f);
    EXPECT_GT(popup.rise(), 0.2f);
    popup.age = popup.life;
    EXPECT_EQ(popup.opacity(), 0.0f);
}

TEST(Popups, AreBoundedAndEnd)
{
    Popups popups;
    for (std::size_t i = 0; i < 2 * Popups::kMost; ++i) popups.add({{}, std::to_string(i)});
    EXPECT_EQ(popups.all().size(), Popups::kMost);
    EXPECT_EQ(popups.all().back().text, std::to_string(2 * Popups::kMost - 1));
    for (int i = 0; i < 12; ++i) popups.advance(0.1f);
    EXPECT_TRUE(popups.all().empty());
}

TEST(Popups, DoNotCoverOneAnother)
{
    // As at the end of a swipe through three fruit: the points of the last one where the combo appears.
    Popups popups;
    for (const char* text : {"+1", "3 fruit combo\n+3", "Critical +5"}) {
        Popup popup;
        popup.text = text;
        popup.size = text[0] == '3' ? 1.7f : 0.8f;
        popups.add(popup);
    }
    ASSERT_EQ(popups.all().size(), 3u);
    EXPECT_EQ(popups.all()[0].place.y, 0.0f) << "what stands alone stays where it was wanted";
    const auto half_height = [](const Popup& popup) {
        const bool has_two_lines = popup.text.find('\n') != std::string::npos;
        return 0.5f * 8.0f * 34.0f / 720.0f * popup.size * (has_two_lines ? 2.0f : 1.0f);
    };
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < i; ++j)
            EXPECT_GE(std::abs(popups.all()[i].place.y - popups.all()[j].place.y),
                      half_height(popups.all()[i]) + half_height(popups.all()[j]))
                << popups.all()[i].text << " and " << popups.all()[j].text;
}

}  // namespace kerf::test
