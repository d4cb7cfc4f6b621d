#pragma once

#include <memory>
#include <string>

namespace kerf::render {

/// An OpenGL 3.3 core context without window and without display server (EGL, surfaceless platform), current on the
/// calling thread while it lives. Draw to framebuffer objects: there is no default framebuffer.
class OffscreenContext
{
public:
    /// @throws NoDisplay  no EGL display, or it has no OpenGL 3.3
    OffscreenContext();
    ~OffscreenContext();
    OffscreenContext(const OffscreenContext&) = delete;
    OffscreenContext& operator=(const OffscreenContext&) = delete;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

/// Version and renderer of the current context, for reports: "4.5 (Core Profile) Mesa 22.3.6, llvmpipe ...".
std::string describe_current_context();

/// Whether a program on the processor draws in the current context, not a graphics card: frame times say little then.
bool draws_in_software();

}  // namespace kerf::render
