// The bishop: the rings of its mitre lean over until two of them are the lips of the slot.

#include <algorithm>
#include <cmath>

#include "maker/chess.h"
#include "maker/lathe.h"
#include "maker/models.h"

namespace kerf::maker {
namespace {

constexpr int kSegments = 18;

/// The mitre's own profile, fine enough to be looked up by height.
double mitre_radius(double height)
{
    static const Profile profile = [] {
        Profile p(0.3, 2.3);
        p.curve({{0.47, 2.48}, {0.53, 2.72}, {0.42, 3.04}, {0.26, 3.28}, {0.1, 3.46}}, 256);
        return p;
    }();
    const auto& points = profile.points();
    const auto above = std::lower_bound(points.begin() + 1, points.end() - 1, height,
                                        [](const Profile::Point& p, double h) { return p.height < h; });
    const auto below = above - 1;
    const double t = (height - below->height) / (above->height - below->height);
    return below->radius + t * (above->radius - below->radius);
}

/// The point of the mitre at `segment` in the plane height = `level` + `slope` x, by bisection.
glm::dvec3 on_mitre(const Lathe& lathe, double level, double slope, int segment)
{
    double lo = 2.3, hi = 3.46;
    for (int k = 0; k < 60; ++k) {
        const double middle = 0.5 * (lo + hi);
        const double x = lathe.at(mitre_radius(middle), middle, segment).x;
        (middle < level + slope * x ? lo : hi) = middle;
    }
    return lathe.at(mitre_radius(lo), lo, segment);
}

}  // namespace

PolyMesh make_bishop()
{
    PolyMesh mesh;
    Lathe lathe(mesh, kSegments, "ivory");
    Profile profile = chess_base();
    profile.curve({{0.56, 0.78}, {0.36, 1.25}, {0.28, 1.95}}, 6);
    profile.line(0.54, 2.05).line(0.58, 2.12).line(0.36, 2.2).line(0.42, 2.26).line(0.3, 2.3);  // two collars
    const Ring bottom = lathe.ring(profile.points()[0].radius, 0.0, 0.0);
    lathe.fan(bottom, 0.05, false);
    Ring below = lathe.turn(bottom, profile);

    // Heights of each ring at the mitre's back (-x) and front, where the slot opens.
    struct Level
    {
        double back, front;
    };
    constexpr Level kLevels[] = {{2.335, 2.44}, {2.365, 2.58}, {2.395, 2.72}, {2.43, 2.86}, {2.47, 2.98},
                                 {2.60, 3.11},  {2.78, 3.20},  {2.97, 3.28},  {3.17, 3.36}, {3.38, 3.41}};
    constexpr std::size_t kLowerLip = 4;
    constexpr int kHalfWidth = 4;  // the slot goes through this many segments to either side of +x
    Ring lip;
    for (std::size_t k = 0; k < std::size(kLevels); ++k) {
        const Level& level = kLevels[k];
        const double reach = mitre_radius(level.back),
                     slope = (level.front - level.back) / (reach + mitre_radius(level.front));
        const Ring above =
            lathe.ring([&](int i) { return on_mitre(lathe, level.back + slope * reach, slope, i); }, below.v + 0.12);
        const bool slot = k == kLowerLip + 1;
        lathe.band(below, above, [&](int i) { return !slot || (i >= kHalfWidth && i < kSegments - kHalfWidth); });
        if (slot) {
            // Walls from both lips straight in to the chord between the slot's ends, and a floor between the chords.
            std::vector<int> low_lip, high_lip, low_floor, high_floor;
            constexpr int kWidth = 2 * kHalfWidth;
            for (int j = 0; j <= kWidth; ++j) {
                const auto i = std::size_t((j - kHalfWidth + kSegments) % kSegments);
                low_lip.push_back(below.points[i]);
                high_lip.push_back(above.points[i]);
            }
            const auto chord = [&](const std::vector<int>& edge) {
                std::vector<int> floor{edge.front()};
                const glm::dvec3 a = mesh.points[std::size_t(edge.front())], b = mesh.points[std::size_t(edge.back())];
                for (std::size_t j = 1; j < kWidth; ++j) {
                    // Straight in along x.
                    const double t = (mesh.points[std::size_t(edge[j])].z - a.z) / (b.z - a.z);
                    floor.push_back(mesh.add_point(a + (b - a) * t));
                }
                floor.push_back(edge.back());
                return floor;
            };
            low_floor = chord(low_lip);
            high_floor = chord(high_lip);
            for (std::size_t j = 0; j < kWidth; ++j) {
                mesh.add_facet({low_lip[j], low_lip[j + 1], low_floor[j + 1], low_floor[j]}, "ivory");
                mesh.add_facet({low_floor[j], low_floor[j + 1], high_floor[j + 1], high_floor[j]}, "ivory");
                mesh.add_facet({high_floor[j], high_floor[j + 1], high_lip[j + 1], high_lip[j]}, "ivory");
            }
        }
        below = above;
    }
    Profile finial(0.1, 3.42);
    finial.line(0.09, 3.47).arc(0.07, 3.7, 0.95, 3);
    lathe.fan(lathe.turn(below, finial), 3.73, true);
    mesh.fit(2.1);
    return mesh;
}

}  // namespace kerf::maker
