#include "viewer/render/overlay.h"

#include <cstddef>
#include <vector>

namespace kerf::render {

namespace {

/// New storage for each frame: the driver need not wait for the last one.
template <typename T>
void stream(const GlBuffer& buffer, std::span<const T> content)
{
    glBindBuffer(GL_ARRAY_BUFFER, buffer.id());
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(content.size_bytes()), content.data(), GL_STREAM_DRAW);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
}

void begin_blending()
{
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glDepthMask(GL_FALSE);
}

void end_blending()
{
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
    glBindVertexArray(0);
}

}  // namespace

Overlay::Overlay()
    : line_({"frame.glsl", "line.vert"}, {"line.frag"}),
      blade_({"blade.vert"}, {"blade.frag"}),
      line_vertices_(GlBuffer::create()),
      blade_vertices_(GlBuffer::create()),
      line_array_(GlVertexArray::create()),
      blade_array_(GlVertexArray::create())
{
    glBindVertexArray(line_array_.id());
    glBindBuffer(GL_ARRAY_BUFFER, line_vertices_.id());
    glEnableVertexAttribArray(0);
    glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(glm::vec3), nullptr);

    glBindVertexArray(blade_array_.id());
    glBindBuffer(GL_ARRAY_BUFFER, blade_vertices_.id());
    glEnableVertexAttribArray(0);
    glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(RibbonVertex), nullptr);
    glEnableVertexAttribArray(1);
    glVertexAttribPointer(1, 1, GL_FLOAT, GL_FALSE, sizeof(RibbonVertex), buffer_offset(offsetof(RibbonVertex, life)));
    glBindVertexArray(0);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
}

void Overlay::draw_lines(std::span<const glm::vec3> points, const glm::vec4& colour)
{
    if (points.empty()) return;
    stream(line_vertices_, points);
    line_.use();
    glBindVertexArray(line_array_.id());
    begin_blending();
    const auto draw = [&](GLenum depth_test, float alpha) {
        glDepthFunc(depth_test);
        glVertexAttrib4f(1, colour.r, colour.g, colour.b, alpha * colour.a);
        glDrawArrays(GL_LINES, 0, static_cast<GLsizei>(points.size()));
    };
    glEnable(GL_DEPTH_TEST);
    draw(GL_GREATER, 0.3f);
    draw(GL_LEQUAL, 1.0f);
    glDepthFunc(GL_LESS);
    end_blending();
}

void Overlay::draw_blade(std::span<const RibbonVertex> ribbon, float width, float height)
{
    if (ribbon.empty()) return;
    std::vector<RibbonVertex> on_screen(ribbon.begin(), ribbon.end());
    for (RibbonVertex& v : on_screen) v.place = 2.0f * v.place / glm::vec2(width, height) - 1.0f;
    stream(blade_vertices_, std::span<const RibbonVertex>(on_screen));
    blade_.use();
    glBindVertexArray(blade_array_.id());
    glDisable(GL_DEPTH_TEST);
    begin_blending();
    glDrawArrays(GL_TRIANGLE_STRIP, 0, static_cast<GLsizei>(on_screen.size()));
    end_blending();
    glEnable(GL_DEPTH_TEST);
}

}  // namespace kerf::render
