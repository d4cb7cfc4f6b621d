#pragma once

#include "viewer/render/scene_renderer.h"

namespace kerf::app {

/// What is shown and how: nothing in here changes what happens.
struct ViewSettings
{
    render::Lighting lighting = render::Lighting::textured;
    bool wireframe = false;
    bool proxies = false;
    bool panel = true;
    bool help = false;
    float ui_scale = 1.0f;  ///< of texts; 1 at 96 dots per inch
};

}  // namespace kerf::app
