#include "back_ends/back_ends.h"

#include <algorithm>
#include <deque>
#include <mutex>
#include <utility>

#include "linear/linear.h"

namespace kerf::core {

namespace {

/// Entries stay where they are.
class Registry
{
public:
    static Registry& the()
    {
        static Registry registry;
        return registry;
    }

    void add(RegisteredBackend&& entry)
    {
        const std::lock_guard lock(mutex_);
        if (with_name(entry.name) != nullptr) return;
        if (entry.is_for_many_cuts)
            entries_.push_front(std::move(entry));
        else
            entries_.push_back(std::move(entry));
    }

    std::vector<const RegisteredBackend*> all()
    {
        const std::lock_guard lock(mutex_);
        std::vector<const RegisteredBackend*> pointers;
        for (const RegisteredBackend& entry : entries_) pointers.push_back(&entry);
        return pointers;
    }

    const RegisteredBackend* find(std::string_view name)
    {
        const std::lock_guard lock(mutex_);
        if (const RegisteredBackend* const entry = with_name(name)) return entry;
        return first_that([&](std::string_view own) {
            return !name.empty() && own.size() > name.size() && own.substr(0, name.size()) == name &&
                   own[name.size()] == '/';
        });
    }

private:
    Registry()
    {
        entries_.push_back({"linear", false, false, [] { return linear::make_back_end(); }});
    }

    template <class Is>
    const RegisteredBackend* first_that(Is is) const
    {
        const auto found = std::find_if(entries_.begin(), entries_.end(),
                                        [&](const RegisteredBackend& entry) { return is(entry.name); });
        return found == entries_.end() ? nullptr : &*found;
    }

    const RegisteredBackend* with_name(std::string_view name) const
    {
        return first_that([&](std::string_view own) { return own == name; });
    }

    std::mutex mutex_;
    std::deque<RegisteredBackend> entries_;
};

}  // namespace

std::vector<const RegisteredBackend*> back_ends()
{
    return Registry::the().all();
}

void add_back_end(RegisteredBackend entry)
{
    Registry::the().add(std::move(entry));
}

const RegisteredBackend* find_back_end(std::string_view name)
{
    return Registry::the().find(name);
}

std::unique_ptr<Backend> make_back_end(std::string_view name)
{
    const RegisteredBackend* const entry = find_back_end(name);
    return entry == nullptr ? nullptr : entry->make();
}

}  // namespace kerf::core
