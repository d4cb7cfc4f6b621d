#pragma once

#include <kerf/status.h>

#include <new>
#include <stdexcept>

// Where memory runs out: the library's own code throws, the public interface answers.

namespace kerf {

/// Calls `call`. If memory runs out, or a container is asked for more elements than its type can count, the answer is
/// `otherwise`.
template <class Call, class Answer>
Answer answer_or(Answer otherwise, Call&& call) noexcept
{
    try {
        return call();
    } catch (const std::bad_alloc&) {
    } catch (const std::length_error&) {
    }
    return otherwise;
}

/// The same for a Result.
template <class T, class Call>
Result<T> result_of(const char* no_memory, Call&& call) noexcept
{
    try {
        return call();
    } catch (const std::bad_alloc&) {
    } catch (const std::length_error&) {
    }
    return {Status::out_of_memory, Sentence(no_memory)};
}

}  // namespace kerf
