#pragma once

#include <kerf/status.h>

#include <cstdint>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "viewer/sim/body.h"

namespace kerf::sim {

/// An object that was taken apart: a line of a log, with a member for each thing that is written down.
struct BreakRecord
{
    std::uint64_t number = 0;  ///< counts up from 1
    Tick struck = 0;           ///< when the blow came
    Tick tick = 0;             ///< when its pieces were there
    ObjectId object = 0;
    std::size_t model = 0;
    std::string backend;
    Status status = Status::done;  ///< of fracture(); `missed`: the blow went past the object
    glm::dvec3 place{0.0};         ///< of the blow, world, metres
    glm::dvec3 centre{0.0};        ///< of the object, world
    double radius = 0.0;           ///< of the object, metres
    std::uint64_t triangles = 0;   ///< of the object
    std::vector<ObjectId> pieces;
    std::size_t dropped = 0;   ///< pieces without room
    std::size_t bonds = 0;     ///< contacts between pieces
    double fracture_ms = 0.0;  ///< on the worker: fracture(), wall clock
    double proxy_ms = 0.0;     ///< on the worker: mass and collision proxies of all pieces
    double cpu_ms = 0.0;       ///< of the tick that put the pieces into the world, this thread's processor time
};

/// Bonds that one blow broke.
struct CrackRecord
{
    Tick tick = 0;
    std::size_t model = 0;
    glm::dvec3 place{0.0};  ///< world, metres
    double impulse = 0.0;   ///< N s
    std::size_t bonds = 0;  ///< that broke
    std::size_t parts = 0;  ///< into which the cluster fell; 1: it still hangs together
    double radius = 0.0;    ///< of the cluster, metres
};

}  // namespace kerf::sim
