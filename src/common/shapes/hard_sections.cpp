#include "common/shapes/hard_sections.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <map>
#include <numbers>

#include "common/shapes/corner_grid.h"
#include "common/shapes/shapes.h"
#include "common/support/random.h"

namespace kerf::core::shapes {

namespace {

Plane across(int axis, double offset)
{
    Plane plane;
    plane.normal = glm::dvec3(0.0);
    plane.normal[axis] = 1.0;
    plane.offset = offset;
    return plane;
}

/// The side of a square of at least n cells.
std::uint32_t square_side(std::uint32_t n)
{
    return std::max(1u, static_cast<std::uint32_t>(std::ceil(std::sqrt(double(n)))));
}

TriangleSoup block(const glm::vec3& centre, const glm::vec3& size, bool is_cavity)
{
    TriangleSoup soup = box(size, {1, 1, 1});
    translate(soup, centre);
    if (is_cavity) turn_inside_out(soup);
    return soup;
}

/// A plate in x and y from (0, 0) to (size, size), and some more around it.
TriangleSoup plate(std::uint32_t size)
{
    const float side = static_cast<float>(size);
    return block({side / 2, side / 2, 0}, {side + 4, side + 4, 2}, false);
}

HardSection bricks(std::uint32_t n)
{
    const std::uint32_t side = square_side(n);
    TriangleSoup soup = plate(side);
    for (std::uint32_t i = 0; i < n; ++i) {
        const std::uint32_t row = i / side;
        const float shift = row % 2 == 0 ? 0.25f : 0.75f;
        append(soup, block({float(i % side) + shift, float(row) + 0.5f, 0}, {0.875f, 1, 1}, true));
    }
    return {std::move(soup), across(2, 0.125)};
}

HardSection checkerboard(std::uint32_t n)
{
    const std::uint32_t side = square_side(2 * n);
    TriangleSoup soup = plate(side);
    for (std::uint32_t y = 0; y < side; ++y)
        for (std::uint32_t x = y % 2; x < side; x += 2)
            append(soup, block({float(x) + 0.5f, float(y) + 0.5f, 0}, {1, 1, 1}, true));
    return {std::move(soup), across(2, 0.125)};
}

HardSection pores(std::uint32_t n)
{
    const std::uint32_t side = square_side(n);
    TriangleSoup soup = plate(side);
    for (std::uint32_t i = 0; i < n; ++i) {
        const std::uint32_t x = i % side, y = i / side;
        append(soup, block({float(x) + 0.5f, float(y) + 0.5f, 0}, {0.5f, 0.5f, 1}, true));
    }
    return {std::move(soup), across(2, 0.125)};
}

HardSection loose_parts(std::uint32_t n)
{
    const std::uint32_t side = square_side(n);
    TriangleSoup soup;
    for (std::uint32_t i = 0; i < n; ++i) {
        const std::uint32_t x = i % side, y = i / side;
        append(soup, block({float(x), float(y), 0}, {0.5f, 0.5f, 1}, false));
    }
    return {std::move(soup), across(2, 0.125)};
}

/// A tooth has eight triangles that a plane along it crosses.
TriangleSoup comb_of_points(std::uint32_t n)
{
    return comb(std::max(1u, n / 8));
}

HardSection leaning_comb(std::uint32_t n)
{
    TriangleSoup soup = comb_of_points(n);
    float width = 0.0f;
    for (const Vertex& v : soup.vertices) width = std::max(width, 2.0f * v.position.x);
    for (Vertex& v : soup.vertices) v.position.x += 0.5f * width * v.position.y;
    return {std::move(soup), across(2, 0.03)};
}

HardSection hidden_pores(std::uint32_t n)
{
    TriangleSoup soup = comb(n);
    // comb(): teeth of 0.2 every 0.4, from y = -0.2 to 0.5.
    const double first = 0.1 - 0.1 * (2.0 * n - 1.0);
    for (std::uint32_t i = 0; i < n; ++i)
        append(soup, block({float(first + 0.4 * i), 0.25f, 0}, {0.0625f, 0.0625f, 0.0625f}, true));
    return {std::move(soup), across(1, 0.01)};
}

HardSection nested_shells(std::uint32_t n)
{
    constexpr double kLargest = 1.0, kSmallest = 0.1;
    std::vector<float> radii;
    for (std::uint32_t i = 0; i < n; ++i)
        radii.push_back(static_cast<float>(kLargest - (kLargest - kSmallest) * i / std::max(1u, n)));
    return {nested_spheres(radii, 2), across(2, 0.013)};
}

HardSection rosette(std::uint32_t n)
{
    constexpr float kWave = 0.25f, kDepth = -2.0f;
    TriangleSoup soup;
    soup.has_normals = false;
    const auto add = [&](const glm::vec3& p) { soup.vertices.push_back({p, {0, 0, 1}, {0, 0}}); };
    add({0, 0, 0});
    add({0, 0, kDepth});
    const std::uint32_t rim = 2 * std::max(n, 2u);
    for (std::uint32_t i = 0; i < rim; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / rim;
        add({float(std::cos(angle)), float(std::sin(angle)), i % 2 == 0 ? kWave : -kWave});
    }
    for (std::uint32_t i = 0; i < rim; ++i) {
        const std::uint32_t a = 2 + i, b = 2 + (i + 1) % rim;
        soup.triangles.push_back({0, a, b});
        soup.triangles.push_back({1, b, a});
    }
    return {std::move(soup), across(2, 0.0)};
}

HardSection spiral(std::uint32_t n)
{
    constexpr std::uint32_t kTurns = 50;
    return {spiral_wall(float(kTurns), std::max(3u, n / (4 * kTurns))), across(2, 0.01)};
}

/// From tips at (0, 0, 1) and (0, 0, -1) to a rim; each wedge keeps to its own angle.
template <class Rim>
TriangleSoup double_cone(std::uint32_t n, Rim radius_and_height)
{
    TriangleSoup soup;
    soup.has_normals = false;
    const std::uint32_t rim = std::max(n, 3u);
    const auto add = [&](const glm::vec3& p) { soup.vertices.push_back({p, {0, 0, 1}, {0, 0}}); };
    add({0, 0, 1});
    add({0, 0, -1});
    for (std::uint32_t i = 0; i < rim; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / rim;
        const auto [radius, height] = radius_and_height(i);
        add({float(radius * std::cos(angle)), float(radius * std::sin(angle)), height});
    }
    for (std::uint32_t i = 0; i < rim; ++i) {
        const std::uint32_t a = 2 + i, b = 2 + (i + 1) % rim;
        soup.triangles.push_back({0, a, b});
        soup.triangles.push_back({1, b, a});
    }
    return soup;
}

constexpr double kPastTheTip = 1.0 - 0x1p-52;

HardSection tip(std::uint32_t n)
{
    return {double_cone(n, [](std::uint32_t) { return std::pair(1.0, 0.0f); }),
            *Plane::through({0, 0, kPastTheTip}, {-0.94371573, -0.19737820, -0.26540999})};
}

HardSection toothed_tip(std::uint32_t n)
{
    return {double_cone(n - n % 2,
                        [](std::uint32_t i) { return i % 2 == 0 ? std::pair(1e-3, 0.5f) : std::pair(1.0, 0.0f); }),
            *Plane::through({0, 0, kPastTheTip}, {1.0, 0.001, 0.01})};
}

/// A comb along x, a beam above its teeth. The lower right corner of each tooth is folded over by less than the
/// difference of two of its coordinates can tell in double.
HardSection touches(std::uint32_t n)
{
    constexpr float kTouch = 0x1p-66f;
    constexpr std::array<glm::vec2, 7> kTooth{
        {{0, 1}, {0, 0}, {0.5f, kTouch}, {0.5f, 0}, {0.375f, 0.125f}, {0.625f, 1}, {0, 2}}};
    constexpr std::uint32_t kTop = 6, kPoints = 7, kSectionPoints = 14;
    const std::uint32_t teeth = std::max(1u, n / kSectionPoints);
    // Counter-clockwise: along the teeth, and back along the beam's top.
    std::vector<std::uint32_t> outline;
    for (std::uint32_t tooth = 0; tooth < teeth; ++tooth)
        for (std::uint32_t i = 0; i < kTop; ++i) outline.push_back(kPoints * tooth + i);
    for (std::uint32_t tooth = teeth; tooth-- > 0;) outline.push_back(kPoints * tooth + kTop);
    std::vector<Triangle> inside;
    for (std::uint32_t tooth = 0; tooth < teeth; ++tooth) {
        const std::uint32_t first = kPoints * tooth, next = first + kPoints;
        for (std::uint32_t i = 1; i + 1 < kTop; ++i) inside.push_back({first, first + i, first + i + 1});
        inside.push_back({first, first + 5, first + kTop});
        if (tooth + 1 == teeth) continue;
        inside.push_back({first + 5, next, next + kTop});
        inside.push_back({first + 5, next + kTop, first + kTop});
    }

    TriangleSoup soup;
    soup.has_normals = false;
    for (const float z : {-0.5f, 0.5f})
        for (std::uint32_t tooth = 0; tooth < teeth; ++tooth)
            for (const glm::vec2& p : kTooth)
                soup.vertices.push_back({{p.x + float(tooth), p.y, z}, {0, 0, 1}, {0, 0}});
    const std::uint32_t above = kPoints * teeth;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const std::uint32_t a = outline[i], b = outline[(i + 1) % outline.size()];
        soup.triangles.push_back({a, b, b + above});
        soup.triangles.push_back({a, b + above, a + above});
    }
    for (const Triangle& t : inside) {
        soup.triangles.push_back({t[0] + above, t[1] + above, t[2] + above});
        soup.triangles.push_back({t[0], t[2], t[1]});
    }
    return {std::move(soup), across(2, 0.0)};
}

void append_tetrahedron(TriangleSoup& soup, const glm::vec3& a, const glm::vec3& b, const glm::vec3& c,
                        const glm::vec3& d)
{
    const auto first = static_cast<std::uint32_t>(soup.vertices.size());
    for (const glm::vec3& p : {a, b, c, d}) soup.vertices.push_back({p, {0, 0, 1}, {0, 0}});
    for (const Triangle& t : {Triangle{0, 2, 1}, Triangle{0, 1, 3}, Triangle{0, 3, 2}, Triangle{1, 2, 3}})
        soup.triangles.push_back({first + t[0], first + t[1], first + t[2]});
}

HardSection stack(std::uint32_t n)
{
    TriangleSoup soup;
    for (std::uint32_t i = 0; i < n; ++i) {
        const float size = 1.0f + float(i) / 1024.0f;
        append_tetrahedron(soup, {0, 0, 0}, {size, 0, 0}, {0, size, 0}, {0, 0, size});
    }
    return {std::move(soup), *Plane::through({0.1, 0.2, 0.53}, {0.01, 0.02, 1.0})};
}

HardSection wedges(std::uint32_t n)
{
    TriangleSoup soup;
    const auto at = [&](double turn) {
        const double angle = 2.0 * std::numbers::pi * turn / n;
        return glm::vec3(std::cos(angle), std::sin(angle), 0.5);
    };
    for (std::uint32_t i = 0; i < n; ++i) append_tetrahedron(soup, {0, 0, 0}, {0, 0, 1}, at(i), at(i + 0.5));
    return {std::move(soup), *Plane::through({0.1, 0.2, 0.53}, {0.01, 0.02, 1.0})};
}

/// A plate with a top of n triangles at z = 0.5, and a ridge along one edge that reaches above it.
TriangleSoup ridged_plate(std::uint32_t n)
{
    constexpr float kTop = 0.5f, kRidgeFrom = 0.95f, kRidge = 1.0f;
    const std::uint32_t side = square_side(n / 2);
    TriangleSoup soup = box({2, 2, 1}, {side, side, 1});
    for (Vertex& v : soup.vertices)
        if (v.position.z == kTop && v.position.x > kRidgeFrom) v.position.z = kRidge;
    return soup;
}

HardSection flat_rough(std::uint32_t n)
{
    constexpr float kTop = 0.5f, kUnit = 0x1p-24f;
    HardSection section{ridged_plate(n), across(2, 0.5)};
    for (Vertex& v : section.soup.vertices) {
        if (v.position.z != kTop) continue;
        // By position, so that vertices at one place stay together.
        const auto bits = std::uint64_t(std::bit_cast<std::uint32_t>(v.position.x)) << 32 |
                          std::bit_cast<std::uint32_t>(v.position.y);
        v.position.z += kUnit * float(int(Random::mix(bits) % 7) - 3);
    }
    return section;
}

HardSection flat_tilted(std::uint32_t n)
{
    return {ridged_plate(n), *Plane::through({0.01, 0.0, 0.5}, {1e-7, 0.0, 1.0})};
}

const std::map<std::string, HardSection (*)(std::uint32_t), std::less<>>& makers()
{
    static const std::map<std::string, HardSection (*)(std::uint32_t), std::less<>> all{
        {"bricks", bricks},
        {"checkerboard", checkerboard},
        {"comb",
         [](std::uint32_t n) {
             return HardSection{comb_of_points(n), across(2, 0.03)};
         }},
        {"flat",
         [](std::uint32_t n) {
             return HardSection{ridged_plate(n), across(2, 0.5)};
         }},
        {"flat_rough", flat_rough},
        {"flat_tilted", flat_tilted},
        {"hidden_pores", hidden_pores},
        {"leaning_comb", leaning_comb},
        {"loose_parts", loose_parts},
        {"nested_shells", nested_shells},
        {"pores", pores},
        {"rosette", rosette},
        {"spiral", spiral},
        {"stack", stack},
        {"teeth",
         [](std::uint32_t n) {
             return HardSection{comb(n), across(1, 0.1)};
         }},
        {"tip", tip},
        {"toothed_tip", toothed_tip},
        {"touches", touches},
        {"wedges", wedges},
    };
    return all;
}

}  // namespace

const std::vector<std::string>& hard_section_names()
{
    static const std::vector<std::string> names = [] {
        std::vector<std::string> all;
        for (const auto& [name, make] : makers()) all.push_back(name);
        return all;
    }();
    return names;
}

std::optional<HardSection> hard_section(std::string_view name, std::uint32_t n)
{
    const auto found = makers().find(name);
    if (found == makers().end()) return std::nullopt;
    return found->second(std::max(n, 1u));
}

}  // namespace kerf::core::shapes
