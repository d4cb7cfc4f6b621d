// What cut.h promises to programs of several threads. The thread sanitizer sees what a run without it would hide.

#include <gtest/gtest.h>

#include <array>
#include <thread>
#include <vector>

#include "common/cut.h"
#include "support/backends.h"
#include "support/fixtures.h"
#include "support/referee.h"

namespace kerf {
namespace {

constexpr std::size_t kThreads = 4;

using Bytes = std::vector<std::vector<std::uint32_t>>;

/// Cuts an object twice, the second time each piece by another plane; the bytes of all that comes out.
Bytes cut_to_bytes(std::unique_ptr<Cuttable> object)
{
    CutOptions options;
    options.split_components = true;
    Bytes bytes;
    CutResult first = cut(std::move(object), *Plane::through({0.05, 0.1, 0.02}, {1, 2, 3}), options);
    for (auto* side : {&first.negative, &first.positive})
        for (auto& fragment : *side) {
            const glm::dvec3 centre = fragment->bounds().centre();
            CutResult second = cut(std::move(fragment), *Plane::through(centre, {3, -1, 1}), options);
            for (auto* half : {&second.negative, &second.positive})
                for (auto& piece : *half) {
                    piece->compact();
                    bytes.push_back(referee::bytes_of(piece->to_indexed_mesh()));
                }
        }
    return bytes;
}

/// Runs `work(thread)` on several threads at once.
template <class Work>
std::array<Bytes, kThreads> on_threads(Work work)
{
    std::array<Bytes, kThreads> results;
    std::vector<std::thread> threads;
    for (std::size_t i = 0; i < kThreads; ++i) threads.emplace_back([&, i] { results[i] = work(i); });
    for (std::thread& thread : threads) thread.join();
    return results;
}

class Threads : public testing::TestWithParam<test::NamedBackend>
{
};

TEST_P(Threads, MayPrepareWithOneBackEndAtOnce)
{
    const auto backend = GetParam().make();
    for (const char* name : {"comb", "spiral_wall", "sphere_in_sphere", "asteroid"}) {
        const IndexedMesh& mesh = test::closed_shape(name);
        const Bytes alone = cut_to_bytes(backend->prepare(mesh).object);
        EXPECT_GT(alone.size(), 1u);
        for (const Bytes& bytes : on_threads([&](std::size_t) { return cut_to_bytes(backend->prepare(mesh).object); }))
            EXPECT_EQ(bytes, alone) << name;
    }
}

TEST_P(Threads, MayCutCopiesOfOneObjectAtOnce)
{
    const auto object = GetParam().make()->prepare(test::closed_shape("torus")).object;
    const Bytes alone = cut_to_bytes(object->clone());
    std::array<std::unique_ptr<Cuttable>, kThreads> copies;
    for (auto& copy : copies) copy = object->clone();
    for (const Bytes& bytes : on_threads([&](std::size_t i) { return cut_to_bytes(std::move(copies[i])); }))
        EXPECT_EQ(bytes, alone);
}

INSTANTIATE_TEST_SUITE_P(BackEnds, Threads, testing::ValuesIn(test::backends()),
                         [](const auto& parameter) { return parameter.param.name; });

}  // namespace
}  // namespace kerf
