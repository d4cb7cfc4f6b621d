#pragma once

#include <stdexcept>
#include <string>

namespace kerf::core::fuzz {

/// What a fuzzer has found: a sentence that should be true and is not. libFuzzer takes the uncaught exception for a
/// crash and keeps the input; a replay reports it as a failed test.
class BrokenPromise : public std::logic_error
{
public:
    using std::logic_error::logic_error;
};

inline void require(bool condition, const std::string& promise)
{
    if (!condition) throw BrokenPromise("broken promise: " + promise);
}

}  // namespace kerf::core::fuzz
