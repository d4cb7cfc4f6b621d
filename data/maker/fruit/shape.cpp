#include "maker/fruit/shape.h"

#include <cmath>
#include <numbers>

namespace kerf::maker {
namespace {

using std::numbers::pi;

/// A dent or a tip: 1 in the middle, `width` radians wide.
double bell(double angle, double width)
{
    return std::exp(-(angle * angle) / (width * width));
}

/// |x / a|^n + |y / b|^n = 1 in polar coordinates.
double superellipse(double polar, double a, double b, double n)
{
    return std::pow(std::pow(std::sin(polar) / a, n) + std::pow(std::abs(std::cos(polar)) / b, n), -1.0 / n);
}

}  // namespace

double watermelon_outline(double polar, double)
{
    return superellipse(polar, 0.80, 0.98, 2.0);
}

double apple_outline(double polar, double turn)
{
    // Wide shoulders, a narrow foot with five humps, a deep hollow for the stalk and a shallow one for the calyx.
    const double down = 0.5 - 0.5 * std::cos(polar);
    const double humps = 0.022 * std::cos(5.0 * turn) * down * down * std::sin(polar);
    return 0.64 * (1.0 + 0.06 * std::cos(polar) + humps - 0.50 * bell(polar, 0.42) - 0.20 * bell(pi - polar, 0.30));
}

double orange_outline(double polar, double)
{
    const double c = std::cos(polar);
    return 0.60 * (1.0 - 0.05 * c * c - 0.035 * bell(polar, 0.20) - 0.02 * bell(pi - polar, 0.16));
}

double lemon_outline(double polar, double)
{
    return superellipse(polar, 0.46, 0.60, 2.1) + 0.115 * bell(polar, 0.27) + 0.06 * bell(pi - polar, 0.24);
}

double kiwi_outline(double polar, double turn)
{
    // An oval section, 0.47 by 0.43.
    const double oval = 0.45 * (1.0 + 0.045 * std::cos(2.0 * turn));
    return superellipse(polar, oval, 0.56, 2.25) + 0.012 * bell(polar, 0.10) + 0.012 * bell(pi - polar, 0.10);
}

double coconut_outline(double polar, double turn)
{
    const double ridge = 0.012 * std::cos(3.0 * turn) * std::sin(polar);
    return 0.66 * (1.0 + 0.05 * std::cos(polar) * std::cos(polar) + 0.04 * bell(polar, 0.5) + ridge);
}

double coconut_hollow_outline(double polar, double turn)
{
    return coconut_outline(polar, turn) * 0.70;
}

double pineapple_outline(double polar, double)
{
    return superellipse(polar, 0.53, 0.74, 2.6);
}

glm::dvec3 on_outline(Outline outline, double polar, double turn)
{
    const double r = outline(polar, turn);
    return {r * std::sin(polar) * std::cos(turn), r * std::cos(polar), -r * std::sin(polar) * std::sin(turn)};
}

}  // namespace kerf::maker
