#pragma once

#include <epoxy/gl.h>

#include <cstddef>
#include <utility>

namespace kerf::render {

/// Owns one GL name. It must die while its context is current; 0 owns nothing.
template <typename Kind>
class GlObject
{
public:
    GlObject() = default;
    GlObject(GlObject&& other) noexcept : id_(std::exchange(other.id_, 0)) {}
    GlObject& operator=(GlObject&& other) noexcept
    {
        std::swap(id_, other.id_);
        return *this;
    }
    ~GlObject()
    {
        if (id_ != 0) Kind::destroy(id_);
    }

    static GlObject create() { return GlObject(Kind::create()); }

    GLuint id() const { return id_; }
    explicit operator bool() const { return id_ != 0; }

private:
    explicit GlObject(GLuint id) : id_(id) {}

    GLuint id_ = 0;
};

namespace gl_kind {

template <typename Generate>
GLuint generated(Generate generate)
{
    GLuint id = 0;
    generate(1, &id);
    return id;
}

struct Buffer
{
    static GLuint create() { return generated(glGenBuffers); }
    static void destroy(GLuint id) { glDeleteBuffers(1, &id); }
};
struct VertexArray
{
    static GLuint create() { return generated(glGenVertexArrays); }
    static void destroy(GLuint id) { glDeleteVertexArrays(1, &id); }
};
struct Texture
{
    static GLuint create() { return generated(glGenTextures); }
    static void destroy(GLuint id) { glDeleteTextures(1, &id); }
};
struct Framebuffer
{
    static GLuint create() { return generated(glGenFramebuffers); }
    static void destroy(GLuint id) { glDeleteFramebuffers(1, &id); }
};
struct Renderbuffer
{
    static GLuint create() { return generated(glGenRenderbuffers); }
    static void destroy(GLuint id) { glDeleteRenderbuffers(1, &id); }
};
struct Program
{
    static GLuint create() { return glCreateProgram(); }
    static void destroy(GLuint id) { glDeleteProgram(id); }
};

}  // namespace gl_kind

using GlBuffer = GlObject<gl_kind::Buffer>;
using GlVertexArray = GlObject<gl_kind::VertexArray>;
using GlTexture = GlObject<gl_kind::Texture>;
using GlFramebuffer = GlObject<gl_kind::Framebuffer>;
using GlRenderbuffer = GlObject<gl_kind::Renderbuffer>;
using GlProgram = GlObject<gl_kind::Program>;

/// An offset into the buffer that is bound, as GL takes it: in a pointer.
inline const void* buffer_offset(std::size_t bytes)
{
    return reinterpret_cast<const void*>(bytes);  // NOLINT(performance-no-int-to-ptr): it points to nothing
}

}  // namespace kerf::render
