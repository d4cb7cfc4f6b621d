#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <string>

#include "viewer/render/gl_error_log.h"
#include "viewer/render/offscreen_context.h"

namespace kerf::test {

/// Pixels of most tests' pictures.
inline constexpr int kWidth = 160, kHeight = 120;

/// How bright a pixel's red, green and blue are together, in [0, 1].
inline double luminance(const std::uint8_t* pixel)
{
    return (0.2126 * pixel[0] + 0.7152 * pixel[1] + 0.0722 * pixel[2]) / 255.0;
}

/// A test that draws, without a screen. Any GL error fails it.
class GlTest : public ::testing::Test
{
protected:
    void TearDown() override
    {
        errors.check();
        for (const std::string& message : errors.messages()) ADD_FAILURE() << "GL: " << message;
    }

    render::OffscreenContext context;
    render::GlErrorLog errors;
};

}  // namespace kerf::test
