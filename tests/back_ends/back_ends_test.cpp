#include "back_ends/back_ends.h"

#include <gtest/gtest.h>

#include "baseline/report_back_ends.h"
#include "common/caps/constrained_triangulator.h"

namespace kerf::core {
namespace {

std::vector<std::string> first_names(std::size_t count)
{
    std::vector<std::string> names;
    for (const RegisteredBackend* entry : back_ends()) names.push_back(entry->name);
    names.resize(std::min(count, names.size()));
    return names;
}

// KERF_BUILD_HALFEDGE is the build's option itself: what the list goes by is judged here.
TEST(BackEnds, AreThoseThatTheBuildWasAskedFor)
{
    std::vector<std::string> expected{"linear"};
    if (KERF_BUILD_HALFEDGE) expected.insert(expected.begin(), "halfedge");
    if (KERF_BUILD_HALFEDGE && has_constrained_ways()) expected.push_back("halfedge/cgal");
    EXPECT_EQ(first_names(expected.size()), expected);
}

TEST(BackEnds, OfTheReportAreAddedBehindTheOthersAndOnce)
{
    const std::vector<std::string> expected{"baseline/hash", "baseline/remap", "baseline/two_bucket_hash",
                                            "baseline/scan"};
    for (int times = 0; times < 2; ++times) {
        add_report_back_ends();
        const std::vector<std::string> all = first_names(back_ends().size());
        EXPECT_EQ(std::vector<std::string>(all.end() - 4, all.end()), expected);
        const std::size_t of_halfedge = KERF_BUILD_HALFEDGE == 0 ? 0 : has_constrained_ways() ? 2 : 1;
        EXPECT_EQ(all.size(), expected.size() + 1 + of_halfedge);
    }
}

TEST(BackEnds, AreFoundByTheNameThatTheyHave)
{
    add_report_back_ends();
    for (const RegisteredBackend* entry : back_ends()) {
        EXPECT_EQ(entry->make()->name(), entry->name);
        EXPECT_EQ(core::find_back_end(entry->name), entry);
        EXPECT_EQ(entry->back_end->name(), entry->name);
    }
}

TEST(BackEnds, BaselineAloneMeansItsHash)
{
    add_report_back_ends();
    ASSERT_NE(find_back_end("baseline"), nullptr);
    EXPECT_EQ(find_back_end("baseline")->name, "baseline/hash");
}

TEST(BackEnds, ThatNeedCgalAreThereWithIt)
{
    if (!KERF_BUILD_HALFEDGE || !has_constrained_ways()) {
        EXPECT_EQ(find_back_end("halfedge/cgal"), nullptr);
        return;
    }
    ASSERT_NE(find_back_end("halfedge/cgal"), nullptr);
    EXPECT_EQ(find_back_end("halfedge")->name, "halfedge");
}

TEST(BackEnds, ThatAreNotThereAreNull)
{
    for (const char* name : {"", "axe", "baseline/", "baseline/axe", "halfedge/hash"})
        EXPECT_EQ(find_back_end(name), nullptr) << name;
}

}  // namespace
}  // namespace kerf::core
