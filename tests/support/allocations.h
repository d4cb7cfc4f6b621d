#pragma once

#include <cstddef>
#include <cstdint>

// A program that links kerf_test_allocations has every operator new counted, and every realloc() of the code in it
// (shared libraries' own are left alone), and can let chosen ones fail. Not for programs of several threads.

namespace kerf::test {

/// Bytes asked for since the program started, and the largest single request since
/// reset_largest_allocation().
std::size_t allocated_bytes();
/// Calls since the program started; those of realloc() among them.
std::uint64_t allocations();
std::uint64_t reallocations();
std::size_t largest_allocation();
void reset_largest_allocation();

enum class Failure
{
    once,     ///< that allocation and no other: memory was short for a moment
    for_good  ///< that one and all later ones
};

/// While it lives, the allocation of that number from its construction on (0: the next one) fails: operator new throws
/// std::bad_alloc, or gives null where it is asked not to throw, and so does realloc(). One at a time.
class FailingAllocation
{
public:
    explicit FailingAllocation(std::uint64_t number, Failure failure = Failure::once);
    ~FailingAllocation();
    FailingAllocation(const FailingAllocation&) = delete;
    FailingAllocation& operator=(const FailingAllocation&) = delete;

    /// Whether it came to that allocation.
    bool happened() const;
};

}  // namespace kerf::test

namespace kerf::core::test {
using namespace kerf::test;
}
