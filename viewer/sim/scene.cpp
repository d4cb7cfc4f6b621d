#include "viewer/sim/scene.h"

#include "viewer/sim/report_scene.h"

namespace kerf::sim {

std::unique_ptr<Scene> make_scene(std::string_view name)
{
    if (name == "report") return std::make_unique<ReportScene>();
    return nullptr;
}

const std::vector<std::string>& scene_names()
{
    static const std::vector<std::string> names{"report"};
    return names;
}

}  // namespace kerf::sim
