#pragma once

// What a shared library shows to the programs that link it.

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
