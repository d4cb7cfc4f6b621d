#pragma once

// The floating point that both back ends rely on to agree bit for bit; docs/floating-point.md explains the rules. The
// headers of planes, turns, mass moments and the range of float include this one.

#include <cfloat>
#include <limits>

#ifdef __FAST_MATH__
#error "Kerf needs IEEE arithmetic as written: compile without -ffast-math"
#endif

static_assert(std::numeric_limits<float>::is_iec559 && std::numeric_limits<double>::is_iec559);
static_assert(FLT_EVAL_METHOD == 0, "float and double expressions must not be evaluated in a wider type");
