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

}  // namespace kerf::test
