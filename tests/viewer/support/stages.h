#pragma once

#include <memory>
#include <string>
#include <vector>

#include "viewer/sim/model_library.h"
#include "viewer/sim/simulation.h"

namespace kerf::test {

/// A mesh out of a generated shape.
ProvenMesh shape(const std::string& name, std::uint64_t triangles = 1000, std::uint64_t seed = 1);

/// A library with generated shapes of so many triangles.
std::shared_ptr<sim::ModelLibrary> library_of(const std::vector<std::string>& shapes, std::uint64_t triangles = 1000);

/// The report's fifteen models.
std::shared_ptr<sim::ModelLibrary> report_library();

/// A straight stroke at constant speed: press, a sample every `step`, release.
std::vector<sim::InputEvent> stroke(sim::Microseconds start, sim::Microseconds duration, const glm::dvec2& from,
                                    const glm::dvec2& to, sim::Microseconds step = 4000);

}  // namespace kerf::test
