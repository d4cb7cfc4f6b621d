// Every seed keeps its fuzzer's promise, with any compiler. Seeds that were findings are named after their cause.

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "fuzz/fuzzer.h"

namespace kerf::core::fuzz {
namespace {

namespace fs = std::filesystem;

struct Seed
{
    const Fuzzer* fuzzer;
    fs::path path;
};

void PrintTo(const Seed& seed, std::ostream* out)
{
    *out << seed.path;
}

std::vector<Seed> seeds()
{
    std::vector<Seed> all;
    for (const Fuzzer& fuzzer : fuzzers())
        for (const auto& entry : fs::directory_iterator(fs::path(KERF_FUZZ_SEEDS_DIR) / fuzzer.name))
            all.push_back({&fuzzer, entry.path()});
    std::sort(all.begin(), all.end(), [](const Seed& a, const Seed& b) { return a.path < b.path; });
    return all;
}

std::string name_of(const testing::TestParamInfo<Seed>& info)
{
    std::string name = std::string(info.param.fuzzer->name) + "_" + info.param.path.stem().string();
    std::replace_if(
        name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
    return name;
}

class FuzzSeeds : public testing::TestWithParam<Seed>
{
};

INSTANTIATE_TEST_SUITE_P(All, FuzzSeeds, testing::ValuesIn(seeds()), name_of);

TEST_P(FuzzSeeds, KeepTheirPromise)
{
    std::ifstream in(GetParam().path, std::ios::binary);
    const std::vector<char> bytes(std::istreambuf_iterator<char>(in), {});
    GetParam().fuzzer->run({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
}

}  // namespace
}  // namespace kerf::core::fuzz
