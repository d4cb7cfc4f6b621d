#include "viewer/app/window.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <utility>

#include "viewer/render/render_error.h"

namespace kerf::app {

namespace {

std::string last_glfw_error()
{
    const char* text = nullptr;
    return glfwGetError(&text) == GLFW_NO_ERROR || text == nullptr ? "no reason given" : text;
}

struct GlfwLibrary
{
    GlfwLibrary()
    {
        if (glfwInit() == GLFW_FALSE)
            throw render::NoDisplay("there is no display; --headless needs none: " + last_glfw_error());
    }
    ~GlfwLibrary() { glfwTerminate(); }
};

struct DestroyWindow
{
    void operator()(GLFWwindow* window) const { glfwDestroyWindow(window); }
};

}  // namespace

sim::PointerChange::Kind kind_of(WindowPointer::Kind kind)
{
    switch (kind) {
        case WindowPointer::Kind::press:
            return sim::PointerChange::Kind::press;
        case WindowPointer::Kind::move:
            return sim::PointerChange::Kind::move;
        case WindowPointer::Kind::release:
            break;
    }
    return sim::PointerChange::Kind::release;
}

struct Window::State
{
    GlfwLibrary library;
    std::unique_ptr<GLFWwindow, DestroyWindow> window;
    bool vsync = true;
    glm::ivec2 place{60, 60}, size{1280, 720};  ///< to come back to from fullscreen
    std::vector<WindowPointer> pointer;
    std::vector<WindowKey> keys;

    glm::dvec2 cursor() const
    {
        glm::dvec2 position(0.0);
        glfwGetCursorPos(window.get(), &position.x, &position.y);
        return position;
    }
};

namespace {

Window::State& state_of(GLFWwindow* window)
{
    return *static_cast<Window::State*>(glfwGetWindowUserPointer(window));
}

void on_button(GLFWwindow* window, int button, int action, int)
{
    if (button != GLFW_MOUSE_BUTTON_LEFT) return;
    Window::State& state = state_of(window);
    const auto kind = action == GLFW_PRESS ? WindowPointer::Kind::press : WindowPointer::Kind::release;
    state.pointer.push_back({kind, state.cursor()});
}

void on_move(GLFWwindow* window, double x, double y)
{
    state_of(window).pointer.push_back({WindowPointer::Kind::move, {x, y}});
}

void on_key(GLFWwindow* window, int key, int, int action, int)
{
    // Arrows move on while they are held; a command is given once.
    const bool is_arrow = key == GLFW_KEY_UP || key == GLFW_KEY_DOWN || key == GLFW_KEY_LEFT || key == GLFW_KEY_RIGHT;
    if (action != GLFW_REPEAT || is_arrow) state_of(window).keys.push_back({key, action != GLFW_RELEASE});
}

/// A button that is released outside is never reported: losing the focus ends a swipe.
void on_focus(GLFWwindow* window, int focused)
{
    Window::State& state = state_of(window);
    if (focused == GLFW_FALSE) state.pointer.push_back({WindowPointer::Kind::release, state.cursor()});
}

}  // namespace

Window::Window(int width, int height, bool fullscreen, const std::string& title) : state_(std::make_unique<State>())
{
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
    glfwWindowHint(GLFW_OPENGL_DEBUG_CONTEXT, GLFW_TRUE);
    glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
    // Pictures are drawn into a framebuffer of our own.
    glfwWindowHint(GLFW_DEPTH_BITS, 0);
    glfwWindowHint(GLFW_STENCIL_BITS, 0);
    state_->window.reset(glfwCreateWindow(width, height, title.c_str(), nullptr, nullptr));
    if (!state_->window) throw render::NoDisplay("there is no window with OpenGL 3.3: " + last_glfw_error());
    state_->size = {width, height};
    GLFWwindow* const window = state_->window.get();
    glfwMakeContextCurrent(window);
    glfwSetWindowUserPointer(window, state_.get());
    glfwSetMouseButtonCallback(window, on_button);
    glfwSetCursorPosCallback(window, on_move);
    glfwSetKeyCallback(window, on_key);
    glfwSetWindowFocusCallback(window, on_focus);
    set_vsync(true);
    if (fullscreen) set_fullscreen(true);
}

Window::~Window() = default;

GLFWwindow* Window::handle() const
{
    return state_->window.get();
}

void Window::poll()
{
    constexpr double kNap = 0.1;  // seconds
    if (framebuffer_size().x == 0 || framebuffer_size().y == 0)
        glfwWaitEventsTimeout(kNap);
    else
        glfwPollEvents();
}

void Window::swap()
{
    glfwSwapBuffers(handle());
}

bool Window::should_close() const
{
    return glfwWindowShouldClose(handle()) == GLFW_TRUE;
}

void Window::close()
{
    glfwSetWindowShouldClose(handle(), GLFW_TRUE);
}

glm::ivec2 Window::size() const
{
    glm::ivec2 size(0);
    glfwGetWindowSize(handle(), &size.x, &size.y);
    return size;
}

glm::ivec2 Window::framebuffer_size() const
{
    if (glfwGetWindowAttrib(handle(), GLFW_ICONIFIED) == GLFW_TRUE) return {0, 0};
    glm::ivec2 size(0);
    glfwGetFramebufferSize(handle(), &size.x, &size.y);
    return size;
}

bool Window::has_focus() const
{
    return glfwGetWindowAttrib(handle(), GLFW_FOCUSED) == GLFW_TRUE;
}

float Window::content_scale() const
{
    float x = 1.0f, y = 1.0f;
    glfwGetWindowContentScale(handle(), &x, &y);
    return x > 0.0f ? x : 1.0f;
}

void Window::resize(int width, int height)
{
    state_->size = {width, height};
    if (!fullscreen()) glfwSetWindowSize(handle(), width, height);
}

void Window::minimise()
{
    glfwIconifyWindow(handle());
}

void Window::restore()
{
    glfwRestoreWindow(handle());
}

void Window::set_vsync(bool on)
{
    state_->vsync = on;
    glfwSwapInterval(on ? 1 : 0);
}

bool Window::vsync() const
{
    return state_->vsync;
}

void Window::set_fullscreen(bool on)
{
    if (on == fullscreen()) return;
    if (!on) {
        glfwSetWindowMonitor(handle(), nullptr, state_->place.x, state_->place.y, state_->size.x, state_->size.y,
                             GLFW_DONT_CARE);
    } else if (GLFWmonitor* const monitor = glfwGetPrimaryMonitor()) {
        glfwGetWindowPos(handle(), &state_->place.x, &state_->place.y);
        state_->size = size();
        const GLFWvidmode* const mode = glfwGetVideoMode(monitor);
        glfwSetWindowMonitor(handle(), monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
    }
    set_vsync(state_->vsync);
}

bool Window::fullscreen() const
{
    return glfwGetWindowMonitor(handle()) != nullptr;
}

std::vector<WindowPointer> Window::take_pointer()
{
    return std::exchange(state_->pointer, {});
}

std::vector<WindowKey> Window::take_keys()
{
    return std::exchange(state_->keys, {});
}

}  // namespace kerf::app
