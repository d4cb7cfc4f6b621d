#pragma once

#include <kerf/export.h>

#include <utility>

namespace kerf {

/// @addtogroup answers
/// A status, and a sentence for people. The library throws nothing but what a comment names, and a bad mesh, plane or
/// file never ends a program.
/// @{

/// What became of a call. Numbers never change; new ones are added at the end.
enum class Status : unsigned char
{
    done = 0,              ///< it did what was asked for
    missed = 1,            ///< of a cut: the plane does not go through the object, which comes back as it was
    open_section = 2,      ///< of a cut: done, but the mesh has holes where it was cut, and these stay open
    invalid_argument = 3,  ///< an argument says something that can't be; nothing was done
    invalid_mesh = 4,      ///< what was given is no mesh that can be cut; nothing was done
    out_of_memory = 5,     ///< nothing was done, and every object is as it was
    cancelled = 6,         ///< the caller asked to stop; nothing was done
    unusable_file = 7,     ///< a file that can't be read or written; nothing was done
    not_separated = 8,     ///< of a cut: what was chosen to be cut does not part the object; nothing was done
};

/// Whether the call did what was asked for: `done` or `open_section`.
constexpr bool ok(Status status) noexcept
{
    return status == Status::done || status == Status::open_section;
}

/// "done", "missed", ...; "unknown" for a number that is none of them. Never null.
KERF_API const char* text(Status status) noexcept;

/// A sentence for people, or nothing. Owns its text.
class KERF_API Sentence
{
public:
    Sentence() noexcept = default;
    /// Copies the text; if there is no memory for it, a short sentence that says so takes its place.
    explicit Sentence(const char* text) noexcept;
    /// What is moved from is empty, or has the other's text.
    /// @{
    Sentence(Sentence&& other) noexcept : text_(std::exchange(other.text_, nullptr)) {}
    Sentence& operator=(Sentence&& other) noexcept
    {
        std::swap(text_, other.text_);
        return *this;
    }
    /// @}
    Sentence(const Sentence&) = delete;
    Sentence& operator=(const Sentence&) = delete;
    ~Sentence();

    /// Never null; "" if there is nothing to say.
    const char* c_str() const noexcept { return text_ != nullptr ? text_ : ""; }
    /// Whether there is nothing to say.
    bool is_empty() const noexcept { return *c_str() == '\0'; }

private:
    char* text_ = nullptr;
};

/// A value, or the reason why there is none.
///
///     kerf::Result<kerf::Mesh> mesh = kerf::Mesh::make(input);
///     if (!mesh) return complain(mesh.reason());
///     use(*mesh);
template <class T>
class [[nodiscard]] Result
{
public:
    /// A value.
    Result(T value) noexcept : status_(Status::done), value_(std::move(value)) {}
    /// None, and why.
    Result(Status status, Sentence reason) noexcept : status_(status), reason_(std::move(reason)) {}

    /// `done` if there is a value.
    Status status() const noexcept { return status_; }
    /// One sentence that names the fault and what to do about it; "" if there is a value.
    const char* reason() const noexcept { return reason_.c_str(); }
    /// Whether there is a value.
    explicit operator bool() const noexcept { return status_ == Status::done; }

    /// Without a value: an empty one, which every type of this library has and every call answers with a status.
    /// @{
    T& operator*() & noexcept { return value_; }
    const T& operator*() const& noexcept { return value_; }
    T&& operator*() && noexcept { return std::move(value_); }
    T* operator->() noexcept { return &value_; }
    const T* operator->() const noexcept { return &value_; }
    /// @}

private:
    Status status_;
    Sentence reason_;
    T value_{};
};

/// The same without a value.
class [[nodiscard]] Outcome
{
public:
    Outcome() noexcept = default;  ///< done
    /// Something else, and why.
    Outcome(Status status, Sentence reason) noexcept : status_(status), reason_(std::move(reason)) {}

    Status status() const noexcept { return status_; }  ///< `done`, or what went wrong
    /// One sentence that names the fault and what to do about it; "" if there is none.
    const char* reason() const noexcept { return reason_.c_str(); }
    /// Whether the call did what was asked for.
    explicit operator bool() const noexcept { return status_ == Status::done; }

private:
    Status status_ = Status::done;
    Sentence reason_;
};

/// @}

}  // namespace kerf
