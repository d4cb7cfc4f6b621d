#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "viewer/app/frame_statistics.h"
#include "viewer/app/gpu_world.h"
#include "viewer/sim/simulation.h"

namespace kerf::app {

/// Times of a run's frames.
struct FrameTimes
{
    std::vector<double> simulate_cpu_ms;  ///< ticks with their cuts, processor time of this thread; hashes left out
    std::vector<double> submit_cpu_ms;    ///< uploads and the commands of a picture, time of this thread on a processor
    std::vector<double> frame_ms;         ///< the whole frame until the picture is finished, wall clock
};

/// Everything about one run: what it was, the state hash, the cut log, times. Hashes are hexadecimal text.
nlohmann::ordered_json report_of(const sim::Simulation& simulation, const GpuWorld& world, const FrameTimes& times);

/// Milliseconds of one cut from the hit to the last byte uploaded, on this thread's processor time.
double cut_to_upload_ms(const sim::CutRecord& cut, const CutUpload& upload);

}  // namespace kerf::app
