#pragma once

// The outlines of the fruit, seen from the middle. viewer/render/shaders/fruit_*.glsl draw flesh inside the same
// outlines and name the same numbers: keep them equal.

#include <glm/vec3.hpp>

namespace kerf::maker {

/// Distance of the skin from the middle in a direction, `polar` radians from the +y axis and `turn` radians about it
/// (the angle of Lathe::at(): 0 at +x, growing towards -z). Metres.
using Outline = double (*)(double polar, double turn);

double watermelon_outline(double polar, double turn);
double apple_outline(double polar, double turn);
double orange_outline(double polar, double turn);
double lemon_outline(double polar, double turn);
double kiwi_outline(double polar, double turn);
double coconut_outline(double polar, double turn);
double coconut_hollow_outline(double polar, double turn);
double pineapple_outline(double polar, double turn);  ///< without its eyes

/// The place on the skin.
glm::dvec3 on_outline(Outline outline, double polar, double turn);

}  // namespace kerf::maker
