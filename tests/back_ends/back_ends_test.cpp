#include "back_ends/back_ends.h"

#include <gtest/gtest.h>

namespace kerf {
namespace {

// KERF_BUILD_HALFEDGE is the build's option itself: what the list goes by is judged here.
TEST(BackEnds, AreThoseThatTheBuildWasAskedFor)
{
    std::vector<std::string> names,
        expected{"linear", "baseline/hash", "baseline/remap", "baseline/two_bucket_hash", "baseline/scan"};
    if (KERF_BUILD_HALFEDGE) expected.insert(expected.begin(), "halfedge");
    for (const RegisteredBackend& entry : back_ends()) names.push_back(entry.name);
    EXPECT_EQ(names, expected);
}

TEST(BackEnds, AreFoundByTheNameThatTheyHave)
{
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
