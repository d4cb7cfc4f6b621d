#pragma once

#include <span>
#include <string_view>
#include <utility>

#include "viewer/render/surface_look.h"

namespace kerf::render {

using NamedLook = std::pair<std::string_view, SurfaceLook>;

/// What the fruit of data/fruit look like from outside, by material name.
std::span<const NamedLook> fruit_skins();

/// What a cut through them uncovers, by the name of the skin's material.
std::span<const NamedLook> fruit_flesh();

/// The shader files of a fruit's pattern; empty for other patterns.
std::span<const std::string_view> fruit_shaders_of(Pattern pattern);

}  // namespace kerf::render
