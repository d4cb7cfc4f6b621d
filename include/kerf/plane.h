#pragma once

#include <kerf/export.h>
#include <kerf/math.h>

#include <optional>

namespace kerf {

/// @addtogroup planes
/// Where a cut goes, and which side is which.
/// @{

/// The two sides of a plane. Points on the plane are on the positive one.
enum class Side : unsigned char
{
    negative = 0,
    positive = 1,
};

/// The other side.
constexpr Side opposite(Side side) noexcept
{
    return side == Side::negative ? Side::positive : Side::negative;
}

/// A place that a plane goes through, in the units of the mesh.
struct Point : Vec3d
{
    /// Of three coordinates. Explicit: braces alone don't say which of the two they are.
    explicit constexpr Point(double x_, double y_, double z_) : Vec3d(x_, y_, z_) {}
    /// Of a vector of the caller's own type.
    template <HasXyz T>
    explicit constexpr Point(const T& t) : Vec3d(t)
    {
    }
};

/// The direction in which a plane's positive side lies; of any length but 0.
struct Normal : Vec3d
{
    /// Of three coordinates.
    explicit constexpr Normal(double x_, double y_, double z_) : Vec3d(x_, y_, z_) {}
    /// Of a vector of the caller's own type.
    template <HasXyz T>
    explicit constexpr Normal(const T& t) : Vec3d(t)
    {
    }
};

/// A plane. Always valid: the functions that make one return nothing if the numbers describe none (a normal without a
/// direction, a number that is not finite). Copies are cheap. All functions may be called from any thread.
///
/// A point and a normal can't be mistaken for one another; vectors of your own are named as the one or the other:
///
///     auto plane = kerf::Plane::at(kerf::Point(0, 0, 2), kerf::Normal(up));
class KERF_API Plane
{
public:
    /// Through a point, with the positive side where the normal points to.
    static std::optional<Plane> at(Point point, Normal normal) noexcept;

    /// Through three points. They run counter-clockwise if they are seen from the positive side. Nothing if they lie on
    /// one line.
    static std::optional<Plane> through(Vec3d a, Vec3d b, Vec3d c) noexcept;

    /// Where a x + b y + c z + d = 0; positive where it is larger. (a, b, c) has any length but 0.
    static std::optional<Plane> from_coefficients(double a, double b, double c, double d) noexcept;

    /// Across an axis: where that coordinate has this value. The normal points along the axis.
    /// @{
    static std::optional<Plane> x(double value) noexcept;
    static std::optional<Plane> y(double value) noexcept;
    static std::optional<Plane> z(double value) noexcept;
    /// @}

    /// Moved so far along its normal, in the units of the mesh; nothing if that leaves the range of double.
    std::optional<Plane> moved(double distance) const noexcept;
    /// The same places, with the sides exchanged.
    Plane flipped() const noexcept;

    /// This plane of the world as the object sees it that the matrix places there. The sides stay those of the world,
    /// so a matrix that mirrors or shears is right, too. A last row 0, 0, 0, w divides by w: that of an inverse of
    /// floats is 1 up to rounding only. Nothing if the matrix has no inverse, as far as doubles tell, or its last row is
    /// another one, or the plane leaves the range of double.
    std::optional<Plane> to_local(const Mat4d& object_to_world) const noexcept;

    /// Signed distance of a point, in the units of the mesh: positive on the positive side.
    double distance(Vec3d point) const noexcept;
    /// The side that a point lies on, with no tolerance. (A cut that would leave no more of an object on one side than
    /// rounding moves points, a few units in the last place of its largest coordinate, is a miss.)
    Side side_of(Vec3d point) const noexcept { return distance(point) >= 0.0 ? Side::positive : Side::negative; }

    /// Of length 1.
    Normal normal() const noexcept { return normal_; }
    /// Signed distance of the plane from the origin, along the normal.
    double offset() const noexcept { return offset_; }

    friend bool operator==(const Plane&, const Plane&) = default;

private:
    Plane(Normal unit_normal, double offset) noexcept : normal_(unit_normal), offset_(offset) {}

    Normal normal_;
    double offset_;
};

/// @}

}  // namespace kerf
