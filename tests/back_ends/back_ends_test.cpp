#include "back_ends/back_ends.h"

#include <gtest/gtest.h>

namespace kerf {
namespace {

TEST(BackEnds, AreFoundByTheNameThatTheyHave)
{
    ASSERT_GE(back_ends().size(), 4u);
    for (const RegisteredBackend& entry : back_ends()) {
        EXPECT_EQ(entry.make()->name(), entry.name);
        EXPECT_EQ(find_back_end(entry.name), &entry);
        EXPECT_EQ(make_back_end(entry.name)->name(), entry.name);
    }
}

TEST(BackEnds, BaselineAloneMeansItsHash)
{
    ASSERT_NE(find_back_end("baseline"), nullptr);
    EXPECT_EQ(find_back_end("baseline")->name, "baseline/hash");
}

TEST(BackEnds, ThatAreNotThereAreNull)
{
    for (const char* name : {"", "axe", "baseline/", "baseline/axe", "halfedge/hash"}) {
        EXPECT_EQ(find_back_end(name), nullptr) << name;
        EXPECT_EQ(make_back_end(name), nullptr) << name;
    }
}

}  // namespace
}  // namespace kerf
