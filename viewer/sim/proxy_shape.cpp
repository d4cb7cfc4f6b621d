#include "viewer/sim/proxy_shape.h"

#include <BulletCollision/CollisionShapes/btConvexHullShape.h>
#include <BulletCollision/CollisionShapes/btMultiSphereShape.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <span>
#include <utility>

#include "viewer/sim/bullet_glm.h"

namespace kerf::sim {
namespace {

// pkg-config's Bullet is the one in single precision; a mixture would not even crash reliably.
static_assert(sizeof(btScalar) == sizeof(float));

/// Sides of a body are at least this for the collision engine, metres: below, float arithmetic at the stage's size
/// (units in the last place of a micrometre) leaves GJK too few digits.
constexpr double kThinnestSide = 2e-3;
/// Bullet grows hulls by this, metres, and wants it to hide penetration; a hundredth of a thrown object's size can't be
/// seen. Thin shapes get less: this share of their thinnest side.
constexpr double kMargin = 0.01;
constexpr double kMarginShare = 0.05;
/// Points no farther from a plane than this share of their extent count as flat: what a lattice of 10 216 steps along
/// each axis, as Bullet computes hulls on, can't tell from rounding (two steps).
constexpr double kFlatShare = 2e-4;

/// A hull whose box is that of its points as they stand. Bullet's own is the box around the turned box, up to three
/// times as wide, and most pairs that it hands to the narrow phase are nowhere near each other.
class TightHullShape : public btConvexHullShape
{
public:
    explicit TightHullShape(std::size_t points) { m_unscaledPoints.reserve(int(points)); }

    void getAabb(const btTransform& frame, btVector3& lo, btVector3& hi) const override
    {
        lo.setValue(BT_LARGE_FLOAT, BT_LARGE_FLOAT, BT_LARGE_FLOAT);
        hi = -lo;
        const btVector3* const points = getUnscaledPoints();
        for (int i = 0; i < getNumPoints(); ++i) {
            const btVector3 p = frame.getBasis() * points[i];
            lo.setMin(p);
            hi.setMax(p);
        }
        const btVector3 outside = frame.getOrigin(), margin(getMargin(), getMargin(), getMargin());
        lo += outside - margin;
        hi += outside + margin;
    }
};

/// Whether a plane through three of the points passes within kFlatShare of them all: through one, the one farthest from
/// it, and the one farthest from their line. O(points).
bool are_flat(std::span<const glm::vec3> points)
{
    if (points.size() < 4) return true;
    const auto from_first = [&](const glm::vec3& p) { return glm::dvec3(p) - glm::dvec3(points.front()); };
    const auto largest = [&](auto measure) {
        double most = 0.0;
        glm::dvec3 where(0.0);
        for (const glm::vec3& p : points)
            if (const double m = measure(from_first(p)); m > most) {
                most = m;
                where = from_first(p);
            }
        return std::pair(most, where);
    };
    const auto [extent, far] = largest([](const glm::dvec3& p) { return glm::length(p); });
    if (!(extent > 0.0)) return true;
    const glm::dvec3 along = far / extent;
    const auto [width, aside] = largest([&](const glm::dvec3& p) { return glm::length(glm::cross(along, p)); });
    if (!(width > kFlatShare * extent)) return true;
    const glm::dvec3 normal = glm::normalize(glm::cross(along, aside));
    return largest([&](const glm::dvec3& p) { return std::abs(glm::dot(normal, p)); }).first <= kFlatShare * extent;
}

}  // namespace

ProxyShape::ProxyShape(CollisionProxy proxy, const glm::dvec3& centre, const glm::dmat3& axes, double scale)
    : proxy_(std::move(proxy))
{
    const glm::dmat3 to_axes = glm::transpose(axes);
    const auto local = [&](const glm::dvec3& p) { return to_bullet(scale * (to_axes * (p - centre))); };

    if (proxy_.kind == ProxyKind::sphere) {
        const btVector3 middle = local(glm::dvec3(proxy_.centre));
        const auto ball = btScalar(std::max(scale * double(proxy_.radius), kThinnestSide));
        shape_ = std::make_unique<btMultiSphereShape>(&middle, &ball, 1);
        radius_ = double(middle.length()) + double(ball);
        return;
    }

    const glm::dvec3 lo(proxy_.box.is_empty() ? glm::vec3(centre) : glm::vec3(proxy_.box.lo));
    const glm::dvec3 hi(proxy_.box.is_empty() ? glm::vec3(centre) : glm::vec3(proxy_.box.hi));
    const glm::dvec3 side = (hi - lo) * scale;
    const double thinnest = std::min({side.x, side.y, side.z});

    const bool is_hull = proxy_.kind != ProxyKind::box && proxy_.points.size() >= 4 && thinnest >= kThinnestSide &&
                         (proxy_.kind == ProxyKind::points || !are_flat(proxy_.points));
    constexpr int kCorners = 8;
    auto hull = std::make_unique<TightHullShape>(is_hull ? proxy_.points.size() : kCorners);
    if (is_hull) {
        for (const glm::vec3& p : proxy_.points) hull->addPoint(local(glm::dvec3(p)), false);
    } else {
        const glm::dvec3 middle = (lo + hi) * 0.5;
        const glm::dvec3 half = glm::max(side, glm::dvec3(kThinnestSide)) * (0.5 / scale);
        for (int corner = 0; corner < kCorners; ++corner) {
            const glm::dvec3 sign((corner & 1) ? 1.0 : -1.0, (corner & 2) ? 1.0 : -1.0, (corner & 4) ? 1.0 : -1.0);
            hull->addPoint(local(middle + sign * half), false);
        }
    }
    const double margin = std::min(kMargin, kMarginShare * std::max(thinnest, kThinnestSide));
    hull->setMargin(btScalar(margin));
    hull->recalcLocalAabb();
    btScalar farthest = 0.0f;  // squared
    for (int i = 0; i < hull->getNumPoints(); ++i)
        farthest = std::max(farthest, hull->getUnscaledPoints()[i].length2());
    radius_ = double(btSqrt(farthest)) + margin;
    shape_ = std::move(hull);
}

ProxyShape::~ProxyShape() = default;

}  // namespace kerf::sim
