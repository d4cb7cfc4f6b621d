#include "halfedge/universe/append_buffer.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <numeric>
#include <span>
#include <vector>

#include "support/allocations.h"

namespace kerf::core::halfedge {
namespace {

using Numbers = AppendBuffer<std::uint32_t>;

Numbers numbers(std::uint32_t count)
{
    Numbers buffer;
    buffer.reserve(count);
    for (std::uint32_t i = 0; i < count; ++i) buffer.push(i);
    return buffer;
}

std::vector<std::uint32_t> contents(const Numbers& buffer)
{
    return {buffer.begin(), buffer.end()};
}

std::vector<std::uint32_t> first_numbers(std::uint32_t count)
{
    std::vector<std::uint32_t> expected(count);
    std::iota(expected.begin(), expected.end(), 0u);
    return expected;
}

TEST(AppendBuffer, IsEmptyAtFirst)
{
    const Numbers buffer;
    EXPECT_TRUE(buffer.empty());
    EXPECT_EQ(buffer.size(), 0u);
    EXPECT_EQ(buffer.bytes_reserved(), 0u);
    EXPECT_EQ(buffer.begin(), buffer.end());
}

TEST(AppendBuffer, ReservesWhatIsAskedForAndNoMore)
{
    Numbers buffer;
    buffer.reserve(1000);
    EXPECT_EQ(buffer.capacity(), 1000u);
    EXPECT_EQ(buffer.size(), 0u);
    buffer.reserve(10);
    EXPECT_EQ(buffer.capacity(), 1000u);
    EXPECT_EQ(buffer.bytes_reserved(), 4000u);
}

TEST(AppendBuffer, KeepsItsElementsWhenItGrows)
{
    // Beyond the room that is asked for in advance, again and again: the block moves.
    Numbers buffer = numbers(3);
    for (std::uint32_t i = 3; i < 5000; ++i) {
        buffer.make_room(1);
        buffer.push(i);
        ASSERT_LE(buffer.size(), buffer.capacity());
    }
    EXPECT_EQ(contents(buffer), first_numbers(5000));
}

TEST(AppendBuffer, SaysByHowManyBytesItGrew)
{
    Numbers buffer = numbers(10);
    buffer.reserve(16);
    EXPECT_EQ(buffer.make_room(6), 0u);
    EXPECT_EQ(buffer.make_room(7), 1 * sizeof(std::uint32_t));
    EXPECT_EQ(buffer.capacity(), 17u);
    EXPECT_EQ(buffer.make_room(100), 93 * sizeof(std::uint32_t));
    EXPECT_EQ(buffer.capacity(), 110u);
}

TEST(AppendBuffer, WhatIsWrittenBehindTheEndBecomesPartOfIt)
{
    Numbers buffer = numbers(4);
    buffer.make_room(2);
    buffer.data()[4] = 4;
    buffer.data()[5] = 5;
    EXPECT_EQ(buffer.size(), 4u);
    buffer.extend(2);
    EXPECT_EQ(contents(buffer), first_numbers(6));
}

TEST(AppendBuffer, ASmallerSizeKeepsTheRoom)
{
    Numbers buffer = numbers(8);
    buffer.set_size(3);
    EXPECT_EQ(contents(buffer), first_numbers(3));
    EXPECT_EQ(buffer.capacity(), 8u);
    buffer.set_size(8);
    EXPECT_EQ(contents(buffer), first_numbers(8));
}

TEST(AppendBuffer, ACopyIsIndependentAndHasTheSameRoom)
{
    Numbers original = numbers(5);
    original.reserve(20);
    Numbers copy = original;
    copy[0] = 77;
    copy.push(78);
    EXPECT_EQ(contents(original), first_numbers(5));
    EXPECT_EQ(copy.capacity(), 20u);
    EXPECT_EQ(copy.size(), 6u);
}

TEST(AppendBuffer, ACopyOfAnEmptyOneIsEmpty)
{
    const Numbers empty;
    const Numbers copy = empty;  // NOLINT(performance-unnecessary-copy-initialization): that is what is tested
    EXPECT_TRUE(copy.empty());
}

TEST(AppendBuffer, MovingTakesTheMemoryAndLeavesNothing)
{
    Numbers original = numbers(5);
    const std::uint32_t* const data = original.data();
    Numbers moved = std::move(original);
    EXPECT_EQ(moved.data(), data);
    EXPECT_EQ(original.size(), 0u);  // NOLINT(bugprone-use-after-move): what is left is part of the promise
    EXPECT_EQ(original.bytes_reserved(), 0u);

    Numbers assigned = numbers(2);
    assigned = std::move(moved);
    EXPECT_EQ(contents(assigned), first_numbers(5));
}

TEST(AppendBuffer, ALargeOneGrowsWhereItStands)
{
    rlimit limit{};
    if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur != RLIM_INFINITY) GTEST_SKIP() << "addresses are short";
    constexpr std::uint32_t kMany = 1 << 22;  // 16 MB: more than the least that is mapped
    Numbers buffer = numbers(kMany);
    const std::uint32_t* const first = buffer.data();
    buffer.reserve(std::size_t{4} * kMany);
    EXPECT_EQ(buffer.data(), first);
    EXPECT_EQ(buffer[kMany - 1], kMany - 1);
}

TEST(AppendBuffer, WhoReadsASmallOneGoesOnWhenItMoves)
{
    Numbers buffer = numbers(1000);
    const std::span<const std::uint32_t> read(buffer.data(), buffer.size());
    buffer.reserve(100'000);
    ASSERT_NE(buffer.data(), read.data());
    buffer[0] = 77;
    EXPECT_TRUE(std::ranges::equal(read, first_numbers(1000)));
}

TEST(AppendBuffer, IsUnchangedWhenThereIsNoMemory)
{
    Numbers buffer = numbers(5);
    {
        const test::FailingAllocation none(0, test::Failure::for_good);
        EXPECT_THROW(buffer.reserve(100), std::bad_alloc);
        EXPECT_TRUE(none.happened());
    }
    // More bytes than a number of them can say.
    EXPECT_THROW(buffer.reserve(std::numeric_limits<std::size_t>::max() / 4), std::bad_alloc);
    EXPECT_EQ(contents(buffer), first_numbers(5));
    EXPECT_EQ(buffer.capacity(), 5u);
    buffer.make_room(1);
    buffer.push(5);
    EXPECT_EQ(contents(buffer), first_numbers(6));
}

TEST(AppendBuffer, DoesWithoutRoomInAdvanceIfThatIsNotThere)
{
    Numbers buffer = numbers(5);
    const test::FailingAllocation first(0, test::Failure::once);
    buffer.reserve(100);
    EXPECT_TRUE(first.happened());
    EXPECT_EQ(buffer.capacity(), 100u);
    EXPECT_EQ(contents(buffer), first_numbers(5));
}

}  // namespace
}  // namespace kerf::core::halfedge
