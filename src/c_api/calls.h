#pragma once

#include <kerf/c.h>
#include <kerf/kerf.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <new>
#include <optional>
#include <type_traits>

// What every function of kerf/c.h does: take and fill structs that begin with their size, and answer.

namespace kerf::c_api {

constexpr kerf_status to_c(Status status)
{
    return static_cast<kerf_status>(status);
}

/// The caller's room for a sentence, which is empty at first.
class Reason
{
public:
    Reason(char* text, std::size_t size) : text_(size > 0 ? text : nullptr), size_(size) { say(""); }

    void say(const char* sentence) const
    {
        if (text_ == nullptr) return;
        const std::size_t length = std::min(std::strlen(sentence), size_ - 1);
        std::memcpy(text_, sentence, length);
        text_[length] = '\0';
    }
    kerf_status answer(Status status, const char* sentence) const
    {
        say(sentence);
        return to_c(status);
    }
    kerf_status wrong(const char* sentence) const { return answer(Status::invalid_argument, sentence); }

private:
    char* text_;
    std::size_t size_;
};

constexpr const char* kNoMemory = "there is not enough memory";
constexpr const char* kWrongStruct = "a struct is null, or its size is that of no version of it";

/// The size that a struct had when it was new: who was compiled then sets no more.
template <class T>
inline constexpr std::size_t kFirstSize = sizeof(T);

template <class T>
bool has_good_size(const T* given)
{
    std::uint32_t size = 0;
    if (given != nullptr) std::memcpy(&size, given, sizeof size);
    return kFirstSize<T> <= size && size <= sizeof(T);
}

/// A struct of the caller; what an older one lacks is 0. Nothing if it is null or its size can't be right.
template <class T>
std::optional<T> read_struct(const T* given)
{
    static_assert(std::is_trivially_copyable_v<T>);
    if (!has_good_size(given)) return {};
    T read{};
    std::memcpy(&read, given, given->size);
    return read;
}

/// The same; null stands for one that says nothing.
template <class T>
std::optional<T> read_options(const T* given)
{
    return given == nullptr ? T{} : read_struct(given);
}

/// Fills a struct of the caller, of whatever version.
template <class T>
kerf_status fill_struct(T* given, T filled)
{
    if (!has_good_size(given)) return KERF_INVALID_ARGUMENT;
    filled.size = given->size;
    std::memcpy(given, &filled, given->size);
    return KERF_DONE;
}

/// What a call answers that takes memory.
template <class Call>
kerf_status with_memory(const Reason& reason, Call call)
{
    try {
        return call();
    } catch (const std::bad_alloc&) {
        return reason.answer(Status::out_of_memory, kNoMemory);
    }
}

/// A progress function of C, which answers with an int.
struct Listener
{
    int (*progress)(void* user, double share);
    void* user;

    /// Has itself called by what works with these options; it has to live as long.
    template <class Options>
    void listen_to(Options& options)
    {
        if (progress == nullptr) return;
        options.progress = [](void* listener, double share) {
            const auto* const l = static_cast<const Listener*>(listener);
            return l->progress(l->user, share) != 0;
        };
        options.user = this;
    }
};

template <std::size_t N>
Vec3d to_vec3d(const double (&numbers)[N])
{
    static_assert(N == 3);
    return {numbers[0], numbers[1], numbers[2]};
}

template <class T, class V>
void put(T (&numbers)[3], const V& v)
{
    numbers[0] = v.x;
    numbers[1] = v.y;
    numbers[2] = v.z;
}

/// Nothing if it is null, of a wrong size, or no plane.
inline std::optional<Plane> read_plane(const kerf_plane* given)
{
    const std::optional<kerf_plane> p = read_struct(given);
    if (!p) return {};
    return Plane::at(Point(to_vec3d(p->point)), Normal(to_vec3d(p->normal)));
}
constexpr const char* kNoPlane =
    "the plane is null, or its numbers describe none: a normal of length 0, or one that is not finite";

}  // namespace kerf::c_api
