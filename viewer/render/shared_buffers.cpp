#include "viewer/render/shared_buffers.h"

#include <cstddef>

namespace kerf::render {

void describe_vertices(const SharedBuffers& buffers)
{
    glBindVertexArray(buffers.vertex_array.id());
    glBindBuffer(GL_ARRAY_BUFFER, buffers.vertices.id());
    const auto attribute = [](GLuint location, GLint floats, std::size_t offset) {
        glEnableVertexAttribArray(location);
        glVertexAttribPointer(location, floats, GL_FLOAT, GL_FALSE, sizeof(DrawVertex), buffer_offset(offset));
    };
    attribute(0, 3, offsetof(DrawVertex, position));
    attribute(1, 3, offsetof(DrawVertex, normal));
    attribute(2, 2, offsetof(DrawVertex, uv));
    if (buffers.members) {
        glBindBuffer(GL_ARRAY_BUFFER, buffers.members->id());
        glEnableVertexAttribArray(3);
        glVertexAttribIPointer(3, 1, GL_UNSIGNED_INT, sizeof(std::uint32_t), buffer_offset(0));
    }
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers.indices.id());
    glBindVertexArray(0);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
}

}  // namespace kerf::render
