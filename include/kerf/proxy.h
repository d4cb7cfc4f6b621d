#pragma once

#include <kerf/export.h>
#include <kerf/math.h>
#include <kerf/status.h>

#include <cstdint>
#include <span>

namespace kerf {

/// @addtogroup physics
/// Stand-ins for physics are simple shapes around an object. Component `proxy`.
/// @{

class Object;

/// A sphere around all vertices. Not the smallest one: its centre is that of the bounds.
struct Sphere
{
    Vec3f centre;         ///< in the object's coordinates
    float radius = 0.0f;  ///< in the mesh's unit of length
};

/// A convex body around an object.
class KERF_API Hull
{
public:
    /// An empty one; what is moved from is empty, too.
    /// @{
    Hull() noexcept = default;
    Hull(Hull&& other) noexcept;
    Hull& operator=(Hull&& other) noexcept;
    /// @}
    ~Hull();

    /// The points that it is spanned by, all of them vertices of the object at different places: what a physics engine
    /// wants to know. Of a bounded hull, few may lie on a side of it or, by rounding, within.
    std::span<const Vec3f> points() const noexcept;
    /// The points that are corners of its triangles, three each, counter-clockwise from outside. Those of a bounded hull
    /// are found when first asked for, O(points log(points)): a game that leaves them to its physics engine does not
    /// wait for them. None of a flat object, and if there is no memory for them. Any thread.
    std::span<const std::uint32_t> indices() const noexcept;

    /// @cond For the library itself.
    struct Data;
    explicit Hull(Data* data) noexcept : data_(data) {}
    /// @endcond

private:
    Data* data_ = nullptr;
};

/// Around all vertices; at most sqrt(3) times the smallest one. O(n). Status: `invalid_argument` for an empty object,
/// `out_of_memory`.
KERF_API Result<Sphere> bounding_sphere(const Object& object) noexcept;

/// The hull of the vertices that lie farthest along 32 directions: what games use. Its points come in the order of the
/// directions. O(log n) for ordinary shapes with the half-edge back end, O(n) with the linear one. A flat object has
/// points and no triangles. Status as above.
///
///     if (const kerf::Result<kerf::Hull> hull = kerf::bounded_hull(piece)) add_body(hull->points());
KERF_API Result<Hull> bounded_hull(const Object& object) noexcept;

/// The hull of all vertices. O(n log n). Status as above.
KERF_API Result<Hull> full_hull(const Object& object) noexcept;

/// @}

}  // namespace kerf
