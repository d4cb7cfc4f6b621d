#pragma once

#include <glm/vec2.hpp>
#include <memory>
#include <string>
#include <vector>

#include "viewer/sim/pointer_sampler.h"

struct GLFWwindow;

namespace kerf::app {

/// What the pointer did, in window units from the upper left corner.
struct WindowPointer
{
    enum class Kind
    {
        press,
        move,
        release
    } kind = Kind::move;
    glm::dvec2 position{0.0};
};

/// What that means on a stage.
sim::PointerChange::Kind kind_of(WindowPointer::Kind kind);

/// A key that went down or up.
struct WindowKey
{
    int code = 0;  ///< of GLFW
    bool is_down = true;
};

/// A window with an OpenGL 3.3 core context, current while it lives. One at a time.
class Window
{
public:
    /// @throws render::NoDisplay  no display, or no OpenGL 3.3 on it
    Window(int width, int height, bool fullscreen, const std::string& title);
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    GLFWwindow* handle() const;

    /// Takes in what happened; while the window shows nothing it sleeps a while first.
    void poll();
    void swap();
    bool should_close() const;
    void close();

    glm::ivec2 size() const;              ///< window units: what pointer positions are given in
    glm::ivec2 framebuffer_size() const;  ///< pixels; 0 while minimised
    bool has_focus() const;
    float content_scale() const;  ///< 1 at 96 dots per inch
    /// On the whole screen: when it comes back from there.
    void resize(int width, int height);
    void minimise();
    void restore();

    void set_vsync(bool on);
    bool vsync() const;
    void set_fullscreen(bool on);
    bool fullscreen() const;

    /// What happened since the last call, in order.
    std::vector<WindowPointer> take_pointer();
    /// Arrows that are held go down again and again.
    std::vector<WindowKey> take_keys();

    struct State;  ///< what the call-backs of GLFW work on

private:
    std::unique_ptr<State> state_;
};

}  // namespace kerf::app
