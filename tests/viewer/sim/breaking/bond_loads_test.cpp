#include "viewer/sim/breaking/bond_loads.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "common/support/random.h"

namespace kerf::sim {
namespace {

/// Pieces anywhere in a ball of a metre, with bonds between some of them.
struct Heap
{
    std::vector<LoadedPart> parts;
    std::vector<LoadedBond> bonds;
};

Heap heap_of(std::uint64_t seed, std::uint32_t count)
{
    core::Random random(seed);
    Heap heap;
    for (std::uint32_t i = 0; i < count; ++i)
        heap.parts.push_back({0.1 + random.unit(), {random.unit(), random.unit(), random.unit()}});
    for (std::uint32_t i = 1; i < count; ++i) heap.bonds.push_back({random.below(i), i, 0.1 + random.unit()});
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::uint32_t a = random.below(count), b = random.below(count);
        if (a != b) heap.bonds.push_back({std::min(a, b), std::max(a, b), 0.1 + random.unit()});
    }
    return heap;
}

std::ptrdiff_t count_of(const std::vector<bool>& broken)
{
    return std::count(broken.begin(), broken.end(), true);
}

/// Three in a row, a metre apart, a kilogram each; each bond holds 1 N s.
const Heap kRow{{{1.0, {0, 0, 0}}, {1.0, {1, 0, 0}}, {1.0, {2, 0, 0}}}, {{0, 1, 1.0}, {1, 2, 1.0}}};

}  // namespace

TEST(BondLoads, ABlowBreaksTheBondThatPassesOnMoreThanItHolds)
{
    // The end keeps a third of the impulse and passes two on; the middle passes on one.
    const auto broken = [](double impulse) { return broken_bonds(kRow.parts, kRow.bonds, {-0.1, 0, 0}, impulse); };
    EXPECT_EQ(broken(1.4), (std::vector<bool>{false, false}));
    EXPECT_EQ(broken(1.6), (std::vector<bool>{true, false}));
    EXPECT_EQ(broken(2.9), (std::vector<bool>{true, false}));
    EXPECT_EQ(broken(3.1), (std::vector<bool>{true, true}));
}

TEST(BondLoads, ABlowAtTheOtherEndBreaksTheOtherBond)
{
    EXPECT_EQ(broken_bonds(kRow.parts, kRow.bonds, {2.1, 0, 0}, 2.0), (std::vector<bool>{false, true}));
}

RC_GTEST_PROP(BondLoads, NoBlowBreaksNothing, ())
{
    const Heap heap = heap_of(*rc::gen::arbitrary<std::uint64_t>(), *rc::gen::inRange<std::uint32_t>(2, 60));
    RC_ASSERT(count_of(broken_bonds(heap.parts, heap.bonds, {0, 0, 0}, 0.0)) == 0);
}

RC_GTEST_PROP(BondLoads, AStrongerBlowBreaksWhatAWeakerOneDoesAndMore, ())
{
    const Heap heap = heap_of(*rc::gen::arbitrary<std::uint64_t>(), *rc::gen::inRange<std::uint32_t>(2, 60));
    const double weak = 0.01 * *rc::gen::inRange(0, 2000), strong = weak + 0.01 * *rc::gen::inRange(0, 2000);
    const auto few = broken_bonds(heap.parts, heap.bonds, {0.2, 0.4, 0.9}, weak);
    const auto many = broken_bonds(heap.parts, heap.bonds, {0.2, 0.4, 0.9}, strong);
    for (std::size_t i = 0; i < few.size(); ++i) RC_ASSERT(!few[i] || many[i]);
}

RC_GTEST_PROP(BondLoads, AStrongEnoughBlowLeavesNoBond, ())
{
    const Heap heap = heap_of(*rc::gen::arbitrary<std::uint64_t>(), *rc::gen::inRange<std::uint32_t>(2, 60));
    const auto broken = broken_bonds(heap.parts, heap.bonds, {0.5, 0.5, 0.5}, 1e9);
    RC_ASSERT(std::size_t(count_of(broken)) == heap.bonds.size());
}

RC_GTEST_PROP(BondLoads, AgreesWithTheSumOverEachDistance, ())
{
    const Heap heap = heap_of(*rc::gen::arbitrary<std::uint64_t>(), *rc::gen::inRange<std::uint32_t>(2, 40));
    const glm::dvec3 place(0.2, 0.4, 0.9);
    const double impulse = 0.01 * *rc::gen::inRange(0, 3000);
    const auto distance = [&](std::uint32_t part) { return glm::distance(heap.parts[part].centre, place); };
    double whole = 0.0;
    for (const LoadedPart& part : heap.parts) whole += part.mass;
    // Each part's distance in turn: who is nearer, and what crosses it.
    std::vector<bool> expected(heap.bonds.size(), false);
    for (std::uint32_t limit = 0; limit < heap.parts.size(); ++limit) {
        const auto is_near = [&](std::uint32_t part) { return distance(part) <= distance(limit); };
        double near = 0.0, holds = 0.0;
        for (std::uint32_t i = 0; i < heap.parts.size(); ++i)
            if (is_near(i)) near += heap.parts[i].mass;
        std::vector<std::size_t> crossing;
        for (std::size_t b = 0; b < heap.bonds.size(); ++b) {
            if (is_near(heap.bonds[b].first) == is_near(heap.bonds[b].second)) continue;
            crossing.push_back(b);
            holds += heap.bonds[b].strength;
        }
        if (crossing.empty()) continue;
        const double passed = impulse * (1.0 - near / whole);
        RC_PRE(std::abs(passed - holds) > 1e-9);  // no matter of rounding
        if (passed > holds)
            for (const std::size_t b : crossing) expected[b] = true;
    }
    RC_ASSERT(broken_bonds(heap.parts, heap.bonds, place, impulse) == expected);
}

}  // namespace kerf::sim
