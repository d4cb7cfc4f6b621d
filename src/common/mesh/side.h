#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>

// The two sides of a plane.

namespace kerf::core {

enum class Side : std::uint8_t
{
    negative = 0,
    positive = 1
};

inline constexpr std::array kSides{Side::negative, Side::positive};

/// A value for each side.
template <class T>
struct BySide
{
    std::array<T, 2> of;

    T& operator[](Side side) { return of[static_cast<std::size_t>(side)]; }
    const T& operator[](Side side) const { return of[static_cast<std::size_t>(side)]; }
    auto begin() { return of.begin(); }
    auto end() { return of.end(); }
    auto begin() const { return of.begin(); }
    auto end() const { return of.end(); }
    auto operator<=>(const BySide&) const = default;
};

inline Side opposite(Side side)
{
    return side == Side::positive ? Side::negative : Side::positive;
}

/// The side of a point at this signed distance; points on the plane are on the positive side.
inline Side side_of(double signed_distance)
{
    return signed_distance >= 0.0 ? Side::positive : Side::negative;
}

}  // namespace kerf::core
