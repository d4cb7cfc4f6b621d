#pragma once

#include <cstdint>

#include "common/repair/linked_surface.h"

namespace kerf::core {

/// Patches of triangles that are joined by edges with two triangles.
struct Patches
{
    Buffer<std::uint32_t> patch;  ///< for each triangle
    Buffer<std::uint8_t> flip;    ///< for each triangle whether to turn it over so that its patch agrees
};

/// Finds out which triangles of a patch face the wrong way. Each patch is flooded from its first triangle; triangles
/// that disagree with the larger part of their patch are to be turned over. Neighbours that agree come before
/// neighbours that do not, so a surface that no orientation fits (a Moebius strip) opens along edges that are
/// inconsistent already, if there are any. O(n).
Patches orient_patches(const LinkedSurface& surface);

}  // namespace kerf::core
