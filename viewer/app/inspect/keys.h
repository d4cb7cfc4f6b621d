#pragma once

#include <array>
#include <optional>

namespace kerf::app {

/// What a key does, in the words of the help overlay.
enum class KeyAction
{
    next_backend,
    next_lookup,
    next_proxy,
    wireframe,
    proxies,
    lighting,
    gesture,
    pause,
    single_step,
    slow_motion,
    repeat_throw,
    next_throw,
    panel,
    help,
    screenshot,
    fullscreen,
    vsync,
    quit,
};

struct KeyBinding
{
    KeyAction action;
    const char* key;
    const char* description;
};

inline constexpr std::array kKeyBindings{
    KeyBinding{KeyAction::next_backend, "B", "other back end, from the next throw on"},
    KeyBinding{KeyAction::next_lookup, "L", "next vertex look-up of the baseline"},
    KeyBinding{KeyAction::next_proxy, "K", "next kind of collision proxy"},
    KeyBinding{KeyAction::gesture, "G", "cut while moving, or on release"},
    KeyBinding{KeyAction::repeat_throw, "R", "repeat the last throw"},
    KeyBinding{KeyAction::next_throw, "T", "throw the next model now"},
    KeyBinding{KeyAction::pause, "Space", "pause"},
    KeyBinding{KeyAction::single_step, "N", "one frame while paused"},
    KeyBinding{KeyAction::slow_motion, "M", "slow motion"},
    KeyBinding{KeyAction::lighting, "I", "illumination: textured or the report's"},
    KeyBinding{KeyAction::wireframe, "W", "wireframe"},
    KeyBinding{KeyAction::proxies, "P", "collision proxies"},
    KeyBinding{KeyAction::panel, "Tab", "panel"},
    KeyBinding{KeyAction::help, "H", "this list"},
    KeyBinding{KeyAction::screenshot, "F12", "save a picture"},
    KeyBinding{KeyAction::fullscreen, "F11", "fullscreen"},
    KeyBinding{KeyAction::vsync, "V", "wait for the screen or not"},
    KeyBinding{KeyAction::quit, "Esc", "quit"},
};

/// What the key of a code of GLFW does; empty: nothing.
std::optional<KeyAction> action_of(int code);

}  // namespace kerf::app
