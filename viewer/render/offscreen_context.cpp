#include "viewer/render/offscreen_context.h"

#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include <array>

#include "viewer/render/render_error.h"

namespace kerf::render {

struct OffscreenContext::Impl
{
    EGLDisplay display = EGL_NO_DISPLAY;
    EGLContext context = EGL_NO_CONTEXT;

    ~Impl()
    {
        if (display == EGL_NO_DISPLAY) return;
        eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        if (context != EGL_NO_CONTEXT) eglDestroyContext(display, context);
        eglTerminate(display);
        eglReleaseThread();
    }
};

namespace {

/// The surfaceless platform needs no server; another EGL's own default may do as well.
EGLDisplay open_display()
{
    if (epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless")) {
        const EGLDisplay display =
            eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
        if (display != EGL_NO_DISPLAY && eglInitialize(display, nullptr, nullptr)) return display;
    }
    const EGLDisplay display = eglGetDisplay(EGL_DEFAULT_DISPLAY);
    if (display != EGL_NO_DISPLAY && eglInitialize(display, nullptr, nullptr)) return display;
    return EGL_NO_DISPLAY;
}

}  // namespace

OffscreenContext::OffscreenContext() : impl_(std::make_unique<Impl>())
{
    impl_->display = open_display();
    if (impl_->display == EGL_NO_DISPLAY) throw NoDisplay("there is no EGL display to draw on without a screen");
    eglBindAPI(EGL_OPENGL_API);
    constexpr std::array<EGLint, 9> kAttributes{EGL_CONTEXT_MAJOR_VERSION,
                                                3,
                                                EGL_CONTEXT_MINOR_VERSION,
                                                3,
                                                EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                                EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                                EGL_CONTEXT_FLAGS_KHR,
                                                EGL_CONTEXT_OPENGL_DEBUG_BIT_KHR,
                                                EGL_NONE};
    impl_->context = eglCreateContext(impl_->display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, kAttributes.data());
    if (impl_->context == EGL_NO_CONTEXT ||
        !eglMakeCurrent(impl_->display, EGL_NO_SURFACE, EGL_NO_SURFACE, impl_->context))
        throw NoDisplay("there is no OpenGL 3.3 driver that draws without a screen");
}

OffscreenContext::~OffscreenContext() = default;

bool draws_in_software()
{
    const std::string context = describe_current_context();
    const auto is_named = [&](const char* name) { return context.find(name) != std::string::npos; };
    return is_named("llvmpipe") || is_named("softpipe") || is_named("swrast");
}

std::string describe_current_context()
{
    const auto text = [](GLenum name) {
        const GLubyte* value = glGetString(name);
        return value == nullptr ? std::string("?") : std::string(reinterpret_cast<const char*>(value));
    };
    return text(GL_VERSION) + ", " + text(GL_RENDERER);
}

}  // namespace kerf::render
