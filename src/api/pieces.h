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

    /// Pieces of several cuts. May throw std::bad_alloc.
    void gather(Object&& piece) { gathered_.push_back(std::move(piece)); }

    std::span<Object> all() noexcept
    {
        if (!gathered_.empty()) return gathered_;
        return {std::launder(reinterpret_cast<Object*>(places_.data())), places_.size()};
    }

private:
    void give_places_back() noexcept
    {
        for (std::unique_ptr<core::Cuttable>& place : places_) {
            std::destroy_at(std::launder(reinterpret_cast<Object*>(&place)));
            ::new (static_cast<void*>(&place)) std::unique_ptr<core::Cuttable>;
        }
        places_.clear();
    }

    std::vector<std::unique_ptr<core::Cuttable>> places_;  // of Objects
    std::vector<Object> gathered_;
};

}  // namespace kerf
