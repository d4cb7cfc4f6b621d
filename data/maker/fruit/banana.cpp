// The banana, and the three that do magic: they differ in nothing but their skin.

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "maker/fruit/banana.h"
#include "maker/fruit/fruit.h"

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
    Lathe lathe(mesh, kBananaSegments, material);
    const SkinRings rings = grow_banana(lathe, 1.0);
    lathe.smooth(2);
    const BananaAxis end = banana_axis(1.0);
    lathe.fan(rings.highest, end.place + 0.012 * end.along, true);
    close_flowers_end(lathe, rings.lowest);
    return mesh;
}

}  // namespace

BananaAxis banana_axis(double share)
{
    const double angle = kHalfAngle * share;
    return {{kBend * std::sin(angle), kBend * (1.0 - std::cos(angle)) - kDrop, 0},
            {std::cos(angle), std::sin(angle), 0},
            {-std::sin(angle), std::cos(angle), 0}};
}

SkinRings grow_banana(Lathe& lathe, double to_share)
{
    constexpr int kRings = 46;
    lathe.smooth(1);
    SkinRings rings;
    for (int k = 0; k <= kRings; ++k) {
        const double s = std::min(-1.0 + 2.0 * k / kRings, to_share);
        const BananaAxis axis = banana_axis(s);
        const glm::dvec3 sideways{0, 0, 1};
        // Five ribs; they fade at the flower's end.
        const double ribs = 0.032 * smooth_step(-1.0, -0.8, s);
        const Ring ring = lathe.ring(
            [&](int i) {
                const double turn = 2.0 * pi * i / kBananaSegments;
                const double rib = std::cos(5.0 * turn) + 0.25 * std::cos(10.0 * turn);
                const double r = thickness(s) * (1.0 + ribs * rib);
                return axis.place + r * (std::cos(turn) * axis.inwards + std::sin(turn) * sideways);
            },
            kBend * kHalfAngle * s);
        if (k == 0)
            rings.lowest = ring;
        else
            lathe.band(rings.highest, ring);
        rings.highest = ring;
        if (s == to_share) break;
    }
    return rings;
}

void close_flowers_end(Lathe& lathe, const Ring& lowest)
{
    lathe.smooth(2);
    const BananaAxis end = banana_axis(-1.0);
    lathe.fan(lowest, end.place - 0.03 * end.along, false);
}

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
