#pragma once

#include <kerf/cut.h>

// What calls that cut several times share.

namespace kerf {

/// Adds what a further cut has cost; `triangles` stays that of the first.
void add(CutStatistics& sum, const CutStatistics& more);

/// What is wrong with the arguments of a cut, or null.
const char* fault_of_cut(const Object& object, const CutOptions& options);

}  // namespace kerf
