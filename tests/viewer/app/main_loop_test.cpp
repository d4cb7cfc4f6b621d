#include "viewer/app/main_loop.h"

#include <string>
#include <vector>

#include "support/temporary_folder.h"
#include "viewer/render/gl_test.h"

namespace kerf::test {

using app::Frame;
using app::Pace;

namespace {

/// Writes down what it is told.
class Diary : public app::Program
{
public:
    bool has_ended() const override { return ends_after != 0 && frames.size() == ends_after; }
    void advance(const Frame& frame) override { frames.push_back(frame); }
    void sync() override { what += 's'; }
    void draw(const Frame&, const glm::ivec2&) override { what += 'd'; }
    void take_frame_time(double ms) override { times.push_back(ms); }
    const render::FrameTarget& picture() const override { return target; }

    std::size_t ends_after = 0;  ///< 0: never
    std::vector<Frame> frames;
    std::string what;  ///< d: drawn, s: only uploaded
    std::vector<double> times;
    render::FrameTarget target{4, 3};
};

class FakeDisplay : public app::Display
{
public:
    bool poll() override { return polls++ != closed_after; }
    glm::ivec2 size() const override { return extent; }
    void show(const render::FrameTarget&) override { ++shown; }

    int polls = 0, closed_after = -1, shown = 0;
    glm::ivec2 extent{4, 3};
};

class MainLoopTest : public GlTest
{
protected:
    void run(const app::LoopPlan& plan) { app::MainLoop(diary, display, errors, plan).run(); }

    Diary diary;
    FakeDisplay display;
};

}  // namespace

TEST_F(MainLoopTest, RunsSoManyFramesAndSaysWhichIsTheLast)
{
    run({Pace::fixed_step, 3});
    ASSERT_EQ(diary.frames.size(), 3u);
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(diary.frames[i].number, std::int64_t(i));
        EXPECT_EQ(diary.frames[i].is_last, i == 2);
        EXPECT_EQ(diary.frames[i].pace, Pace::fixed_step);
    }
    EXPECT_EQ(display.shown, 3);
    EXPECT_EQ(diary.times.size(), 3u);
}

TEST_F(MainLoopTest, GoesOnUntilTheDisplayIsClosedOrTheProgramHasEnded)
{
    display.closed_after = 5;
    run({});
    EXPECT_EQ(diary.frames.size(), 5u);
    diary.ends_after = 7;
    run({});
    EXPECT_EQ(diary.frames.size(), 7u);
    EXPECT_FALSE(diary.frames.back().is_last) << "nobody knew";
}

TEST_F(MainLoopTest, OnlyUploadsWhatNobodySees)
{
    run({Pace::fixed_step, 5, 2});
    EXPECT_EQ(diary.what, "dsdsd");
    diary.what.clear();
    run({Pace::fixed_step, 3, 0});
    EXPECT_EQ(diary.what, "sss");
    diary.what.clear();
    display.extent = {0, 0};
    run({Pace::real_time, 2});
    EXPECT_EQ(diary.what, "ss") << "a minimised window";
}

TEST_F(MainLoopTest, DrawsTheLastFrameForAScreenshot)
{
    const TemporaryFolder folder;
    const std::filesystem::path file = folder.file("last.png");
    run({Pace::fixed_step, 3, 0, file});
    EXPECT_EQ(diary.what, "ssd");
    EXPECT_GT(std::filesystem::file_size(file), 0u);
}

}  // namespace kerf::test
