#pragma once

#include <kerf/export.h>

#include <cstdint>

// CMakeLists.txt reads the version here.

/// @addtogroup version
/// @{

#define KERF_VERSION_MAJOR 0  ///< of the headers
#define KERF_VERSION_MINOR 2  ///< of the headers; another one may change names
#define KERF_VERSION_PATCH 0  ///< of the headers; another one changes no name
#define KERF_VERSION "0.2.0"  ///< the three, with points between them

/// @}

namespace kerf {

/// @addtogroup version
/// Which library it is, and whether its results are the same.
/// @{

/// The version of the library that the program runs with; KERF_VERSION is that of the headers. Never null.
KERF_API const char* version() noexcept;

/// The version of the results' bits. The same object, plane and options give the same bytes as long as this number
/// stays: with every back end, compiler, optimisation and machine with IEEE floats. A release in which a surface, a
/// cap or a written file gets other bytes has a higher number. Whoever keeps results beside their inputs (a cache, a
/// replay, a lockstep game) keeps this number, too. A program with `caps_cgal` may close sections that
/// cross or run along themselves, or wind like a spiral, otherwise than one without it.
///
///     if (stored.bits_version != kerf::bits_version()) stored = cut_anew();
KERF_API std::uint32_t bits_version() noexcept;

/// @}

}  // namespace kerf
