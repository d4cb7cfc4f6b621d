#include "viewer/render/gl_error_log.h"

#include <epoxy/gl.h>

#include <string_view>
#include <utility>

namespace kerf::render {

namespace {

/// A driver that complains in every frame must not fill the memory.
constexpr std::size_t kMostMessages = 20;

void GLAPIENTRY on_message(GLenum, GLenum type, GLuint, GLenum, GLsizei length, const GLchar* text, const void* log)
{
    // Advice about speed and portability is not an error.
    if (type != GL_DEBUG_TYPE_ERROR) return;
    const auto size = length >= 0 ? static_cast<std::size_t>(length) : std::string_view(text).size();
    static_cast<GlErrorLog*>(const_cast<void*>(log))->add(std::string(text, size));
}

}  // namespace

GlErrorLog::GlErrorLog()
{
    has_callback_ = epoxy_gl_version() >= 43 || epoxy_has_gl_extension("GL_KHR_debug");
    if (!has_callback_) return;
    glEnable(GL_DEBUG_OUTPUT);
    glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
    glDebugMessageCallback(on_message, this);
}

GlErrorLog::~GlErrorLog()
{
    if (has_callback_) glDebugMessageCallback(nullptr, nullptr);
}

void GlErrorLog::check()
{
    // With a call-back the same errors have been counted there: only take them away.
    while (const GLenum error = glGetError())
        if (!has_callback_) add("GL error " + std::to_string(error));
}

void GlErrorLog::add(std::string message)
{
    ++count_;
    if (messages_.size() < kMostMessages) messages_.push_back(std::move(message));
}

}  // namespace kerf::render
