// Pawn, rook, bishop, queen and king, in Staunton's pattern: turned on a lathe, then carved.

#include <algorithm>
#include <array>
#include <cmath>

#include "maker/chess.h"
#include "maker/lathe.h"
#include "maker/models.h"

namespace kerf::maker {
namespace {

/// Foot, plinth and waist that all pieces share, 12 bands, up to a stem of radius `stem` at `height`.
Profile foot(double stem, double height)
{
    Profile profile = chess_base();
    const double rise = height - 0.62;
    profile.curve({{0.6, 0.62 + 0.12 * rise}, {stem + 0.08, 0.62 + 0.45 * rise}, {stem, height}}, 5);
    return profile;
}

}  // namespace

Profile chess_base()
{
    Profile profile(0.97, 0.0);
    profile.line(1.0, 0.04).line(1.0, 0.16).arc(0.9, 0.46, 0.55, 3).line(0.78, 0.5).line(0.74, 0.62);
    return profile;
}

PolyMesh make_pawn()
{
    PolyMesh mesh;
    Lathe lathe(mesh, 18, "ivory");
    Profile profile = foot(0.3, 1.55);
    profile.line(0.54, 1.68).line(0.58, 1.76).line(0.3, 1.86);  // collar
    profile.arc(0.17, 2.79, 0.62, 9);                           // ball
    const Ring bottom = lathe.ring(profile.points()[0].radius, 0.0, 0.0);
    lathe.disc(bottom, false);
    lathe.fan(lathe.turn(bottom, profile), 2.83, true);
    mesh.fit(1.6);
    return mesh;
}

PolyMesh make_rook()
{
    constexpr int kSegments = 20, kMerlons = 5, kShare = kSegments / kMerlons;
    PolyMesh mesh;
    Lathe lathe(mesh, kSegments, "ivory");
    Profile profile = foot(0.5, 1.75);
    profile.line(0.64, 1.86).line(0.56, 2.0).arc(0.8, 2.3, -0.35, 2).line(0.8, 2.52);
    const Ring bottom = lathe.ring(profile.points()[0].radius, 0.0, 0.0);
    lathe.disc(bottom, false);
    const Ring outer = lathe.turn(bottom, profile);
    constexpr double kInnerRadius = 0.54, kCrenel = 2.52, kTop = 2.86, kBevel = 0.05, kBowl = 2.34;
    const Ring inner = lathe.ring(kInnerRadius, kCrenel, outer.v + 0.26),
               bowl = lathe.ring(kInnerRadius - 0.03, kBowl, outer.v + 0.44);
    lathe.disc(bowl, true);
    lathe.band(inner, bowl);

    // Each merlon stands on two of four segments; between two merlons the wall's top is bare.
    const auto bare = [](int i) { return i % kShare >= kShare / 2; };
    lathe.band(outer, inner, bare);
    for (int m = 0; m < kMerlons; ++m) {
        const int first = m * kShare, middle = first + 1, last = first + 2;
        // Six corners round the merlon, counter-clockwise from above: along the outer wall, back along the inner one.
        const auto round = [&](double r_in, double r_out, double height, double margin) {
            std::vector<int> loop;
            for (const int i : {first, middle, last})
                loop.push_back(mesh.add_point(lathe.at(r_out, height, i + (middle - i) * margin)));
            for (const int i : {last, middle, first})
                loop.push_back(mesh.add_point(lathe.at(r_in, height, i + (middle - i) * margin)));
            return loop;
        };
        const auto ring_point = [](const Ring& ring, int i) { return ring.points[std::size_t(i % kSegments)]; };
        std::vector<int> foot_loop;
        for (const int i : {first, middle, last}) foot_loop.push_back(ring_point(outer, i));
        for (const int i : {last, middle, first}) foot_loop.push_back(ring_point(inner, i));
        const std::vector<int> edge = round(kInnerRadius, 0.8, kTop - kBevel, 0.0);
        const std::vector<int> top = round(kInnerRadius + kBevel, 0.8 - kBevel, kTop, 0.17);
        for (std::size_t k = 0; k < 6; ++k) {
            const std::size_t n = (k + 1) % 6;
            mesh.add_facet({foot_loop[k], foot_loop[n], edge[n], edge[k]}, "ivory");
            mesh.add_facet({edge[k], edge[n], top[n], top[k]}, "ivory");
        }
        mesh.add_facet({top[0], top[1], top[4], top[5]}, "ivory");
        mesh.add_facet({top[1], top[2], top[3], top[4]}, "ivory");
        const int gap = first + 3;
        mesh.split_edge(ring_point(outer, gap), ring_point(inner, gap));
    }
    mesh.fit(1.8);
    return mesh;
}

PolyMesh make_queen()
{
    PolyMesh mesh;
    constexpr int kSegments = 20;
    Lathe lathe(mesh, kSegments, "ivory");
    Profile profile = foot(0.32, 2.1);
    profile.line(0.58, 2.2).line(0.62, 2.27).line(0.34, 2.38);  // collar
    profile.curve({{0.39, 2.8}, {0.6, 3.15}}, 3);
    const Ring bottom = lathe.ring(profile.points()[0].radius, 0.0, 0.0);
    lathe.fan(bottom, 0.05, false);
    const Ring neck = lathe.turn(bottom, profile);

    // The coronet: every second segment is a valley between two points.
    const auto zigzag = [&](double radius, double valley, double peak) {
        return [&lathe, radius, valley, peak](int i) { return lathe.at(radius, i % 2 == 0 ? peak : valley, i); };
    };
    const Ring rim = lathe.ring(zigzag(0.71, 3.28, 3.46), neck.v + 0.3);
    const Ring inside = lathe.ring(zigzag(0.55, 3.26, 3.42), neck.v + 0.46);
    lathe.band(neck, rim);
    for (std::size_t peak = 0; peak < kSegments; peak += 2) {
        const int tip = mesh.add_point(lathe.at(0.67, 3.58, double(peak)));
        const std::size_t after = (peak + 1) % kSegments, before = (peak + kSegments - 1) % kSegments;
        const auto add = [&](int a, int b) { mesh.add_facet({a, b, tip}, "ivory"); };
        add(rim.points[before], rim.points[peak]);
        add(rim.points[peak], rim.points[after]);
        add(rim.points[after], inside.points[after]);
        add(inside.points[after], inside.points[peak]);
        add(inside.points[peak], inside.points[before]);
        add(inside.points[before], rim.points[before]);
    }
    Profile crown(0.55, 3.3);
    crown.line(0.46, 3.2).line(0.14, 3.4).arc(0.1, 3.78, 0.95, 3);  // bowl, dome, ball
    lathe.fan(lathe.turn(inside, crown), 3.83, true);
    mesh.fit(2.3);
    return mesh;
}

PolyMesh make_king()
{
    PolyMesh mesh;
    Lathe lathe(mesh, 20, "ivory");
    Profile profile = foot(0.34, 2.2);
    profile.line(0.6, 2.3).line(0.64, 2.37).line(0.36, 2.5);  // collar
    profile.curve({{0.46, 2.9}, {0.65, 3.3}}, 3).line(0.69, 3.4).line(0.6, 3.46).arc(0.24, 3.66, 0.25, 2);
    const Ring bottom = lathe.ring(profile.points()[0].radius, 0.0, 0.0);
    lathe.fan(bottom, 0.05, false);
    const Ring top = lathe.turn(bottom, profile);

    // A cross pattee, 12 corners, from the stem's right foot round; front and back are joined by its sides.
    const std::array<Profile::Point, 6> right{
        {{0.13, 3.66}, {0.065, 3.92}, {0.3, 3.83}, {0.3, 4.15}, {0.065, 4.06}, {0.16, 4.36}}};
    constexpr double kHalfDepth = 0.09;
    std::vector<int> front, back;
    const auto add = [&](double x, double y) {
        front.push_back(mesh.add_point({x, y, kHalfDepth}));
        back.push_back(mesh.add_point({x, y, -kHalfDepth}));
    };
    for (const auto& p : right) add(p.radius, p.height);
    for (std::size_t i = right.size(); i-- > 0;) add(-right[i].radius, right[i].height);
    mesh.add_facet(front, "ivory");
    mesh.add_facet(reversed(back), "ivory");
    for (std::size_t i = 0; i + 1 < front.size(); ++i)
        mesh.add_facet({front[i + 1], front[i], back[i], back[i + 1]}, "ivory");
    bridge(mesh, top.points, {back.front(), back.back(), front.back(), front.front()}, "ivory");
    mesh.fit(2.5);
    return mesh;
}

}  // namespace kerf::maker
