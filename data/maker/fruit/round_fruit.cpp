// Watermelon, apple, orange, lemon, kiwi and coconut: turned bodies with a stalk.

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "maker/fruit/fruit.h"
#include "maker/fruit/growth.h"

namespace kerf::maker {
namespace {

using std::numbers::pi;

constexpr int kBody = 1, kStalk = 2, kEnd = 3;  ///< smoothing groups

/// A body closed at its foot, open at `top` radians from the upper pole.
Ring body(PolyMesh& mesh, Lathe& lathe, int segments, Outline outline, int bands, double top)
{
    lathe.smooth(kBody);
    const double step = (pi - top) / bands;
    const SkinRings rings = grow_skin(mesh, lathe, segments, outline, even_angles(pi - step, top, bands - 1));
    lathe.fan(rings.lowest, -outline(pi, 0.0), false);
    return rings.highest;
}

/// A stalk that ends in a cut face.
Ring stalk(Lathe& lathe, int segments, const Ring& from, const std::vector<Station>& stations)
{
    lathe.use("stalk");
    lathe.smooth(kStalk);
    Ring end = grow_tube(lathe, segments, from, stations);
    lathe.smooth(kEnd);
    const Station& last = stations.back();
    const Station& before = stations[stations.size() - 2];
    const glm::dvec3 out = glm::normalize(last.centre - before.centre);
    lathe.fan(end, last.centre + out * (0.15 * last.radius), true);
    return end;
}

/// The dry button where an orange or a lemon hung.
void button(PolyMesh& mesh, Lathe& lathe, int segments, const Ring& from, double radius, double height)
{
    const double y = mesh.points[std::size_t(from.points[0])].y;
    lathe.use("stalk");
    lathe.smooth(kStalk);
    const Ring end = grow_tube(lathe, segments, from,
                               {{{0, y + 0.6 * height, 0}, 0.95 * radius}, {{0, y + height, 0}, 0.6 * radius}});
    lathe.fan(end, glm::dvec3{0, y + 0.9 * height, 0}, true);
}

}  // namespace

PolyMesh make_watermelon()
{
    PolyMesh mesh;
    constexpr int kSegments = 56;
    Lathe lathe(mesh, kSegments, "watermelon");
    const Ring top = body(mesh, lathe, kSegments, watermelon_outline, 36, 0.055);
    stalk(lathe, kSegments, top,
          {{{0.002, 0.995, 0}, 0.036},
           {{0.012, 1.03, 0.004}, 0.031},
           {{0.035, 1.075, 0.01}, 0.028},
           {{0.07, 1.11, 0.012}, 0.030}});
    return mesh;
}

PolyMesh make_apple()
{
    PolyMesh mesh;
    constexpr int kSegments = 48;
    Lathe lathe(mesh, kSegments, "apple");
    lathe.smooth(kBody);
    // Closer rings in the hollows at both ends.
    std::vector<double> polars;
    for (const double p : even_angles(pi - 0.045, pi - 0.45, 8)) polars.push_back(p);
    for (const double p : even_angles(pi - 0.5, 0.85, 18)) polars.push_back(p);
    for (const double p : even_angles(0.8, 0.085, 14)) polars.push_back(p);
    const SkinRings rings = grow_skin(mesh, lathe, kSegments, apple_outline, polars);
    lathe.fan(rings.lowest, -apple_outline(pi, 0.0), false);
    stalk(lathe, kSegments, rings.highest,
          {{{0.0, 0.395, 0.0}, 0.022},
           {{0.008, 0.44, 0.0}, 0.019},
           {{0.025, 0.53, 0.006}, 0.018},
           {{0.052, 0.62, 0.014}, 0.020},
           {{0.085, 0.70, 0.02}, 0.028}});
    return mesh;
}

PolyMesh make_orange()
{
    PolyMesh mesh;
    constexpr int kSegments = 48;
    Lathe lathe(mesh, kSegments, "orange");
    const Ring top = body(mesh, lathe, kSegments, orange_outline, 34, 0.085);
    button(mesh, lathe, kSegments, top, 0.05, 0.022);
    return mesh;
}

PolyMesh make_lemon()
{
    PolyMesh mesh;
    constexpr int kSegments = 48;
    Lathe lathe(mesh, kSegments, "lemon");
    lathe.smooth(kBody);
    // The stalk's end is the lower, blunter one.
    const SkinRings rings = grow_skin(mesh, lathe, kSegments, lemon_outline, even_angles(pi - 0.05, 0.05, 38));
    lathe.fan(rings.highest, lemon_outline(0.0, 0.0), true);
    lathe.use("stalk");
    lathe.smooth(kStalk);
    const double y = mesh.points[std::size_t(rings.lowest.points[0])].y;
    const Ring end = lathe.ring(0.024, y - 0.012, -0.02);
    lathe.band(end, rings.lowest);
    lathe.fan(end, y - 0.008, false);
    return mesh;
}

PolyMesh make_kiwi()
{
    PolyMesh mesh;
    constexpr int kSegments = 44;
    Lathe lathe(mesh, kSegments, "kiwi");
    const Ring top = body(mesh, lathe, kSegments, kiwi_outline, 34, 0.06);
    button(mesh, lathe, kSegments, top, 0.033, 0.018);
    return mesh;
}

PolyMesh make_coconut()
{
    PolyMesh mesh, hollow;
    constexpr int kSegments = 52;
    Lathe lathe(mesh, kSegments, "coconut");
    const Ring top = body(mesh, lathe, kSegments, coconut_outline, 34, 0.09);
    lathe.fan(top, coconut_outline(0.0, 0.0), true);
    constexpr int kHollowSegments = 36;
    Lathe inside(hollow, kHollowSegments, "coconut hollow");
    const Ring roof = body(hollow, inside, kHollowSegments, coconut_hollow_outline, 24, 0.12);
    inside.fan(roof, coconut_hollow_outline(0.0, 0.0), true);
    add_cavity(mesh, hollow);
    return mesh;
}

}  // namespace kerf::maker
