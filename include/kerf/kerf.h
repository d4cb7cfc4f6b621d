#pragma once

/// @file
/// All of the library that needs no component but the cut itself. Files are in kerf/io.h, drawings of sections in
/// kerf/drawing.h, stand-ins for physics in
/// kerf/proxy.h, generated meshes in kerf/shapes.h.

#include <kerf/back_ends.h>
#include <kerf/cut.h>
#include <kerf/dice.h>
#include <kerf/draw.h>
#include <kerf/fracture.h>
#include <kerf/mass.h>
#include <kerf/mesh.h>
#include <kerf/object.h>
#include <kerf/plane.h>
#include <kerf/section.h>
#include <kerf/statistics.h>
#include <kerf/status.h>
#include <kerf/version.h>
