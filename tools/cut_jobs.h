#pragma once

#include <string>
#include <vector>

#include "tools/cut_settings.h"

namespace kerf::tools {

/// A line of a file of jobs: one cut of the mesh.
struct CutJob
{
    std::string name;  ///< in the names of its files; by default its number, with as many digits as the last one has
    CutSettings cut;
};

/// Reads a file of jobs, a JSON object a line; "-" is the standard input. Empty lines are left out. What a line does not
/// say is as in `defaults`.
/// @throws std::runtime_error  names the line and the fault
std::vector<CutJob> read_jobs(const std::string& path, const CutSettings& defaults);

}  // namespace kerf::tools
