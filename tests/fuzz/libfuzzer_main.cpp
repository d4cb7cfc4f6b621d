// The fuzzers under libFuzzer: `kerf_fuzz --fuzzer=NAME [libFuzzer's own arguments]`.

#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "fuzz/fuzzer.h"

namespace {

const kerf::core::fuzz::Fuzzer* chosen = nullptr;

}  // namespace

extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv)
{
    // libFuzzer leaves arguments alone that begin with two dashes, and hands them on to its own child processes.
    constexpr std::string_view kOption = "--fuzzer=";
    for (int i = 1; i < *argc; ++i) {
        const std::string_view argument = (*argv)[i];
        if (argument.starts_with(kOption)) chosen = kerf::core::fuzz::find_fuzzer(argument.substr(kOption.size()));
        if (argument == "--list") {
            for (const kerf::core::fuzz::Fuzzer& fuzzer : kerf::core::fuzz::fuzzers())
                std::printf("%.*s %zu\n", static_cast<int>(fuzzer.name.size()), fuzzer.name.data(), fuzzer.longest);
            std::exit(0);
        }
    }
    if (chosen == nullptr) {
        std::fputs("kerf_fuzz: choose a fuzzer with --fuzzer=NAME; --list names them\n", stderr);
        std::exit(2);
    }
    return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    chosen->run({data, size});
    return 0;
}
