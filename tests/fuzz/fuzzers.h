#pragma once

#include "fuzz/fuzzer.h"

// One function a fuzzer; the files are named like them.

namespace kerf::core::fuzz {

void fuzz_cap(Bytes bytes);
void fuzz_cut(Bytes bytes);
void fuzz_kerf_options(Bytes bytes);
void fuzz_prepare(Bytes bytes);
void fuzz_read_gltf(Bytes bytes);
void fuzz_read_mtl(Bytes bytes);
void fuzz_read_obj(Bytes bytes);
void fuzz_read_off(Bytes bytes);
void fuzz_read_ply(Bytes bytes);
void fuzz_read_stl(Bytes bytes);
void fuzz_repair(Bytes bytes);
void fuzz_script(Bytes bytes);
void fuzz_viewer_options(Bytes bytes);

}  // namespace kerf::core::fuzz
