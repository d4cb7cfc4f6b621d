#pragma once

#include <kerf/cut.h>

#include <string>
#include <vector>

#include "viewer/sim/body.h"

namespace kerf::sim {

/// A piece that a cut made.
struct PieceRecord
{
    ObjectId id = 0;
    bool positive = false;
    double mass = 0.0;  ///< kg
    std::uint64_t triangles = 0;
    std::uint64_t surface_hash = 0;  ///< surface_hash() when the simulation hashes surfaces, otherwise 0
};

/// One attempt to cut one object: everything the panel, the log and the games want to know. It is a line of a log, and
/// has a member for each thing that is written down.
struct CutRecord
{
    std::uint64_t number = 0;  ///< counts up from 1
    Tick tick = 0;
    ObjectId object = 0;
    std::size_t model = 0;
    std::uint32_t swipe = 0;
    std::string backend;
    Status status = Status::missed;
    CutStatistics statistics;  ///< `crossing_surface` is the k that back ends agree on
    std::vector<PieceRecord> pieces;
    std::size_t dropped = 0;         ///< pieces without room (kMostBodies, kMostNeighbours)
    std::size_t crowded = 0;         ///< of those, the ones where kMostNeighbours are; the others are the smallest
    std::uint64_t surface_hash = 0;  ///< over all pieces, by side; 0 when not asked for
    /// Bodies had touched in this run before the cut: from then on back ends part in the last digit, and then in all.
    bool contact_before = false;
    double section_area = 0.0;  ///< Cut::section_area, mesh units squared
    /// Whether the object's section was closed by what covers it and no more (cap_area.h), and whether that is so for
    /// all sections that the object itself descends from. Back ends agree on cuts of objects whose sections were.
    /// True when not asked for.
    bool closed_rightly = true, origin_closed_rightly = true;
    glm::dvec3 normal{0.0};  ///< of the plane, world axes, towards the positive side
    glm::dvec3 centre{0.0};  ///< of the object when it was cut, world, metres

    double cut_ms = 0.0;        ///< cut() as a whole, wall clock
    double proxy_ms = 0.0;      ///< collision proxies of all pieces
    double bodies_ms = 0.0;     ///< mass properties, Bullet's shapes and bodies, momentum
    double cpu_ms = 0.0;        ///< from the hit to the last body, time of this thread on a processor; hashes left out
    double check_cpu_ms = 0.0;  ///< for hashes and the measuring of caps, likewise; 0 when not asked for

    std::int64_t frame() const { return tick / kTicksPerFrame; }
};

}  // namespace kerf::sim
