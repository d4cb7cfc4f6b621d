// The pineapple: a body with eyes in two families of spirals, and a crown of leaves that grow out of its stalk.

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>

#include "maker/fruit/fruit.h"
#include "maker/fruit/growth.h"

namespace kerf::maker {
namespace {

using std::numbers::pi;

constexpr int kSegments = 72, kStalkSegments = 12;
constexpr double kEyeHeight = 0.030;

/// How high the eye stands at a place of the skin, 0 in the grooves to 1: 8 spirals one way, 13 the other.
/// shaders/fruit_pineapple.glsl draws the same lattice over the texture coordinates.
double eye(double u, double v)
{
    const double a = 8.0 * u + 3.2 * v, b = 13.0 * u - 5.0 * v;
    return std::sqrt(std::abs(std::sin(pi * a) * std::sin(pi * b)));
}

/// One turn of points on the bare body.
struct Course
{
    double polar, v;
};

/// A leaf: starts at `from` along `out`, bends up or down by `bend` radians over its length.
void leaf(PolyMesh& mesh, const Ring& lower, const Ring& upper, int i, double rise, double bend, double length,
          double half_width)
{
    const std::size_t n = lower.points.size();
    const auto at = [&](const Ring& ring, std::size_t k) { return mesh.points[std::size_t(ring.points[k % n])]; };
    const std::size_t middle = std::size_t(i) + 1;
    const glm::dvec3 base = 0.5 * (at(lower, middle) + at(upper, middle));
    const glm::dvec3 out = glm::normalize(glm::dvec3{base.x, 0, base.z}), y{0, 1, 0};
    std::vector<LeafStation> stations;
    glm::dvec3 place = base;
    constexpr int kSteps = 6;
    for (int k = 0; k < kSteps; ++k) {
        const double share = double(k) / kSteps, angle = rise + bend * share * share;
        const glm::dvec3 along = out * std::cos(angle) + y * std::sin(angle);
        const glm::dvec3 up = y * std::cos(angle) - out * std::sin(angle);
        place += along * (length / (kSteps + 0.5) * (k == 0 ? 0.5 : 1.0));
        const double taper = std::pow(1.0 - share, 0.8) * (0.8 + 0.6 * std::sin(pi * std::min(1.0, share + 0.15)));
        // Six leaves share a row: none is wider than its sixth.
        const double width = std::min(half_width * taper, 0.5 * std::hypot(place.x, place.z) - 0.006);
        stations.push_back({place, up, width, 0.013 * (1.0 - 0.7 * share), 0.3 * width});
    }
    const double angle = rise + bend;
    const glm::dvec3 tip = place + (out * std::cos(angle) + y * std::sin(angle)) * (length / kSteps);
    grow_leaf(mesh, lower, upper, i, stations, tip, "pineapple crown", 3);
}

}  // namespace

PolyMesh make_pineapple()
{
    PolyMesh mesh;
    Lathe lathe(mesh, kSegments, "pineapple");
    lathe.smooth(1);
    std::vector<Course> courses;
    double v = 0.0;
    const std::vector<double> polars = even_angles(pi - 0.16, 0.26, 42);
    for (std::size_t k = 0; k < polars.size(); ++k) {
        if (k > 0)
            v += glm::distance(on_outline(pineapple_outline, polars[k], 0),
                               on_outline(pineapple_outline, polars[k - 1], 0));
        courses.push_back({polars[k], v});
    }
    Ring lowest, top;
    for (std::size_t k = 0; k < courses.size(); ++k) {
        const double polar = courses[k].polar;
        const double at_v = courses[k].v;
        const double calm = std::min({1.0, 6.0 * at_v, 6.0 * (v - at_v)});
        const Ring ring = lathe.ring(
            [&](int i) {
                const double turn = 2.0 * pi * i / kSegments;
                const glm::dvec3 p = on_outline(pineapple_outline, polar, turn);
                return p + glm::normalize(p) * (kEyeHeight * calm * (eye(double(i) / kSegments, at_v) - 0.5));
            },
            at_v);
        if (k == 0)
            lowest = ring;
        else
            lathe.band(top, ring);
        top = ring;
    }
    lathe.fan(lowest, -pineapple_outline(pi, 0.0) + 0.01, false);

    // The crown's stalk has fewer sides: every sixth point of the top goes on.
    const double height = pineapple_outline(0.0, 0.0);
    Lathe crown(mesh, kStalkSegments, "pineapple crown");
    crown.smooth(2);
    Ring below = crown.ring(0.155, height + 0.01, 0.0);
    for (int i = 0; i < kStalkSegments; ++i) {
        const int a = below.points[std::size_t(i)], b = below.points[std::size_t((i + 1) % kStalkSegments)];
        constexpr int kStep = kSegments / kStalkSegments;
        for (int k = 0; k < kStep; ++k) {
            const int at = i * kStep + k;
            const int p = top.points[std::size_t(at)], q = top.points[std::size_t((at + 1) % kSegments)];
            const double u0 = double(at) / kSegments, u1 = double(at + 1) / kSegments;
            mesh.add_facet({p, q, k < kStep / 2 ? a : b}, "pineapple", {{u0, v}, {u1, v}, {0.5 * (u0 + u1), v + 0.1}},
                           1);
            if (k == kStep / 2 - 1)
                mesh.add_facet({q, b, a}, "pineapple", {{u1, v}, {u1 + 0.04, v + 0.1}, {u0 - 0.04, v + 0.1}}, 1);
        }
    }
    struct Row
    {
        double rise, bend, length, half_width;
    };
    const std::array<Row, 6> rows{{{0.30, -0.75, 0.44, 0.062},
                                   {0.62, -0.70, 0.56, 0.066},
                                   {0.90, -0.60, 0.66, 0.064},
                                   {1.14, -0.42, 0.70, 0.058},
                                   {1.32, -0.28, 0.70, 0.050},
                                   {1.45, -0.14, 0.64, 0.040}}};
    double y = height + 0.01;
    for (std::size_t row = 0; row < rows.size(); ++row) {
        y += 0.045;
        const Ring above = crown.ring(0.155 - 0.018 * double(row + 1), y, 0.05 * double(row + 1));
        const int start = row % 2 == 0 ? 0 : 1;
        for (int i = start; i < kStalkSegments + start; i += 2)
            leaf(mesh, below, above, i % kStalkSegments, rows[row].rise, rows[row].bend, rows[row].length,
                 rows[row].half_width);
        below = above;
        // A bare stretch between two rows keeps their leaves apart.
        y += 0.02;
        const Ring bare = crown.ring(0.155 - 0.018 * double(row + 1) - 0.004, y, 0.05 * double(row + 1) + 0.02);
        crown.band(below, bare);
        below = bare;
    }
    crown.fan(below, y + 0.5, true);
    return mesh;
}

}  // namespace kerf::maker
