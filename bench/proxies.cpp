#include "bench/proxies.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <tuple>

#include "baseline/report_back_ends.h"
#include "bench/checked_cut.h"
#include "bench/objects.h"

namespace kerf::bench {

namespace {

using Positions = std::span<const Vec3f>;

void add(Box& box, const Vec3f& p)
{
    box.lo = {std::min(box.lo.x, p.x), std::min(box.lo.y, p.y), std::min(box.lo.z, p.z)};
    box.hi = {std::max(box.hi.x, p.x), std::max(box.hi.y, p.y), std::max(box.hi.z, p.z)};
}

Box box_around(Positions positions)
{
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    Box box{{kInfinity, kInfinity, kInfinity}, {-kInfinity, -kInfinity, -kInfinity}};
    for (const Vec3f& p : positions) add(box, p);
    return box;
}

/// A face of a hull, as a plane with the hull below it.
struct Face
{
    glm::dvec3 corner, normal;

    double distance(const Vec3f& p) const { return glm::dot(normal, to_glm(p) - corner); }
};

/// Faces without area are left out: they have no direction.
std::vector<Face> faces_of(const Hull& hull)
{
    std::vector<Face> faces;
    for (std::size_t i = 0; i < hull.indices().size(); i += 3) {
        const auto corner = [&](std::size_t j) { return to_glm(hull.points()[hull.indices()[i + j]]); };
        const glm::dvec3 across = glm::cross(corner(1) - corner(0), corner(2) - corner(0));
        if (const double length = glm::length(across); length > 0.0) faces.push_back({corner(0), across / length});
    }
    return faces;
}

/// How far a full hull may be off: it is computed on a lattice, and a vertex may stand out by about one step of it. In
/// mesh units.
double lattice_slack(const Box& bounds)
{
    constexpr double kShare = 2e-4;
    double largest = 0.0;
    for (const Vec3f& corner : {bounds.lo, bounds.hi})
        for (const float coordinate : {corner.x, corner.y, corner.z})
            largest = std::max(largest, std::abs(double(coordinate)));
    return kShare * largest;
}

bool are_among(Positions corners, Positions positions)
{
    const auto is_before = [](const Vec3f& a, const Vec3f& b) {
        return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
    };
    std::vector<Vec3f> sorted(positions.begin(), positions.end());
    std::sort(sorted.begin(), sorted.end(), is_before);
    return std::all_of(corners.begin(), corners.end(),
                       [&](const Vec3f& p) { return std::binary_search(sorted.begin(), sorted.end(), p, is_before); });
}

double reach(Positions positions, const glm::dvec3& direction)
{
    double most = -std::numeric_limits<double>::infinity();
    for (const Vec3f& p : positions) most = std::max(most, glm::dot(direction, to_glm(p)));
    return most;
}

std::string check_hull(const Hull& hull, Positions positions)
{
    if (hull.points().empty() || !are_among(hull.points(), positions)) return "a hull has a corner that is no vertex";
    if (!are_closed(hull.indices())) return "a hull is not closed";
    return {};
}

std::string check_full_hull(const Hull& hull, Positions positions)
{
    constexpr std::uint32_t kDirections = 256;
    constexpr std::uint64_t kSeed = 5;
    const Box bounds = box_around(positions);
    const double slack = lattice_slack(bounds);
    for (const Plane& plane : planes_through_the_middle(bounds, kDirections, kSeed)) {
        const glm::dvec3 direction = to_glm(plane.normal());
        if (reach(hull.points(), direction) < reach(positions, direction) - slack)
            return "a hull does not reach as far as its vertices";
    }
    return {};
}

std::string check_bounded_hull(const Hull& hull, const Mesh& mesh, const Hull& full_hull)
{
    constexpr std::size_t kMostCorners = 32;
    constexpr double kLeastShare = 0.5;
    const Positions positions = mesh.arrays().positions;
    if (hull.points().size() > kMostCorners) return "a bounded hull has too many corners";
    const Box box = box_around(hull.points()), bounds = box_around(positions);
    if (box.lo != bounds.lo || box.hi != bounds.hi) return "a hull does not reach as far as its vertices";
    const std::vector<Face> faces = faces_of(full_hull);
    const double slack = lattice_slack(bounds);
    const auto is_inside = [&](const Vec3f& p) {
        return std::all_of(faces.begin(), faces.end(), [&](const Face& face) { return face.distance(p) < -slack; });
    };
    if (!faces.empty() && std::any_of(hull.points().begin(), hull.points().end(), is_inside))
        return "a bounded hull has a corner that is not on the full hull";
    if (volume_of(hull) < kLeastShare * volume_of(full_hull)) return "a bounded hull is too small";
    PrepareOptions options;
    options.back_end = BackEnd::linear;
    const Hull other = value_of(bounded_hull(value_of(prepare(mesh, options))));
    if (!std::equal(hull.points().begin(), hull.points().end(), other.points().begin(), other.points().end()))
        return "a bounded hull is not the one that the linear back end finds";
    return {};
}

}  // namespace

std::string name_of(ProxyKind kind)
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
        case ProxyKind::every_vertex:
            return "every_vertex";
    }
    return "unknown";
}

