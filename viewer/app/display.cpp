#include "viewer/app/display.h"

#include "viewer/render/gl_objects.h"

namespace kerf::app {

bool WindowDisplay::poll()
{
    window_.poll();
    return !window_.should_close();
}

void WindowDisplay::show(const render::FrameTarget& picture)
{
    const glm::ivec2 pixels = size();
    picture.show(pixels.x, pixels.y);
    window_.swap();
}

void OffscreenDisplay::show(const render::FrameTarget&)
{
    glFinish();
}

}  // namespace kerf::app
