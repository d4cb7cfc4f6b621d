#include "viewer/app/run_report.h"

#include <kerf/version.h>

#include <iostream>
#include <string>

#include "viewer/app/exit_status.h"
#include "viewer/render/offscreen_context.h"

namespace kerf::app {

nlohmann::ordered_json report_head(const glm::ivec2& size, const render::GlErrorLog& errors)
{
    return {{"version", KERF_VERSION},
            {"graphics", render::describe_current_context()},
            {"width", size.x},
            {"height", size.y},
            {"gl_errors", errors.count()},
            {"gl_messages", errors.messages()}};
}

int finish_run(const render::GlErrorLog& errors)
{
    for (const std::string& message : errors.messages()) std::cerr << "kerf-viewer: GL: " << message << "\n";
    return errors.count() == 0 ? kDone : kUnusable;
}

}  // namespace kerf::app
