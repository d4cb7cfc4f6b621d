#pragma once

#include <kerf/object.h>

#include <memory>
#include <mutex>
#include <shared_mutex>
#include <utility>

#include <pybind11/pybind11.h>

namespace kerf::python {

/// An object as Python has it: several threads may have names of it. What changes it takes turns with what reads it. Once
/// it was cut it is empty, and its use raises ValueError.
///
/// The lock is taken without the interpreter's; otherwise a thread that has the one could wait for the other for ever.
class SharedObject
{
public:
    explicit SharedObject(Object object) noexcept : object_(std::move(object)) {}

    /// What `use` makes of the object, which stays as it is. Without the interpreter's lock.
    template <class Use>
    auto read(Use use) const
    {
        const pybind11::gil_scoped_release unlocked;
        const std::shared_lock lock(mutex_);
        refuse_if_gone();
        return use(object_);
    }

    /// The same of what changes it.
    template <class Use>
    auto change(Use use)
    {
        const pybind11::gil_scoped_release unlocked;
        const std::unique_lock lock(mutex_);
        refuse_if_gone();
        return use(object_);
    }

    bool is_gone() const
    {
        const pybind11::gil_scoped_release unlocked;
        const std::shared_lock lock(mutex_);
        return object_.is_empty();
    }

private:
    void refuse_if_gone() const
    {
        if (object_.is_empty())
            throw pybind11::value_error(
                "the object was cut, and its pieces took its place: cut object.copy() to keep it");
    }

    mutable std::shared_mutex mutex_;
    Object object_;
};

/// Ends without the interpreter's lock: it may wait until a relative is cut.
inline std::shared_ptr<SharedObject> share(Object object)
{
    return {new SharedObject(std::move(object)), [](SharedObject* shared) {
                const pybind11::gil_scoped_release unlocked;
                delete shared;
            }};
}

}  // namespace kerf::python
