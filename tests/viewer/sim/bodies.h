#pragma once

#include "viewer/sim/back_ends.h"
#include "viewer/sim/body.h"
#include "viewer/sim/stages.h"

namespace kerf::test {

/// A body out of a mesh, one metre a unit, with its box's centre at `centre`.
inline std::unique_ptr<sim::Body> body_of(IndexedMesh mesh, sim::ObjectId id, const glm::dvec3& centre,
                                          const sim::Motion& motion = {}, ProxyKind proxy = ProxyKind::full_hull,
                                          const std::string& backend = "baseline/remap")
{
    std::unique_ptr<Cuttable> object = std::move(sim::make_backend(backend)->prepare(mesh).object);
    sim::Identity identity;
    identity.id = id;
    identity.origin.backend = backend;
    identity.origin.centre = mesh.bounds().centre();
    sim::MeshPose pose;
    pose.translation = centre - mesh.bounds().centre();
    const sim::Solid solid = sim::solid_of(object->mass_properties(), object->bounds(), 1.0);
    return std::make_unique<sim::Body>(std::move(identity), std::move(object), solid, pose, motion, proxy);
}

}  // namespace kerf::test
