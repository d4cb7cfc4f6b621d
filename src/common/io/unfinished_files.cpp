#include "common/io/unfinished_files.h"

#include <unistd.h>

#include <array>
#include <atomic>
#include <climits>
#include <cstring>

namespace kerf::io {

namespace {

enum : int
{
    kFree,
    kChanging,
    kSet
};

/// A signal handler may neither allocate nor wait: places and paths are of fixed size.
struct Place
{
    std::atomic<int> state{kFree};
    std::array<char, PATH_MAX> path{};
};
std::array<Place, 32> places;  // as many files as one program writes at a time, and more
static_assert(std::atomic<int>::is_always_lock_free);

}  // namespace

int remember_unfinished(const std::filesystem::path& path) noexcept
{
    const std::string& name = path.native();
    if (name.size() >= PATH_MAX) return -1;
    for (std::size_t i = 0; i < places.size(); ++i) {
        int expected = kFree;
        if (!places[i].state.compare_exchange_strong(expected, kChanging)) continue;
        std::memcpy(places[i].path.data(), name.c_str(), name.size() + 1);
        places[i].state.store(kSet);
        return static_cast<int>(i);
    }
    return -1;
}

void forget_unfinished(int number) noexcept
{
    if (number >= 0) places[static_cast<std::size_t>(number)].state.store(kFree);
}

void remove_unfinished_files() noexcept
{
    for (Place& place : places)
        if (place.state.load() == kSet) ::unlink(place.path.data());
}

}  // namespace kerf::io
