#pragma once

#include <glm/vec2.hpp>

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
    float zoom = 1.0f;        ///< enlarges the picture ...
    glm::vec2 zoom_at{0.0f};  ///< ... around this point of the stage, which comes into the middle; metres
    float ui_scale = 1.0f;    ///< of texts; 1 at 96 dots per inch
};

}  // namespace kerf::app
