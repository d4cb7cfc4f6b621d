#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "viewer/app/view_settings.h"
#include "viewer/inside/study.h"

namespace kerf::app {

/// What a key does in the scene section, for the list of keys.
struct InsideKey
{
    const char* key;
    const char* description;
};

inline constexpr std::array kInsideKeys{
    InsideKey{"drag", "move the plane"},
    InsideKey{"right drag", "turn the plane; with Shift the left button does, too"},
    InsideKey{"C", "contours behind the plane"},
    InsideKey{"F", "the other half"},
    InsideKey{"N", "next model"},
    InsideKey{"B", "next back end"},
    InsideKey{"I", "illumination: textured or the report's"},
    InsideKey{"W", "wireframe"},
    InsideKey{"Tab", "panel"},
    InsideKey{"H", "this list"},
    InsideKey{"F12", "save a picture"},
    InsideKey{"F11", "fullscreen"},
    InsideKey{"Esc", "quit"},
};

/// What the panel shows of a study.
struct InsidePanel
{
    const inside::Study& study;
    double upload_cpu_ms = 0.0;
    std::string message;  ///< a line for the user; empty: none
};

/// Shows the panel, the list of keys and the message, as the settings say. Between UserInterface::begin() and draw().
void show_inside_panel(const InsidePanel& panel, const ViewSettings& view);

}  // namespace kerf::app
