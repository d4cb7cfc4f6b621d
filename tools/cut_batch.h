#pragma once

#include <kerf/object.h>

#include <cstdint>
#include <string>
#include <vector>

#include "tools/cut_jobs.h"
#include "tools/cut_output.h"
#include "tools/cut_report.h"

// Many cuts of one mesh, which is read once: `kerf cut --batch`.

namespace kerf::tools {

struct BatchOptions
{
    std::string jobs;     ///< a file of jobs; none: one cut
    std::string results;  ///< a file that gets a line for each job that is done; none: the standard output
    unsigned threads = 1;
};

/// What one cut is made of.
struct CutBatch
{
    const std::vector<CutJob>& jobs;
    const Object& object;
    Box bounds;
    std::uint64_t mesh_key = 0;  ///< differs if the mesh differs
    const FileReport& read;      ///< whose files are not replaced
    const CutReport& report;     ///< what is said of all of them
    CutOutput output;            ///< with the name of the job behind the prefix
};

/// A number that differs if the mesh differs. O(n).
std::uint64_t key_of(const Mesh& mesh);

/// Makes the cuts, and writes a line for each: in the order of the jobs. If the file of results has lines of these jobs, it
/// goes on behind them; an incomplete last line is made anew.
/// @throws std::runtime_error  the results are of other jobs, a file can't be written, or some jobs failed
/// @throws NothingToCut        `must_cut`, and a plane has missed
void run_jobs(const CutBatch& batch, const BatchOptions& options, bool must_cut);

}  // namespace kerf::tools
