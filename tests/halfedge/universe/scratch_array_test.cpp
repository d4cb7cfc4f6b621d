#include "halfedge/universe/scratch_array.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <numeric>

#include "halfedge/universe/ids.h"

namespace kerf::core::halfedge {

namespace {

constexpr std::size_t kFew = 1000, kMany = kHugePage;

std::uintptr_t address_of(const void* place)
{
    return reinterpret_cast<std::uintptr_t>(place);
}

}  // namespace

TEST(ScratchArray, ALargeOneBeginsWithAHugePage)
{
    const ScratchArray<std::uint32_t> large(kMany);
    EXPECT_EQ(address_of(large.data()) % kHugePage, 0u);
}

TEST(ScratchArray, ASmallOneTakesNoHugePageOfItsOwn)
{
    const ScratchArray<std::uint8_t> a(kFew), b(kFew);
    EXPECT_FALSE(address_of(a.data()) % kHugePage == 0 && address_of(b.data()) % kHugePage == 0);
}

TEST(ScratchArray, CanBeFilled)
{
    for (const std::size_t size : {std::size_t(0), kFew, kMany}) {
        const ScratchArray<HalfedgeId> invalid(size, HalfedgeId());
        ASSERT_EQ(invalid.size(), size);
        for (const HalfedgeId h : invalid) ASSERT_FALSE(h.is_valid());
    }
}

TEST(ScratchArray, MovesWithWhatItHolds)
{
    for (const std::size_t size : {kFew, kMany}) {
        ScratchArray<std::uint32_t> numbers(size);
        std::iota(numbers.begin(), numbers.end(), 0u);
        ScratchArray<std::uint32_t> other(std::move(numbers));
        EXPECT_EQ(numbers.size(), 0u);  // NOLINT(bugprone-use-after-move): it is empty, not unknown
        ScratchArray<std::uint32_t> third(kFew + kMany - size, 7u);
        third.swap(other);
        ASSERT_EQ(third.size(), size);
        for (std::uint32_t i = 0; i < size; ++i) ASSERT_EQ(third[i], i);
        ASSERT_EQ(other.size(), kFew + kMany - size);
        for (const std::uint32_t value : other) ASSERT_EQ(value, 7u);
    }
}

TEST(ScratchArray, MoreThanThereAreAddressesIsOutOfMemory)
{
    constexpr std::size_t kTooMany = std::numeric_limits<std::size_t>::max() / sizeof(std::uint64_t);
    EXPECT_THROW(ScratchArray<std::uint64_t>{kTooMany}, std::bad_alloc);
}

}  // namespace kerf::core::halfedge
