#pragma once

#include <string>

namespace kerf::sim {

/// Cuts something small with a back end, once in a process: the first cut brings code and scratch memory in, which
/// takes longer than a later cut as a whole. An object of that back end must be there and stay, because scratch memory goes
/// with the last one. Any thread may call it; it is meant for those that prepare.
void rehearse(const std::string& back_end);

}  // namespace kerf::sim
