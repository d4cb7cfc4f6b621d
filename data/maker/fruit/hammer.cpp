// The hammer: a banana for a handle, and a steel head where its stalk was.

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <numbers>

#include "maker/fruit/banana.h"
#include "maker/fruit/fruit.h"

namespace kerf::maker {
namespace {

using std::numbers::pi;

// shaders/fruit_hammer.glsl knows these numbers.
constexpr double kHandle = 0.64;  ///< share of the banana's axis where the head begins
constexpr double kCollar = 0.05;  ///< height of the collar below the head
constexpr double kLength = 0.41;  ///< half the head's length, along the banana's bend
constexpr double kSide = 0.20;    ///< half the side of its two faces
constexpr double kWaist = 0.85;   ///< of that in the middle

constexpr double kCollarRadius = 0.138;
constexpr double kHammerBevel = 0.024;

/// How thick the head is at a place along it, as a share.
double flare(double u)
{
    const double t = std::clamp((std::abs(u) / kLength - 0.40) / 0.30, 0.0, 1.0);
    return kWaist + (1.0 - kWaist) * t * t * (3.0 - 2.0 * t);
}

/// Point i of a rectangle with bevelled corners, its points closer together at the corners; turns as the banana does.
glm::dvec2 on_rectangle(int i, double half_length, double half_width)
{
    constexpr int kQuarter = kBananaSegments / 4;
    const double inner = half_length - kHammerBevel - 0.03;
    const std::array<glm::dvec2, kQuarter + 1> quarter{{
        {half_length, 0},
        {half_length, 0.5 * half_width},
        {half_length, half_width - kHammerBevel},
        {half_length - kHammerBevel, half_width},
        {inner, half_width},
        {inner * 5 / 6, half_width},
        {inner * 4 / 6, half_width},
        {inner * 3 / 6, half_width},
        {inner * 2 / 6, half_width},
        {inner * 1 / 6, half_width},
        {0, half_width},
    }};
    const int turn = i / kQuarter, rest = i % kQuarter;
    const glm::dvec2 p = quarter[std::size_t(turn % 2 == 0 ? rest : kQuarter - rest)];
    return {turn == 0 || turn == 3 ? p.x : -p.x, turn < 2 ? p.y : -p.y};
}

/// Makes the head ring by ring, upwards from the handle.
class Head
{
public:
    Head(Lathe& lathe, const Ring& handle) : lathe_(lathe), at_(handle) {}

    void make()
    {
        group(3);
        add([](int i) { return lifted(circle(i), 0.006); });
        group(4);
        add([](int i) { return lifted(circle(i), kCollar); });
        group(5);
        // The lower side, from the collar to the rim.
        for (const double share : {0.35, 0.7, 1.0})
            add([=](int i) { return glm::mix(lifted(circle(i), kCollar), at_level(inset(i), -1.0), share); });
        group(6);
        constexpr double kSteep = 1.0 - kHammerBevel / kSide;
        add([](int i) { return at_level(outline(i), -kSteep); });
        group(7);
        for (const double level : {-0.5, 0.0, 0.5, kSteep}) add([=](int i) { return at_level(outline(i), level); });
        group(8);
        add([](int i) { return at_level(inset(i), 1.0); });
        group(9);
        for (const double share : {0.66, 0.33}) add([=](int i) { return at_level(share * inset(i), 1.0); });
        lathe_.fan(at_, placed(at_level({0, 0}, 1.0)), true);
    }

private:
    /// Along the head, sideways, and above the end of the handle.
    static glm::dvec3 placed(const glm::dvec3& p)
    {
        const BananaAxis axis = banana_axis(kHandle);
        return axis.place + p.x * axis.inwards + p.y * glm::dvec3{0, 0, 1} + p.z * axis.along;
    }
    static glm::dvec2 circle(int i)
    {
        const double turn = 2.0 * pi * i / kBananaSegments;
        return {kCollarRadius * std::cos(turn), kCollarRadius * std::sin(turn)};
    }
    static glm::dvec2 outline(int i) { return on_rectangle(i, kLength, kSide); }
    static glm::dvec2 inset(int i) { return on_rectangle(i, kLength - kHammerBevel, kSide - kHammerBevel); }
    static glm::dvec3 lifted(const glm::dvec2& p, double height) { return {p.x, p.y, height}; }
    /// @param level  -1: lower side, 1: upper side
    static glm::dvec3 at_level(const glm::dvec2& p, double level)
    {
        const double middle = kCollar + kWaist * kSide;
        return {p.x, p.y * flare(p.x), middle + level * kSide * flare(p.x)};
    }

    void group(int smoothing) { lathe_.smooth(smoothing); }
    template <class Point>
    void add(Point point)
    {
        const Ring above = lathe_.ring([&](int i) { return placed(point(i)); }, at_.v + 0.05);
        lathe_.band(at_, above);
        at_ = above;
    }

    Lathe& lathe_;
    Ring at_;
};

}  // namespace

PolyMesh make_hammer()
{
    PolyMesh mesh;
    Lathe lathe(mesh, kBananaSegments, "hammer");
    const SkinRings handle = grow_banana(lathe, kHandle);
    close_flowers_end(lathe, handle.lowest);
    Head(lathe, handle.highest).make();
    return mesh;
}

}  // namespace kerf::maker
