#pragma once

#include <kerf/object.h>
#include <kerf/proxy.h>

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

// What stands for a piece in a physics engine, in all the ways that are timed.

namespace kerf::bench {

enum class ProxyKind : std::uint8_t
{
    box,
    sphere,
    bounded_hull,
    full_hull,
    /// The report's collision shape (section 3.2.4): every vertex added to the physics engine's hull shape, one by one,
    /// as its program does. The shape computes its bounding box anew with each of them, so this is quadratic.
    every_vertex,
};
inline constexpr std::array kProxyKinds{ProxyKind::box, ProxyKind::sphere, ProxyKind::bounded_hull,
                                        ProxyKind::full_hull, ProxyKind::every_vertex};

/// What benchmarks are called by.
std::string name_of(ProxyKind kind);

/// A convex body in mesh coordinates.
struct Proxy
{
    ProxyKind kind = ProxyKind::box;
    Box box;                    ///< box and every vertex
    Sphere sphere;              ///< sphere
    Hull hull;                  ///< both hulls
    std::vector<Vec3f> points;  ///< every vertex: those that the physics engine holds

    /// Points that the physics engine gets; none of a box or a sphere.
    std::span<const Vec3f> corners() const { return kind == ProxyKind::every_vertex ? points : hull.points(); }
};

/// What is timed.
Proxy make_proxy(ProxyKind kind, const Object& object);

/// Mesh units cubed. O(n).
double volume_of(const Hull& hull);

/// Volume of the convex body that a proxy stands for, mesh units cubed; `full_hull` is that of the same object. O(n).
double proxy_volume(const Proxy& proxy, const Hull& full_hull);

/// Whether a proxy is one of this object: boxes and spheres hold all of its vertices; hulls have corners among them and
/// reach as far, a bounded one along the axes, where no rounding is allowed. A bounded hull has no more than 32
/// corners, all of them on the full hull, holds at least half of its volume, and is the one that the linear back end
/// finds, vertex by vertex, around the same triangles. Empty if it is.
std::string check_proxy(const Proxy& proxy, const Object& object, const Hull& full_hull);

}  // namespace kerf::bench
