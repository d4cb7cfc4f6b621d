#pragma once

#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include "bench/peers/peer_row.h"

namespace kerf::bench {

/// What is the matter with one answer; empty when nothing is.
using Problem = std::string;

/// Asks for every plane of a mesh, or until the budget is spent: `ask(i)` gives seconds and the matter. What took no time
/// because it came to no end counts as a matter, and in no time. The row lacks its names.
template <class Ask>
PeerRow time_planes(std::size_t planes, double budget_seconds, Ask ask)
{
    PeerRow row;
    std::map<Problem, std::size_t> problems;
    double seconds = 0.0;
    std::size_t timed = 0;
    for (std::size_t i = 0; i < planes && (i == 0 || seconds < budget_seconds); ++i) {
        const auto [taken, problem] = ask(i);
        if (taken > 0.0) {
            seconds += taken;
            row.least_ms = timed == 0 ? taken * 1e3 : std::min(row.least_ms, taken * 1e3);
            row.most_ms = std::max(row.most_ms, taken * 1e3);
            ++timed;
        }
        ++row.planes;
        if (problem.empty())
            ++row.right;
        else
            ++problems[problem];
    }
    row.ms = timed == 0 ? 0.0 : seconds * 1e3 / double(timed);
    for (const auto& [problem, count] : problems)
        row.verdict +=
            (row.verdict.empty() ? "" : "; ") + problem + (count == row.planes ? "" : " in " + std::to_string(count));
    if (row.verdict.empty()) row.verdict = "right";
    return row;
}

}  // namespace kerf::bench
