#include "common/proxy/collision_proxy.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "common/mesh/float_range.h"
#include "common/mesh/four_floats.h"
#include "common/mesh/is_finite.h"
#include "common/mesh/support_points.h"
#include "common/proxy/convex_hull.h"

namespace kerf::core {
namespace {

Box box_around(std::span<const Vertex> vertices)
{
    Box box;
    for (const Vertex& v : vertices) box.add(v.position);
    return box;
}

// Places that differ, coordinate by coordinate, for quick comparison.
class Places
{
public:
    Places()
    {
        // Equal to nothing.
        for (auto* coordinate : {&x_, &y_, &z_}) coordinate->fill(std::numeric_limits<float>::quiet_NaN());
    }

    // Adds a place; false if it is there already.
    bool add(const glm::vec3& p)
    {
        for (std::size_t i = 0; i < count_; i += kLanes)
            if ((equal_lanes(load(&x_[i]), Four{} + p.x) & equal_lanes(load(&y_[i]), Four{} + p.y) &
                 equal_lanes(load(&z_[i]), Four{} + p.z)) != 0)
                return false;
        x_[count_] = p.x;
        y_[count_] = p.y;
        z_[count_] = p.z;
        ++count_;
        return true;
    }

private:
    static_assert(kSupportDirections % kLanes == 0);
    std::array<float, kSupportDirections> x_, y_, z_;
    std::size_t count_ = 0;
};

// Those that are finite, each place once, in their order.
void use_places(CollisionProxy& proxy, const std::array<glm::vec3, kSupportDirections>& points)
{
    proxy.points.reserve(points.size());
    Places places;
    for (const glm::vec3& p : points)
        if (is_finite(p) && places.add(p)) proxy.points.push_back(p);
}

}  // namespace

std::string_view name_of(ProxyKind kind)
{
    switch (kind) {
        case ProxyKind::box:
            return "box";
        case ProxyKind::sphere:
            return "sphere";
        case ProxyKind::bounded_hull:
            return "bounded_hull";
        case ProxyKind::full_hull:
            return "full_hull";
        case ProxyKind::points:
            return "points";
    }
    return "unknown";
}

CollisionProxy bounded_hull(const Box& box, const std::array<glm::vec3, kSupportDirections>& points)
{
    CollisionProxy proxy;
    proxy.kind = ProxyKind::bounded_hull;
    proxy.box = box;
    if (!box.empty()) use_places(proxy, points);
    return proxy;
}

std::vector<Triangle> hull_faces(std::span<const glm::vec3> points)
{
    ConvexHull hull = convex_hull(points);
    for (Triangle& face : hull.faces)
        for (std::uint32_t& corner : face) corner = hull.corners[corner];
    return std::move(hull.faces);
}

CollisionProxy collision_proxy(ProxyKind kind, std::span<const Vertex> vertices)
{
    CollisionProxy proxy;
    proxy.kind = kind;
    if (vertices.empty()) return proxy;
    switch (kind) {
        case ProxyKind::box:
            proxy.box = box_around(vertices);
            break;
        case ProxyKind::sphere: {
            proxy.box = box_around(vertices);
            proxy.centre = glm::vec3(proxy.box.centre());
            double squared = 0.0;
            for (const Vertex& v : vertices) {
                const glm::dvec3 d = glm::dvec3(v.position) - glm::dvec3(proxy.centre);
                squared = std::max(squared, glm::dot(d, d));
            }
            // Rounded up, so that no vertex is outside, as far as floats reach.
            constexpr float kLargest = std::numeric_limits<float>::max();
            const double radius = std::sqrt(squared);
            proxy.radius = nearest_finite_float(radius);
            if (double(proxy.radius) <= radius && radius > 0.0) proxy.radius = std::nextafter(proxy.radius, kLargest);
            break;
        }
        case ProxyKind::bounded_hull: {
            const std::array<glm::vec3, kSupportDirections> points = support_points(vertices);
            for (const glm::vec3& p : points) proxy.box.add(p);  // the axes are among the directions
            use_places(proxy, points);
            break;
        }
        case ProxyKind::full_hull: {
            proxy.box = box_around(vertices);
            std::vector<glm::vec3> points;
            points.reserve(vertices.size());
            for (const Vertex& v : vertices) points.push_back(v.position);
            ConvexHull hull = convex_hull(points);
            for (const std::uint32_t i : hull.corners) proxy.points.push_back(points[i]);
            proxy.faces = std::move(hull.faces);
            break;
        }
        case ProxyKind::points:
            break;
    }
    return proxy;
}

CollisionProxy collision_proxy(const Cuttable& object, ProxyKind kind)
{
    switch (kind) {
        case ProxyKind::box: {
            CollisionProxy proxy;
            proxy.box = object.bounds();
            return proxy;
        }
        case ProxyKind::bounded_hull:
            return bounded_hull(object.bounds(), object.support_points());
        case ProxyKind::sphere:
        case ProxyKind::full_hull:
        case ProxyKind::points:
            break;
    }
    std::vector<Vertex> room;
    return collision_proxy(kind, object.used_vertices(room));
}

}  // namespace kerf::core
