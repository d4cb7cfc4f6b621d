#include "viewer/ui/texts.h"

#include <gtest/gtest.h>

namespace kerf::test {

TEST(Texts, GroupNumbersByThousands)
{
    EXPECT_EQ(ui::number_text(0), "0");
    EXPECT_EQ(ui::number_text(999), "999");
    EXPECT_EQ(ui::number_text(1000), "1 000");
    EXPECT_EQ(ui::number_text(2'000'000), "2 000 000");
    EXPECT_EQ(ui::number_text(-123'456), "-123 456");
}

}  // namespace kerf::test
