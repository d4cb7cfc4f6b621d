#include "viewer/render/effects_pass.h"

#include <cstddef>

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
                          reinterpret_cast<const void*>(offset));
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

}  // namespace

EffectsPass::EffectsPass()
    : stain_({"frame.glsl", "stain.vert"}, {"frame.glsl", "tone.glsl", "noise.glsl", "stain.frag"}),
      flying_({"frame.glsl", "flying.vert"}, {"frame.glsl", "tone.glsl", "noise.glsl", "flying.frag"}),
      stain_instances_(GlBuffer::create()),
      flying_instances_(GlBuffer::create()),
      stain_array_(GlVertexArray::create()),
      flying_array_(GlVertexArray::create())
{
    glBindVertexArray(stain_array_.id());
    glBindBuffer(GL_ARRAY_BUFFER, stain_instances_.id());
    instance_attribute(0, 4, sizeof(StainSprite), offsetof(StainSprite, place));
    instance_attribute(1, 4, sizeof(StainSprite), offsetof(StainSprite, colour));
    instance_attribute(2, 1, sizeof(StainSprite), offsetof(StainSprite, shape));

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
}

void EffectsPass::draw(std::span<const StainSprite> stains, std::span<const FlyingSprite> flying)
{
    glEnable(GL_DEPTH_TEST);
    glDepthMask(GL_FALSE);
    glEnable(GL_BLEND);
    // Colours come multiplied by their opacity: what glows has none, and adds up.
    glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    draw_sprites(stain_, stain_array_, stain_instances_, stains);
    draw_sprites(flying_, flying_array_, flying_instances_, flying);
    glDisable(GL_BLEND);
    glDepthMask(GL_TRUE);
}

}  // namespace kerf::render
