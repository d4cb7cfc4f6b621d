#include "viewer/sound/speaker.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

namespace kerf::test {

namespace {

/// OpenAL's own device without a loudspeaker, so that what is behind a device runs, too.
struct NullDevice
{
    NullDevice() { ::setenv("ALSOFT_DRIVERS", "null", 1); }
    ~NullDevice() { ::unsetenv("ALSOFT_DRIVERS"); }
};

void use(sound::Speaker& speaker)
{
    for (int round = 0; round < 5; ++round)
        for (const sound::Sound s : sound::kAllSounds) speaker.play(s, {0.5, 1.5, -1.0});
    speaker.set_fuse(true);
    speaker.set_fuse(true);
    speaker.set_muted(true);
    speaker.set_muted(false);
    speaker.set_fuse(false);
    speaker.silence();
}

}  // namespace

TEST(Speaker, IsHarmlessWithoutADevice)
{
    sound::Speaker speaker = sound::Speaker::silent();
    EXPECT_FALSE(speaker.has_device());
    use(speaker);
}

TEST(Speaker, PlaysMoreSoundsThanItHasVoices)
{
    const NullDevice device;
    sound::Speaker speaker;
    ASSERT_TRUE(speaker.has_device());
    use(speaker);
    sound::Speaker moved = std::move(speaker);
    use(moved);
}

TEST(Speaker, TwoOfThemDoNotDisturbEachOther)
{
    const NullDevice device;
    for (int i = 0; i < 3; ++i) {
        sound::Speaker speaker;
        use(speaker);
    }
}

TEST(Speaker, KeepsTheVolumeWithinBounds)
{
    sound::Speaker speaker = sound::Speaker::silent();
    speaker.set_volume(0.3);
    EXPECT_EQ(speaker.volume(), 0.3);
    speaker.set_volume(-1.0);
    EXPECT_EQ(speaker.volume(), 0.0);
    speaker.set_volume(7.0);
    EXPECT_EQ(speaker.volume(), 1.0);
    speaker.set_volume(std::nan(""));
    EXPECT_EQ(speaker.volume(), 0.0);
}

// With a device or, as where tests run, without one. The last, because OpenAL looks for devices once in a program.
TEST(Speaker, SaysNothingAboutTheDevicesThatItCannotFind)
{
    ::testing::internal::CaptureStderr();
    {
        sound::Speaker speaker;
        use(speaker);
    }
    EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
}

}  // namespace kerf::test
