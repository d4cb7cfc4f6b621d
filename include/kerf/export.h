#pragma once

/// @addtogroup version
/// @{

/// @def KERF_API
/// Stands before each name that a shared library shows. Programs that link static libraries define KERF_STATIC; the
/// CMake package and pkg-config do it for them.

/// @}

#if defined(KERF_STATIC)
#define KERF_API
#elif defined(_WIN32)
#if defined(KERF_BUILDING)
#define KERF_API __declspec(dllexport)
#else
#define KERF_API __declspec(dllimport)
#endif
#else
#define KERF_API [[gnu::visibility("default")]]
#endif
