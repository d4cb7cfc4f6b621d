#pragma once

#include <glm/vec2.hpp>
#include <nlohmann/json.hpp>

#include "viewer/render/gl_error_log.h"

namespace kerf::app {

/// What every report of a run begins with: the version, the graphics driver and what it complained about.
/// @param size  of the pictures. Needs a current GL context.
nlohmann::ordered_json report_head(const glm::ivec2& size, const render::GlErrorLog& errors);

/// Says what the graphics driver complained about on standard error, and gives the exit status: kUnusable when it did.
int finish_run(const render::GlErrorLog& errors);

}  // namespace kerf::app
