#include "viewer/app/frame_statistics.h"

#include <gtest/gtest.h>

namespace kerf::test {

using app::FrameStatistics;

TEST(TimeSummary, OfNothingIsZero)
{
    EXPECT_EQ(app::summary_of({}).count, 0u);
    EXPECT_EQ(app::summary_of({}).most, 0.0);
}

TEST(TimeSummary, DoesNotCareAboutOrder)
{
    const app::TimeSummary s = app::summary_of({5.0, 1.0, 3.0, 2.0, 4.0});
    EXPECT_EQ(s.count, 5u);
    EXPECT_EQ(s.least, 1.0);
    EXPECT_EQ(s.median, 3.0);
    EXPECT_EQ(s.mean, 3.0);
    EXPECT_EQ(s.most, 5.0);
}

TEST(FrameStatistics, ForgetsOldFramesButNotTheWorst)
{
    FrameStatistics frames;
    frames.add(100.0);
    for (std::size_t i = 0; i < FrameStatistics::kShown; ++i) frames.add(16.0);
    frames.add(8.0);
    EXPECT_EQ(frames.last(), 8.0);
    EXPECT_EQ(frames.least(), 8.0);
    EXPECT_EQ(frames.most(), 16.0);
    EXPECT_EQ(frames.worst_since_reset(), 100.0);
    frames.reset_worst();
    frames.add(20.0);
    EXPECT_EQ(frames.worst_since_reset(), 20.0);
}

TEST(FrameStatistics, HasNothingToSayBeforeTheFirstFrame)
{
    const FrameStatistics frames;
    EXPECT_EQ(frames.size(), 0u);
    EXPECT_EQ(frames.least(), 0.0);
    EXPECT_EQ(frames.mean(), 0.0);
}

}  // namespace kerf::test
