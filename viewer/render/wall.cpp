#include "viewer/render/wall.h"

#include "viewer/render/render_error.h"

namespace kerf::render {

namespace {

constexpr float kReliefSpan =
    24.0f;  // world units across the relief: more than a 16:9 window sees; then it is mirrored
constexpr GLsizei kReliefWidth = 2048, kReliefHeight = 1024;
constexpr float kReliefDepth = 0.02f;  // in heights of the texture
constexpr GLsizei kGrainSide = 512;    // plaster_grain.frag knows it, too

GlTexture wall_texture(GLsizei width, GLsizei height, GLenum internal_format, GLenum format, GLenum type,
                       GLint wrap = GL_MIRRORED_REPEAT)
{
    GlTexture texture = GlTexture::create();
    glBindTexture(GL_TEXTURE_2D, texture.id());
    glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(internal_format), width, height, 0, format, type, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, wrap);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, wrap);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    return texture;
}

void draw_over(const GlTexture& texture, GLsizei width, GLsizei height)
{
    const GlFramebuffer framebuffer = GlFramebuffer::create();
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.id());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture.id(), 0);
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        throw RenderError("the graphics driver cannot draw the wall's texture");
    glViewport(0, 0, width, height);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

void make_mipmaps(const GlTexture& texture)
{
    glBindTexture(GL_TEXTURE_2D, texture.id());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glGenerateMipmap(GL_TEXTURE_2D);
    glBindTexture(GL_TEXTURE_2D, 0);
}

}  // namespace

Wall::Wall()
    : nothing_(GlVertexArray::create()),
      program_({"frame.glsl", "wall.vert"}, {"frame.glsl", "tone.glsl", "shadow.glsl", "wall.frag"})
{
    const ShaderProgram plaster({"screen.vert"}, {"noise.glsl", "plaster_height.frag"});
    const ShaderProgram bake({"screen.vert"}, {"wall_bake.frag"});
    glBindVertexArray(nothing_.id());
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_FRAMEBUFFER_SRGB);

    const GlTexture height = wall_texture(kReliefWidth, kReliefHeight, GL_R16F, GL_RED, GL_FLOAT);
    plaster.use();
    draw_over(height, kReliefWidth, kReliefHeight);

    grain_ = wall_texture(kGrainSide, kGrainSide, GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, GL_REPEAT);
    const ShaderProgram grain({"screen.vert"}, {"noise.glsl", "plaster_grain.frag"});
    grain.use();
    draw_over(grain_, kGrainSide, kGrainSide);
    make_mipmaps(grain_);

    relief_ = wall_texture(kReliefWidth, kReliefHeight, GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE);
    glBindTexture(GL_TEXTURE_2D, height.id());
    bake.use();
    glUniform1i(bake.uniform("height_map"), 0);
    glUniform1f(bake.uniform("depth"), kReliefDepth);
    draw_over(relief_, kReliefWidth, kReliefHeight);
    make_mipmaps(relief_);
    glBindVertexArray(0);

    program_.use();
    glUniform1i(program_.uniform("shadow_map"), 0);
    glUniform1i(program_.uniform("relief"), 1);
    glUniform1i(program_.uniform("grain"), 2);
    glUniform4f(program_.uniform("wall"), kHalfWidth, kHalfHeight, kZ, 1.0f / kReliefSpan);
    glUniform3f(program_.uniform("colour_low"), 0.070f, 0.112f, 0.112f);
    glUniform3f(program_.uniform("colour_high"), 0.215f, 0.275f, 0.255f);
    glUniform1f(program_.uniform("light_radius"), kLightRadius);
}

void Wall::draw() const
{
    program_.use();
    glActiveTexture(GL_TEXTURE1);
    glBindTexture(GL_TEXTURE_2D, relief_.id());
    glActiveTexture(GL_TEXTURE2);
    glBindTexture(GL_TEXTURE_2D, grain_.id());
    glActiveTexture(GL_TEXTURE0);
    glBindVertexArray(nothing_.id());
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

}  // namespace kerf::render
