// The bomb: an iron ball with a brass neck and a fuse.

#include <cmath>
#include <numbers>

#include "maker/fruit/fruit.h"
#include "maker/fruit/growth.h"

namespace kerf::maker {
namespace {

using std::numbers::pi;

double ball_outline(double, double)
{
    return 0.60;
}

}  // namespace

PolyMesh make_bomb()
{
    PolyMesh mesh;
    constexpr int kSegments = 40;
    Lathe lathe(mesh, kSegments, "bomb");
    lathe.smooth(1);
    const SkinRings rings = grow_skin(mesh, lathe, kSegments, ball_outline, even_angles(pi - 0.1, 0.36, 27));
    lathe.fan(rings.lowest, -0.60, false);
    // Each edge of the neck is sharp: a group of its own for every face.
    lathe.use("bomb brass");
    Ring at = rings.highest;
    int group = 2;
    const auto to = [&](double radius, double height) {
        lathe.smooth(group++);
        const Ring above = lathe.ring(radius, height, at.v + 0.06);
        lathe.band(at, above);
        at = above;
    };
    to(0.235, 0.575);
    to(0.235, 0.60);
    to(0.19, 0.612);
    to(0.19, 0.69);
    to(0.215, 0.695);
    to(0.215, 0.735);
    to(0.12, 0.74);
    to(0.075, 0.715);
    lathe.use("bomb fuse");
    lathe.smooth(group++);
    std::vector<Station> stations;
    constexpr int kSteps = 14;
    for (int k = 0; k <= kSteps; ++k) {
        const double s = double(k) / kSteps;
        // Up, over, and a little down again.
        stations.push_back(
            {{0.30 * s * s + 0.04 * std::sin(4.0 * s), 0.72 + 0.36 * std::sin(2.0 * s), 0.10 * s * std::sin(3.0 * s)},
             0.042 + 0.012 * std::pow(s, 8.0)});
    }
    const Ring end = grow_tube(lathe, kSegments, at, stations);
    lathe.smooth(group++);
    lathe.fan(end, stations.back().centre, true);
    return mesh;
}

}  // namespace kerf::maker
