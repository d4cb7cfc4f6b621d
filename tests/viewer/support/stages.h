#pragma once

#include <gtest/gtest.h>
#include <kerf/object.h>

#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "viewer/sim/model_library.h"
#include "viewer/sim/simulation.h"

namespace kerf::test {

/// What a call of the library gives. @throws std::runtime_error  it gives none
template <class T>
T value_of(Result<T> result)
{
    if (!result) throw std::runtime_error(result.reason());
    return *std::move(result);
}

/// A mesh out of a generated shape.
Mesh shape(const std::string& name, std::uint64_t triangles = 1000, std::uint64_t seed = 1);

/// The arrays of a mesh, to be changed and made into another one; without materials. They live as long as the mesh.
MeshInput input_of(const Mesh& mesh);

/// A mesh, ready to be cut.
Object object_of(const Mesh& mesh, const std::string& backend = "baseline/remap");

/// What there is to draw of an object.
DrawView view_of(const Object& object);

/// Through a point, with the positive side where the normal points to.
Plane plane_through(const glm::dvec3& point, const glm::dvec3& normal);

/// A library with generated shapes of so many triangles.
std::shared_ptr<sim::ModelLibrary> library_of(const std::vector<std::string>& shapes, std::uint64_t triangles = 1000);

/// The report's fifteen models.
std::shared_ptr<sim::ModelLibrary> report_library();

/// Of a test for each back end: its name as GoogleTest takes it.
std::string back_end_test_name(const testing::TestParamInfo<std::string>& backend);

/// A straight stroke at constant speed: press, a sample every `step`, release.
std::vector<sim::InputEvent> stroke(sim::Microseconds start, sim::Microseconds duration, const glm::dvec2& from,
                                    const glm::dvec2& to, sim::Microseconds step = 4000);

}  // namespace kerf::test
