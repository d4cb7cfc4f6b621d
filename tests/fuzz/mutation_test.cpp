// A short run of each fuzzer with any compiler: inputs made of the seeds, the same on every run. `./run fuzz` looks
// further, guided by what inputs reach.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "fuzz/fuzzer.h"
#include "support/brief.h"
#include "support/fixtures.h"

namespace kerf::core::fuzz {
namespace {

namespace fs = std::filesystem;

using Input = std::vector<std::uint8_t>;

std::vector<Input> seeds_of(const Fuzzer& fuzzer)
{
    std::vector<fs::path> paths;
    for (const auto& entry : fs::directory_iterator(fs::path(KERF_FUZZ_SEEDS_DIR) / fuzzer.name))
        paths.push_back(entry.path());
    std::sort(paths.begin(), paths.end());
    std::vector<Input> seeds;
    for (const fs::path& path : paths) {
        std::ifstream in(path, std::ios::binary);
        seeds.emplace_back(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
    }
    return seeds;
}

/// A seed with a few bytes changed, cut out, repeated, or taken from another seed.
Input mutated(const std::vector<Input>& seeds, std::size_t longest, test::Random& random)
{
    const auto any = [&](std::size_t bound) {
        return static_cast<std::ptrdiff_t>(random.below(static_cast<std::uint32_t>(std::max<std::size_t>(bound, 1))));
    };
    Input input = seeds[static_cast<std::size_t>(any(seeds.size()))];
    for (std::uint32_t change = 0, changes = 1 + random.below(4); change < changes && !input.empty(); ++change) {
        const auto at = input.begin() + any(input.size());
        const auto length = std::min<std::ptrdiff_t>(1 + any(16), input.end() - at);
        switch (random.below(5)) {
            case 0:
                *at = static_cast<std::uint8_t>(random.below(256));
                break;
            case 1:
                *at ^= static_cast<std::uint8_t>(1u << random.below(8));
                break;
            case 2:
                input.erase(at, at + length);
                break;
            case 3: {
                const Input some(at, at + length);
                input.insert(input.begin() + any(input.size()), some.begin(), some.end());
                break;
            }
            default: {
                const Input& other = seeds[static_cast<std::size_t>(any(seeds.size()))];
                const auto from = other.begin() + any(other.size());
                input.erase(at, input.end());
                input.insert(input.end(), from, other.end());
            }
        }
    }
    input.resize(std::min(input.size(), longest));
    return input;
}

class FuzzMutations : public testing::TestWithParam<Fuzzer>
{
};

INSTANTIATE_TEST_SUITE_P(All, FuzzMutations, testing::ValuesIn(fuzzers().begin(), fuzzers().end()),
                         [](const auto& fuzzer) { return std::string(fuzzer.param.name); });

TEST_P(FuzzMutations, KeepThePromise)
{
    constexpr int kInputs = test::kBrief ? 500 : 1500;
    const std::vector<Input> seeds = seeds_of(GetParam());
    ASSERT_FALSE(seeds.empty());
    test::Random random(1);
    for (int i = 0; i < kInputs; ++i) {
        SCOPED_TRACE(i);
        GetParam().run(mutated(seeds, GetParam().longest, random));
    }
}

}  // namespace
}  // namespace kerf::core::fuzz
