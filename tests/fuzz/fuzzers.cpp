#include "fuzz/fuzzers.h"

#include <algorithm>
#include <array>

namespace kerf::core::fuzz {

std::span<const Fuzzer> fuzzers()
{
    static constexpr auto kAll = std::to_array<Fuzzer>({
        {"cap", fuzz_cap, 1024},
        {"cut", fuzz_cut, 512},
#ifdef KERF_HAS_TOOLS
        {"kerf_options", fuzz_kerf_options, 512},
#endif
        {"prepare", fuzz_prepare, 1024},
        {"read_gltf", fuzz_read_gltf, 4096},
        {"read_mtl", fuzz_read_mtl, 1024},
        {"read_obj", fuzz_read_obj, 2048},
        {"read_off", fuzz_read_off, 2048},
        {"read_ply", fuzz_read_ply, 2048},
        {"read_stl", fuzz_read_stl, 2048},
        {"repair", fuzz_repair, 512},
#ifdef KERF_HAS_VIEWER
        {"script", fuzz_script, 1024},
#endif
#ifdef KERF_HAS_VIEWER_PROGRAM
        {"viewer_options", fuzz_viewer_options, 512},
#endif
    });
    return kAll;
}

const Fuzzer* find_fuzzer(std::string_view name)
{
    const auto all = fuzzers();
    const auto found = std::find_if(all.begin(), all.end(), [&](const Fuzzer& f) { return f.name == name; });
    return found != all.end() ? &*found : nullptr;
}

}  // namespace kerf::core::fuzz
