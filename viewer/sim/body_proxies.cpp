#include "viewer/sim/body_proxies.h"

#include <new>
#include <utility>

#include "baseline/report_back_ends.h"

namespace kerf::sim {
namespace {

template <class T>
T value_of(Result<T> result)
{
    if (!result) throw std::bad_alloc();
    return *std::move(result);
}

void take_hull(Hull hull, CollisionProxy& proxy)
{
    proxy.points.reserve(hull.points().size());
    for (const Vec3f& p : hull.points()) proxy.points.emplace_back(p.x, p.y, p.z);
    proxy.hull = std::make_shared<const Hull>(std::move(hull));
}

}  // namespace

std::string_view proxy_name(ProxyKind kind)
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
            return "every_vertex";
    }
    return {};
}

std::optional<ProxyKind> find_proxy(std::string_view name)
{
    for (const ProxyKind kind : kProxyKinds)
        if (proxy_name(kind) == name) return kind;
    return std::nullopt;
}

CollisionProxy body_proxy(const Object& object, ProxyKind kind)
{
    CollisionProxy proxy;
    proxy.kind = kind;
    proxy.box = object.bounds();
    switch (kind) {
        case ProxyKind::box:
            break;
        case ProxyKind::sphere: {
            const Sphere sphere = value_of(bounding_sphere(object));
            proxy.centre = glm::vec3(sphere.centre);
            proxy.radius = sphere.radius;
            break;
        }
        case ProxyKind::bounded_hull:
            take_hull(value_of(bounded_hull(object)), proxy);
            break;
        case ProxyKind::full_hull:
            take_hull(value_of(full_hull(object)), proxy);
            break;
        case ProxyKind::points:
            for (const Vec3f& p : report_collision_points(object)) proxy.points.emplace_back(p.x, p.y, p.z);
            break;
    }
    return proxy;
}

}  // namespace kerf::sim
