// The banana, and the three that do magic: they differ in nothing but their skin.

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "maker/fruit/fruit.h"
#include "maker/fruit/growth.h"

namespace kerf::maker {
namespace {

using std::numbers::pi;

// shaders/fruit_banana.glsl knows these numbers.
constexpr double kBend = 1.12;       ///< radius of the axis, an arc in the plane z = 0
constexpr double kHalfAngle = 0.98;  ///< of that arc, from the middle to either end
constexpr double kDrop = 0.22;       ///< of the arc's middle below the origin

double smooth_step(double low, double high, double x)
{
    const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

/// Radius over the share of the way along the axis, -1 (the flower's end) to 1 (the stalk).
double thickness(double s)
{
    const double body = 0.21 * (1.0 - 0.14 * s * s);
    const double tip = 0.36 + 0.64 * smooth_step(-1.0, -0.70, s);
    const double neck = 1.0 - 0.66 * smooth_step(0.40, 0.86, s);
    return body * tip * neck;
}

PolyMesh banana_of(std::string_view material)
{
    PolyMesh mesh;
    constexpr int kSegments = 40, kRings = 46;
    Lathe lathe(mesh, kSegments, material);
    lathe.smooth(1);
    const auto centre = [](double s) {
        const double angle = kHalfAngle * s;
        return glm::dvec3{kBend * std::sin(angle), kBend * (1.0 - std::cos(angle)) - kDrop, 0};
    };
    Ring first, last;
    for (int k = 0; k <= kRings; ++k) {
        const double s = -1.0 + 2.0 * k / kRings, angle = kHalfAngle * s;
        const glm::dvec3 inwards{-std::sin(angle), std::cos(angle), 0}, sideways{0, 0, 1};
        // Five ribs; they fade at the flower's end.
        const double ribs = 0.032 * smooth_step(-1.0, -0.8, s);
        const Ring ring = lathe.ring(
            [&](int i) {
                const double turn = 2.0 * pi * i / kSegments;
                const double rib = std::cos(5.0 * turn) + 0.25 * std::cos(10.0 * turn);
                const double r = thickness(s) * (1.0 + ribs * rib);
                return centre(s) + r * (std::cos(turn) * inwards + std::sin(turn) * sideways);
            },
            kBend * angle);
        if (k == 0)
            first = ring;
        else
            lathe.band(last, ring);
        last = ring;
    }
    lathe.smooth(2);
    const auto beyond = [&](double s, double by) {
        const double angle = kHalfAngle * s;
        return centre(s) + by * glm::dvec3{std::cos(angle), std::sin(angle), 0};
    };
    lathe.fan(last, beyond(1.0, 0.012), true);
    lathe.fan(first, beyond(-1.0, -0.03), false);
    return mesh;
}

}  // namespace

PolyMesh make_banana()
{
    return banana_of("banana");
}

PolyMesh make_freeze()
{
    return banana_of("freeze");
}

PolyMesh make_frenzy()
{
    return banana_of("frenzy");
}

PolyMesh make_double()
{
    return banana_of("double");
}

}  // namespace kerf::maker
