#include "back_ends/back_ends.h"

#include <atomic>
#include <deque>
#include <mutex>
#include <utility>

#include "linear/linear.h"

namespace kerf::core {

namespace {

using List = std::vector<const RegisteredBackend*>;

/// Entries stay where they are. Who adds one makes a new list; who reads has the newest and needs no lock, so lists stay
/// as long as the program, too: there are few.
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
        const std::lock_guard lock(adding_);
        for (const RegisteredBackend* const other : entries())
            if (other->name == entry.name) return;
        entry.back_end = entry.make();
        const bool is_first = entry.is_for_many_cuts;
        List& list = lists_.emplace_back(entries());
        list.insert(is_first ? list.begin() : list.end(), &entries_.emplace_back(std::move(entry)));
        newest_.store(&list, std::memory_order_release);
    }

    List all() const
    {
        List there;
        for (const RegisteredBackend* const entry : entries())
            if (is_there(*entry)) there.push_back(entry);
        return there;
    }

    const RegisteredBackend* find(std::string_view name) const
    {
        if (const RegisteredBackend* const entry = with_name(name)) return entry;
        return first_that([&](std::string_view own) {
            return !name.empty() && own.size() > name.size() && own.substr(0, name.size()) == name &&
                   own[name.size()] == '/';
        });
    }

private:
    Registry() : lists_(1), newest_(&lists_.front())
    {
        add({.name = "linear", .make = [] { return linear::make_back_end(); }});
    }

    /// Whether the program has what it needs. Components come in any order while it starts, so nobody asks before.
    static bool is_there(const RegisteredBackend& entry)
    {
        return !entry.needs_cgal || can_close(CapQuality::delaunay);
    }

    const List& entries() const { return *newest_.load(std::memory_order_acquire); }

    template <class Is>
    const RegisteredBackend* first_that(Is is) const
    {
        for (const RegisteredBackend* const entry : entries())
            if (is_there(*entry) && is(entry->name)) return entry;
        return nullptr;
    }

    const RegisteredBackend* with_name(std::string_view name) const
    {
        return first_that([&](std::string_view own) { return own == name; });
    }

    std::mutex adding_;
    std::deque<RegisteredBackend> entries_;
    std::deque<List> lists_;
    std::atomic<const List*> newest_;
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

}  // namespace kerf::core
