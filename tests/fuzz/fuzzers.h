#pragma once

#include "fuzz/fuzzer.h"

// One function a fuzzer, each in a file of its name.

namespace kerf::fuzz {

void fuzz_cap(Bytes bytes);
void fuzz_cut(Bytes bytes);

}  // namespace kerf::fuzz
