#include "viewer/render/effects_pass.h"

#include <cstddef>

#include "viewer/render/splat_shapes.h"
#include "viewer/render/wall.h"

namespace kerf::render {

namespace {

/// In front of the wall, so that the depth buffer can tell them apart. World units.
constexpr float kStainDepth = 0.005f;

/// One float attribute of `components` per instance.
void instance_attribute(GLuint location, GLint components, std::size_t stride, std::size_t offset)
{
    glEnableVertexAttribArray(location);
    glVertexAttribPointer(location, components, GL_FLOAT, GL_FALSE, static_cast<GLsizei>(stride),
                          buffer_offset(offset));
    glVertexAttribDivisor(location, 1);
}

template <typename Sprite>
void draw_sprites(const ShaderProgram& program, const GlVertexArray& array, const GlBuffer& buffer,
                  std::span<const Sprite> sprites)
{
    if (sprites.empty()) return;
    glBindBuffer(GL_ARRAY_BUFFER, buffer.id());
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(sprites.size_bytes()), sprites.data(), GL_STREAM_DRAW);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
    program.use();
    glBindVertexArray(array.id());
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(sprites.size()));
    glBindVertexArray(0);
}

GlTexture texture_of(const SplatShapes& shapes)
{
    GlTexture texture = GlTexture::create();
    glBindTexture(GL_TEXTURE_2D_ARRAY, texture.id());
    glTexImage3D(GL_TEXTURE_2D_ARRAY, 0, GL_RGBA8, SplatShapes::kSide, SplatShapes::kSide, SplatShapes::kShapes, 0,
                 GL_RGBA, GL_UNSIGNED_BYTE, shapes.texels.data());
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glGenerateMipmap(GL_TEXTURE_2D_ARRAY);
    glBindTexture(GL_TEXTURE_2D_ARRAY, 0);
    return texture;
}

}  // namespace

EffectsPass::EffectsPass()
    : stain_({"frame.glsl", "noise.glsl", "stain.vert"}, {"frame.glsl", "tone.glsl", "stain.frag"}),
      flying_({"frame.glsl", "flying.vert"}, {"frame.glsl", "tone.glsl", "noise.glsl", "flying.frag"}),
      splats_(texture_of(make_splat_shapes())),
      stain_instances_(GlBuffer::create()),
      flying_instances_(GlBuffer::create()),
      stain_array_(GlVertexArray::create()),
      flying_array_(GlVertexArray::create())
{
    glBindVertexArray(stain_array_.id());
    glBindBuffer(GL_ARRAY_BUFFER, stain_instances_.id());
    instance_attribute(0, 4, sizeof(StainSprite), offsetof(StainSprite, place));
    instance_attribute(1, 4, sizeof(StainSprite), offsetof(StainSprite, colour));
    instance_attribute(2, 2, sizeof(StainSprite), offsetof(StainSprite, shape));

    glBindVertexArray(flying_array_.id());
    glBindBuffer(GL_ARRAY_BUFFER, flying_instances_.id());
    instance_attribute(0, 4, sizeof(FlyingSprite), offsetof(FlyingSprite, place));
    instance_attribute(1, 4, sizeof(FlyingSprite), offsetof(FlyingSprite, stretch));
    instance_attribute(2, 3, sizeof(FlyingSprite), offsetof(FlyingSprite, colour));
    glBindVertexArray(0);
    glBindBuffer(GL_ARRAY_BUFFER, 0);

    stain_.use();
    glUniform1f(stain_.uniform("wall_z"), Wall::kZ + kStainDepth);
    glUniform1f(stain_.uniform("light_radius"), Wall::kLightRadius);
    glUniform1i(stain_.uniform("splats"), 0);
    glUniform1f(stain_.uniform("reach"), SplatShapes::kReach);
    glUniform1f(stain_.uniform("shapes"), static_cast<float>(SplatShapes::kShapes));
    glUniform1f(stain_.uniform("edge"), SplatShapes::kEdge);
    glUniform1f(stain_.uniform("most_slope"), SplatShapes::kMostSlope);
}

void EffectsPass::draw(std::span<const StainSprite> stains, std::span<const FlyingSprite> flying)
{
    glEnable(GL_DEPTH_TEST);
    glDepthMask(GL_FALSE);
    glEnable(GL_BLEND);
    // The wall is seen through a stain: the shader's second output says how much of each colour is left.
    glBlendFunc(GL_ONE, GL_SRC1_COLOR);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D_ARRAY, splats_.id());
    draw_sprites(stain_, stain_array_, stain_instances_, stains);
    glBindTexture(GL_TEXTURE_2D_ARRAY, 0);
    // Colours come multiplied by their opacity: what glows has none, and adds up.
    glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    draw_sprites(flying_, flying_array_, flying_instances_, flying);
    glDisable(GL_BLEND);
    glDepthMask(GL_TRUE);
}

}  // namespace kerf::render
