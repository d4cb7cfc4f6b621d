#pragma once

#include <kerf/status.h>

#include <exception>

#include <pybind11/pybind11.h>

namespace kerf::python {

/// Throws what Python raises for a status: ValueError of what the caller got wrong, MemoryError, kerf.FileError.
[[noreturn]] void raise(Status status, const char* reason);

/// The value of a result; raises without one.
template <class T>
T value_of(Result<T>&& result)
{
    if (!result) raise(result.status(), result.reason());
    return *std::move(result);
}

inline void check(const Outcome& outcome)
{
    if (!outcome) raise(outcome.status(), outcome.reason());
}

/// Lets Ctrl-C stop a call that takes long: what `progress` and `user` of its options are. The call is made without the
/// interpreter's lock; this takes it for a moment, now and then.
class Interruptible
{
public:
    static bool progress(void* user, double share) noexcept;

    /// Raises KeyboardInterrupt, or what else a signal's handler has raised.
    void rethrow() const
    {
        if (raised_) std::rethrow_exception(raised_);
    }

private:
    std::exception_ptr raised_;
};

}  // namespace kerf::python
