#pragma once

#include <gtest/gtest.h>

#include "viewer/render/gl_error_log.h"
#include "viewer/render/offscreen_context.h"

namespace kerf::test {

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
