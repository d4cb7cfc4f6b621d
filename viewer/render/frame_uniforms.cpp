#include "viewer/render/frame_uniforms.h"

#include "viewer/render/shader_program.h"

namespace kerf::render {

FrameUniforms::FrameUniforms() : buffer_(GlBuffer::create()) {}

void FrameUniforms::set(const FrameBlock& block)
{
    // New storage each time: the driver need not wait for the last frame's drawing to finish.
    glBindBuffer(GL_UNIFORM_BUFFER, buffer_.id());
    glBufferData(GL_UNIFORM_BUFFER, sizeof(FrameBlock), &block, GL_STREAM_DRAW);
    glBindBuffer(GL_UNIFORM_BUFFER, 0);
    glBindBufferBase(GL_UNIFORM_BUFFER, static_cast<GLuint>(UniformBlock::frame), buffer_.id());
}

}  // namespace kerf::render
