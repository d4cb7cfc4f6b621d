#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <memory>

#include "viewer/sim/body_proxies.h"

class btConvexShape;

namespace kerf::sim {

/// A Bullet shape with what it is built of. Its origin is the body's: centre of mass, principal axes, metres.
class ProxyShape
{
public:
    /// @param centre, axes  centre of mass and principal axes in mesh coordinates (Solid)
    /// @param scale         metres a mesh unit
    /// A box is the hull of its eight corners, because it keeps the mesh's axes and not the principal ones. A hull
    /// without a volume, or thinner than Bullet's arithmetic stands, becomes its box with sides of at least
    /// kThinnestSide. `points` go to Bullet as they are. O(points).
    ProxyShape(CollisionProxy proxy, const glm::dvec3& centre, const glm::dmat3& axes, double scale);
    ~ProxyShape();
    ProxyShape(const ProxyShape&) = delete;
    ProxyShape& operator=(const ProxyShape&) = delete;

    /// What Bullet collides.
    btConvexShape& shape() const { return *shape_; }
    /// Radius of a ball around the body's origin that holds the shape, metres.
    double radius() const { return radius_; }
    /// For drawing: as built, in mesh coordinates.
    const CollisionProxy& proxy() const { return proxy_; }

private:
    CollisionProxy proxy_;
    std::unique_ptr<btConvexShape> shape_;
    double radius_ = 0.0;
};

}  // namespace kerf::sim