Proxy make_proxy(ProxyKind kind, const Object& object)
{
    Proxy proxy;
    proxy.kind = kind;
    switch (kind) {
        case ProxyKind::box:
            proxy.box = object.bounds();
            break;
        case ProxyKind::sphere:
            proxy.sphere = value_of(bounding_sphere(object));
            break;
        case ProxyKind::bounded_hull:
            proxy.hull = value_of(bounded_hull(object));
            break;
        case ProxyKind::full_hull:
            proxy.hull = value_of(full_hull(object));
            break;
        case ProxyKind::every_vertex:
            proxy.box = object.bounds();
            proxy.points = report_collision_points(object);
            break;
    }
    return proxy;
}

double volume_of(const Hull& hull)
{
    double six = 0.0;
    for (std::size_t i = 0; i < hull.indices().size(); i += 3) {
        // About the first corner, so that coordinates far from the origin cost nothing.
        const auto corner = [&](std::size_t j) {
            return to_glm(hull.points()[hull.indices()[i + j]]) - to_glm(hull.points()[0]);
        };
        six += glm::dot(corner(0), glm::cross(corner(1), corner(2)));
    }
    return six / 6.0;
}

double proxy_volume(const Proxy& proxy, const Hull& full_hull)
{
    constexpr double kPi = 3.14159265358979323846;
    switch (proxy.kind) {
        case ProxyKind::box: {
            const glm::dvec3 size = to_glm(proxy.box.hi) - to_glm(proxy.box.lo);
            return size.x * size.y * size.z;
        }
        case ProxyKind::sphere:
            return 4.0 / 3.0 * kPi * std::pow(double(proxy.sphere.radius), 3);
        case ProxyKind::bounded_hull:
        case ProxyKind::full_hull:
            return volume_of(proxy.hull);
        case ProxyKind::every_vertex:
            break;
    }
    // The physics engine takes the hull of the points.
    return volume_of(full_hull);
}

std::string check_proxy(const Proxy& proxy, const Object& object, const Hull& full_hull)
{
    const Mesh mesh = value_of(object.mesh());
    const Positions positions = mesh.arrays().positions;
    const Box bounds = box_around(positions);
    switch (proxy.kind) {
        case ProxyKind::box:
            if (proxy.box.lo != bounds.lo || proxy.box.hi != bounds.hi) return "a box is not that of its vertices";
            return {};
        case ProxyKind::sphere:
            for (const Vec3f& p : positions)
                if (!(glm::distance(to_glm(p), to_glm(proxy.sphere.centre)) <= double(proxy.sphere.radius)))
                    return "a vertex is outside its proxy";
            return {};
        case ProxyKind::every_vertex:
            if (!std::equal(proxy.points.begin(), proxy.points.end(), positions.begin(), positions.end()))
                return "the points are not the vertices";
            return {};
        case ProxyKind::bounded_hull:
        case ProxyKind::full_hull:
            break;
    }
    if (std::string error = check_hull(proxy.hull, positions); !error.empty()) return error;
    return proxy.kind == ProxyKind::full_hull ? check_full_hull(proxy.hull, positions)
                                              : check_bounded_hull(proxy.hull, mesh, full_hull);
}

}  // namespace kerf::bench
