#include "tools/comparison_planes.h"

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>
#include <random>

namespace kerf::tools {

namespace {

/// core::Random numbers that are the same with every C++ library.
class Dice
{
public:
    Dice(std::uint64_t seed, std::uint64_t number)
    {
        std::seed_seq words{std::uint32_t(seed), std::uint32_t(seed >> 32), std::uint32_t(number),
                            std::uint32_t(number >> 32)};
        engine_.seed(words);
    }

    std::size_t below(std::size_t bound) { return static_cast<std::size_t>(engine_() % bound); }
    /// From -1 to 1.
    double signed_unit() { return double(engine_() >> 11) * 0x1p-52 - 1.0; }

    glm::dvec3 direction()
    {
        for (;;) {
            const double x = signed_unit(), y = signed_unit(), z = signed_unit();
            const double square = x * x + y * y + z * z;
            if (square > 1e-4 && square <= 1.0) return glm::dvec3(x, y, z) / std::sqrt(square);
        }
    }

private:
    std::mt19937_64 engine_;
};

glm::dvec3 axis(std::size_t i)
{
    glm::dvec3 direction{0.0};
    direction[static_cast<int>(i)] = 1.0;
    return direction;
}

Bounds bounds_of(const SurfaceKeys& surface)
{
    Bounds box;
    for (const SurfaceKeys::Key& key : surface.sorted())
        for (std::uint32_t i = 0; i < 3; ++i) box.add(surface.position(key, i));
    return box;
}

ChosenPlane random_plane(const SurfaceKeys& surface, Dice& dice)
{
    const Bounds box = bounds_of(surface);
    const glm::dvec3 size = glm::dvec3(box.hi) - glm::dvec3(box.lo);
    const double x = dice.signed_unit(), y = dice.signed_unit(), z = dice.signed_unit();
    const glm::dvec3 normal = dice.direction();
    // Within a quarter of the size from the middle.
    return {"random", Plane::at(Point(box.centre() + 0.25 * glm::dvec3(x, y, z) * size), Normal(normal))
                          .value_or(Plane::z(0.0).value())};
}

}  // namespace

ChosenPlane choose_plane(const SurfaceKeys& surface, PlaneMix mix, std::uint64_t number, std::uint64_t seed)
{
    Dice dice(seed, number);
    if (mix == PlaneMix::random) return random_plane(surface, dice);

    const auto any_corners = [&] {
        const SurfaceKeys::Key& key = surface.sorted()[dice.below(surface.sorted().size())];
        const auto first = static_cast<std::uint32_t>(dice.below(3));
        const auto corner = [&](std::uint32_t i) { return glm::dvec3(surface.position(key, (first + i) % 3)); };
        return std::array{corner(0), corner(1), corner(2)};
    };
    const std::array p = any_corners(), q = any_corners();
    const glm::dvec3 any = dice.direction();
    const double sign = dice.below(2) == 0 ? 1.0 : -1.0;
    const std::size_t any_axis = dice.below(3);

    const auto chosen = [&](const char* kind, const glm::dvec3& point, const glm::dvec3& normal) {
        const std::optional<Plane> plane = Plane::at(Point(point), Normal(normal));
        return plane ? ChosenPlane{kind, *plane} : random_plane(surface, dice);
    };
    if (number < 3) return chosen("axis, middle", bounds_of(surface).centre(), sign * axis(number));
    if (number == 3) return chosen("diagonal, middle", bounds_of(surface).centre(), {1, 1, 1});
    switch (number % 8) {
        case 4:
            return chosen("through a vertex", p[0], any);
        case 5:
            return chosen("along an edge", p[0], glm::cross(p[1] - p[0], any));
        case 6:
            return chosen("in a face", p[0], sign * glm::cross(p[1] - p[0], p[2] - p[0]));
        case 7:
            return chosen("axis, vertex", p[0], sign * axis(any_axis));
        case 0:
            return chosen("three vertices", p[0], glm::cross(p[1] - p[0], q[0] - p[0]));
        case 1:
            return chosen("edge and axis", p[0], glm::cross(p[1] - p[0], sign * axis(any_axis)));
        default:
            return random_plane(surface, dice);
    }
}

}  // namespace kerf::tools
