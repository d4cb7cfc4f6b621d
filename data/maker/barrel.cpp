// A barrel of staves with four iron hoops, sunk heads and a bung.

#include <cmath>

#include "maker/lathe.h"
#include "maker/models.h"

namespace kerf::maker {
namespace {

constexpr double kEnd = 1.0;  // half the height

double stave_radius(double height)
{
    return 0.82 - 0.17 * height * height;
}

}  // namespace

PolyMesh make_barrel()
{
    PolyMesh mesh;
    Lathe lathe(mesh, 15, "wood");
    constexpr double kSunk = 0.1, kChime = 0.07, kHoop = 0.035, kChamfer = 0.015;
    const double end_radius = stave_radius(kEnd);
    const Ring bottom_head = lathe.ring(end_radius - kChime - 0.01, -kEnd + kSunk, -kChime - kSunk);
    const Ring bottom_inner = lathe.ring(end_radius - kChime, -kEnd, -kChime);
    lathe.fan(bottom_head, -kEnd + kSunk, false);
    lathe.band(bottom_head, bottom_inner);
    Ring below = lathe.ring(end_radius, -kEnd, 0.0);
    lathe.band(bottom_inner, below);

    double v = 0.0, last = -kEnd;
    const auto rise = [&](double height, double stand_off, std::string_view material) {
        lathe.use(material);
        v += height - last + stand_off;
        last = height;
        const double radius = stave_radius(height) + stand_off;
        const Ring above = lathe.ring([&](int i) { return lathe.at(radius, height, i); }, v);
        lathe.band(below, above);
        below = above;
    };
    const auto hoop = [&](double from, double to) {
        rise(from, 0.0, "wood");
        rise(from + kChamfer, kHoop, "iron");
        rise(to - kChamfer, kHoop, "iron");
        rise(to, 0.0, "iron");
    };
    hoop(-0.94, -0.74);
    hoop(-0.46, -0.3);
    hoop(0.3, 0.46);
    hoop(0.74, 0.94);
    rise(kEnd, 0.0, "wood");
    const Ring top_inner = lathe.ring(end_radius - kChime, kEnd, v + kChime),
               top_head = lathe.ring(end_radius - kChime - 0.01, kEnd - kSunk, v + kChime + kSunk);
    lathe.band(below, top_inner);
    lathe.band(top_inner, top_head);

    Lathe small(mesh, 12, "wood");
    constexpr double kBungRadius = 0.1, kBungHeight = 0.05;
    const auto bung = [&](double height) {
        return small.ring([&](int i) { return small.at(kBungRadius, height, i) + glm::dvec3{0.28, 0.0, 0.0}; }, height);
    };
    const Ring bung_foot = bung(kEnd - kSunk), bung_top = bung(kEnd - kSunk + kBungHeight);
    bridge(mesh, top_head.points, bung_foot.points, "wood");
    small.band(bung_foot, bung_top);
    small.disc(bung_top, true);
    mesh.fit(2.0);
    return mesh;
}

}  // namespace kerf::maker
