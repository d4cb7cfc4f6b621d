#pragma once

#include <kerf/export.h>

#include <cstddef>

namespace kerf {

/// @addtogroup back_ends
/// The ways to cut that a build has.
/// @{

/// How objects are cut.
enum class BackEnd : unsigned char
{
    /// `halfedge` if it is built and `cuts_expected` cuts pay its preparing back, otherwise `linear`.
    automatic = 0,
    /// A loop over all triangles. Prepares in O(1); each cut costs O(n). Best for one cut or two.
    linear = 1,
    /// A tree and a walk over neighbours. Prepares in 50 to 100 ns a triangle; each cut costs what its section costs.
    halfedge = 2,
};

/// What there is to say of a back end.
struct BackEndFacts
{
    const char* name = "";         ///< "halfedge", "linear"; lives as long as the program
    bool closes_with_fan = false;  ///< its caps fit star-shaped sections only
    bool is_quadratic = false;     ///< a cut of n triangles costs O(n^2)
};

/// How many back ends there are: those of the build, the best for many cuts first, and those that the program has
/// added. Complete once main() has begun.
///
///     for (std::size_t i = 0; i < kerf::back_end_count(); ++i) offer(kerf::back_end(i).name);
///
/// The one that is chosen goes into PrepareOptions::back_end_name.
KERF_API std::size_t back_end_count() noexcept;
/// Back end i, or one without a name.
KERF_API BackEndFacts back_end(std::size_t i) noexcept;
/// The back end of that name, or one without a name. A name without its second part means the first that begins so:
/// "baseline" is "baseline/hash".
KERF_API BackEndFacts find_back_end(const char* name) noexcept;

/// @}

}  // namespace kerf
