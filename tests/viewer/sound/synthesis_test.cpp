#include "viewer/sound/synthesis.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

namespace kerf::test {

namespace {

using sound::Sound;

double loudness(const std::vector<float>& samples)
{
    double squares = 0.0;
    for (const float s : samples) squares += double(s) * double(s);
    return std::sqrt(squares / double(samples.size()));
}

class SynthesisTest : public ::testing::TestWithParam<Sound>
{
protected:
    const std::vector<float> samples = sound::synthesise(GetParam());
    const double seconds = double(samples.size()) / sound::kSampleRate;
};

std::string test_name(const ::testing::TestParamInfo<Sound>& info)
{
    return std::string(name_of(info.param));
}

}  // namespace

TEST_P(SynthesisTest, IsFiniteAndDoesNotClip)
{
    for (const float s : samples) {
        ASSERT_TRUE(std::isfinite(s));
        ASSERT_LE(std::abs(s), sound::kPeak);
    }
}

TEST_P(SynthesisTest, IsHeardAndEndsInTime)
{
    EXPECT_GT(loudness(samples), 0.01);
    EXPECT_GE(seconds, 0.05);
    EXPECT_LE(seconds, sound::kLongest);
}

TEST_P(SynthesisTest, HasNoOffset)
{
    double sum = 0.0;
    for (const float s : samples) sum += s;
    EXPECT_LT(std::abs(sum / double(samples.size())), 0.01);
}

TEST_P(SynthesisTest, StartsAndEndsWithoutAClick)
{
    if (GetParam() == Sound::fuse) {
        // The seam is no larger a step than others in a sound that hisses.
        float largest = 0.0f;
        for (std::size_t i = 1; i < samples.size(); ++i)
            largest = std::max(largest, std::abs(samples[i] - samples[i - 1]));
        EXPECT_LE(std::abs(samples.front() - samples.back()), largest);
    } else {
        EXPECT_LT(std::abs(samples.front()), 0.05f);
        EXPECT_LT(std::abs(samples.back()), 0.001f);
    }
}

TEST_P(SynthesisTest, IsTheSameEveryTime)
{
    EXPECT_EQ(samples, sound::synthesise(GetParam()));
}

INSTANTIATE_TEST_SUITE_P(All, SynthesisTest, ::testing::ValuesIn(sound::kAllSounds), test_name);

TEST(Synthesis, NoTwoSoundsAreTheSame)
{
    std::set<std::vector<float>> different;
    std::set<std::string_view> names;
    for (const Sound s : sound::kAllSounds) {
        different.insert(sound::synthesise(s));
        names.insert(name_of(s));
    }
    EXPECT_EQ(different.size(), sound::kAllSounds.size());
    EXPECT_EQ(names.size(), sound::kAllSounds.size());
}

}  // namespace kerf::test
