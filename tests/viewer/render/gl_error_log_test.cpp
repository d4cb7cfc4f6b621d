#include "viewer/render/gl_error_log.h"

#include <epoxy/gl.h>
#include <gtest/gtest.h>

#include "viewer/render/offscreen_context.h"
#include "viewer/render/render_error.h"
#include "viewer/render/shader_program.h"

namespace kerf::test {

TEST(GlErrorLog, CountsWhatTheDriverComplainsAbout)
{
    const render::OffscreenContext context;
    render::GlErrorLog log;
    log.check();
    EXPECT_EQ(log.count(), 0u);
    glEnable(GL_TRIANGLES);  // nothing that can be enabled
    log.check();
    EXPECT_EQ(log.count(), 1u);
    ASSERT_EQ(log.messages().size(), 1u);
    EXPECT_NE(log.messages().front(), "");
}

TEST(GlErrorLog, KeepsTheFirstMessagesOnly)
{
    const render::OffscreenContext context;
    render::GlErrorLog log;
    for (int i = 0; i < 1000; ++i) glEnable(GL_TRIANGLES);
    log.check();
    EXPECT_EQ(log.count(), 1000u);
    EXPECT_LT(log.messages().size(), 100u);
}

TEST(OffscreenContext, OffersOpenGl33)
{
    const render::OffscreenContext context;
    EXPECT_GE(epoxy_gl_version(), 33);
    EXPECT_NE(render::describe_current_context(), "");
}

TEST(OffscreenContext, KnowsThatAProgramDrawsByTheNameOfTheRenderer)
{
    const render::OffscreenContext context;
    const std::string name = render::describe_current_context();
    const bool is_program = name.find("llvmpipe") != std::string::npos || name.find("softpipe") != std::string::npos;
    EXPECT_EQ(render::draws_in_software(), is_program) << name;
}

TEST(ShaderProgram, SaysWhatIsWrongWithAShader)
{
    const render::OffscreenContext context;
    EXPECT_THROW(render::ShaderProgram({"depth.vert"}, {"noise.glsl"}), render::RenderError);
    EXPECT_THROW(render::shader_source("no such shader"), render::RenderError);
}

}  // namespace kerf::test
