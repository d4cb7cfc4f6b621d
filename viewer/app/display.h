#pragma once

#include <glm/vec2.hpp>

#include "viewer/app/window.h"
#include "viewer/render/frame_target.h"

namespace kerf::app {

/// Where pictures go.
class Display
{
public:
    virtual ~Display() = default;
    /// Takes in what happened. False: it was closed.
    virtual bool poll() = 0;
    /// Of pictures, pixels; 0: nothing can be seen now.
    virtual glm::ivec2 size() const = 0;
    /// Returns when the picture is finished, or on its way to the screen.
    virtual void show(const render::FrameTarget& picture) = 0;
};

/// A window.
class WindowDisplay : public Display
{
public:
    explicit WindowDisplay(Window& window) : window_(window) {}

    bool poll() override;
    glm::ivec2 size() const override { return window_.framebuffer_size(); }
    void show(const render::FrameTarget& picture) override;

private:
    Window& window_;
};

/// Pictures that are finished and not seen.
class OffscreenDisplay : public Display
{
public:
    explicit OffscreenDisplay(const glm::ivec2& size) : size_(size) {}

    bool poll() override { return true; }
    glm::ivec2 size() const override { return size_; }
    void show(const render::FrameTarget& picture) override;

private:
    glm::ivec2 size_;
};

}  // namespace kerf::app
