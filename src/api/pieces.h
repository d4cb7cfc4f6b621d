#pragma once

#include <kerf/object.h>

#include <memory>
#include <new>
#include <span>
#include <vector>

#include "common/cutting/cut.h"

namespace kerf {

static_assert(sizeof(Object) == sizeof(std::unique_ptr<core::Cuttable>) &&
              alignof(Object) == alignof(std::unique_ptr<core::Cuttable>));

/// The pieces of one side. Those of one cut are turned into Objects where they lie, because nothing may fail any more
/// when they are there: an Object takes the place of each pointer.
class Pieces
{
public:
    Pieces() = default;
    Pieces(const Pieces&) = delete;
    Pieces& operator=(const Pieces&) = delete;
    ~Pieces() { give_places_back(); }

    void take(std::vector<std::unique_ptr<core::Cuttable>>&& pointers) noexcept
    {
        give_places_back();
        places_ = std::move(pointers);
        for (std::unique_ptr<core::Cuttable>& pointer : places_) {
            core::Cuttable* const inside = pointer.release();
            std::destroy_at(&pointer);
            ::new (static_cast<void*>(&pointer)) Object(inside);
        }
    }

    std::span<Object> all() noexcept
    {
        return {std::launder(reinterpret_cast<Object*>(places_.data())), places_.size()};
    }

    /// Leaves out those that are empty; the others keep their order.
    void drop_empty() noexcept
    {
        std::size_t kept = 0;
        for (Object& piece : all())
            if (!piece.is_empty()) all()[kept++] = std::move(piece);
        give_places_back(kept);
    }

private:
    /// From the place of this number on.
    void give_places_back(std::size_t first = 0) noexcept
    {
        for (std::size_t i = first; i < places_.size(); ++i) {
            std::destroy_at(&all()[i]);
            ::new (static_cast<void*>(&places_[i])) std::unique_ptr<core::Cuttable>;
        }
        places_.erase(places_.begin() + static_cast<std::ptrdiff_t>(first), places_.end());
    }

    std::vector<std::unique_ptr<core::Cuttable>> places_;  // of Objects
};

}  // namespace kerf
