#include "viewer/app/game/cut_times.h"

#include <gtest/gtest.h>

namespace kerf::test {

namespace {

sim::CutRecord cut(const std::string& backend, double ms, bool went_through = true)
{
    sim::CutRecord record;
    record.backend = backend;
    record.cut_ms = 0.5 * ms;
    record.proxy_ms = 0.25 * ms;
    record.bodies_ms = 0.25 * ms;
    if (went_through) record.pieces.resize(2);
    return record;
}

}  // namespace

TEST(CutTimes, KeepASeriesForEachBackEnd)
{
    app::CutTimes times;
    std::vector<sim::CutRecord> log{cut("baseline", 716.0), cut("baseline", 640.0)};
    times.follow(log);
    EXPECT_EQ(times.of("halfedge"), nullptr) << "it has not cut yet";
    log.push_back(cut("halfedge", 2.0));
    times.follow(log);
    times.follow(log);
    ASSERT_EQ(times.series().size(), 2u);
    EXPECT_EQ(times.of("baseline")->times.size(), 2u);
    EXPECT_EQ(times.of("baseline")->times.last(), 640.0);
    ASSERT_NE(times.of("halfedge"), nullptr);
    EXPECT_EQ(times.of("halfedge")->times.size(), 1u) << "each cut counts once";
    EXPECT_EQ(times.of("halfedge")->times.most(), 2.0);
    EXPECT_EQ(times.most(), 716.0);
}

TEST(CutTimes, LeaveOutWhatWentThroughNothing)
{
    app::CutTimes times;
    times.follow({cut("halfedge", 9.0, false)});
    EXPECT_TRUE(times.series().empty());
    EXPECT_EQ(times.most(), 0.0);
}

}  // namespace kerf::test
