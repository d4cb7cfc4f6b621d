#include "viewer/app/inspect/keys.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace kerf::app {

std::optional<KeyAction> action_of(int code)
{
    switch (code) {
        case GLFW_KEY_B:
            return KeyAction::next_backend;
        case GLFW_KEY_L:
            return KeyAction::next_lookup;
        case GLFW_KEY_K:
            return KeyAction::next_proxy;
        case GLFW_KEY_W:
            return KeyAction::wireframe;
        case GLFW_KEY_P:
            return KeyAction::proxies;
        case GLFW_KEY_I:
            return KeyAction::lighting;
        case GLFW_KEY_G:
            return KeyAction::gesture;
        case GLFW_KEY_SPACE:
            return KeyAction::pause;
        case GLFW_KEY_N:
            return KeyAction::single_step;
        case GLFW_KEY_M:
            return KeyAction::slow_motion;
        case GLFW_KEY_R:
            return KeyAction::repeat_throw;
        case GLFW_KEY_T:
            return KeyAction::next_throw;
        case GLFW_KEY_TAB:
            return KeyAction::panel;
        case GLFW_KEY_H:
            return KeyAction::help;
        case GLFW_KEY_F12:
            return KeyAction::screenshot;
        case GLFW_KEY_F11:
            return KeyAction::fullscreen;
        case GLFW_KEY_V:
            return KeyAction::vsync;
        case GLFW_KEY_ESCAPE:
            return KeyAction::quit;
        default:
            return std::nullopt;
    }
}

}  // namespace kerf::app
