#pragma once

#include <string>
#include <vector>

#include "viewer/app/frame_statistics.h"
#include "viewer/app/painter.h"
#include "viewer/app/view_settings.h"
#include "viewer/sim/simulation.h"

namespace kerf::app {

/// What the panel shows and changes.
struct PanelState
{
    const sim::Simulation& simulation;
    const Painter& painter;
    FrameStatistics& frames;
    ViewSettings& view;
    std::string message;         ///< a line for the user; empty: none
    double simulation_ms = 0.0;  ///< of the last frame's ticks
    bool paused = false;
    bool slow_motion = false;
    std::vector<std::string> commands = {};  ///< that the user clicked, for the simulation
};

/// Shows the panel, the list of keys and the message, as the settings say. Between UserInterface::begin() and draw().
void show_panel(PanelState& state);

}  // namespace kerf::app
