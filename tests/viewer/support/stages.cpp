#include "viewer/support/stages.h"

#include <glm/common.hpp>
#include <stdexcept>

#include "common/repair/repair.h"
#include "common/shapes/shapes.h"

namespace kerf::test {

ProvenMesh shape(const std::string& name, std::uint64_t triangles, std::uint64_t seed)
{
    Repaired repaired = repair(shapes::make(name, triangles, seed).value());
    if (!repaired.error.empty()) throw std::runtime_error(repaired.error);
    return std::move(repaired.mesh);
}

std::shared_ptr<sim::ModelLibrary> library_of(const std::vector<std::string>& shapes, std::uint64_t triangles)
{
    auto library = std::make_shared<sim::ModelLibrary>();
    for (const std::string& name : shapes) library->add(name, shape(name, triangles));
    return library;
}

std::shared_ptr<sim::ModelLibrary> report_library()
{
    auto library = std::make_shared<sim::ModelLibrary>();
    library->add_report_models(KERF_DATA_DIR "/models");
    return library;
}

std::vector<sim::InputEvent> stroke(sim::Microseconds start, sim::Microseconds duration, const glm::dvec2& from,
                                    const glm::dvec2& to, sim::Microseconds step)
{
    std::vector<sim::InputEvent> events{{start, sim::InputKind::press, from, {}}};
    for (sim::Microseconds t = step; t < duration; t += step)
        events.push_back({start + t, sim::InputKind::move, glm::mix(from, to, double(t) / double(duration)), {}});
    events.push_back({start + duration, sim::InputKind::release, to, {}});
    return events;
}

}  // namespace kerf::test
