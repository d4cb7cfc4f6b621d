#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "common/drawings/drawing.h"
#include "common/files/byte_sink.h"

namespace kerf::core::drawings {

/// A drawing as SVG 1.1, in millimetres at true scale: a group for each layer, a path for each shape, whose holes are
/// left out by the even-odd rule.
void write_svg(io::ByteSink& file, const Drawing& drawing);
/// As DXF R12, in millimetres: a polyline for each path, in the layers OUTER, HOLES and CHAINS, at the height of its
/// section.
void write_dxf(io::ByteSink& file, const Drawing& drawing);
/// As OBJ: a line for each path, in space, in the mesh's own unit.
void write_obj_lines(io::ByteSink& file, const Drawing& drawing);

/// Writes the file, by its extension; it appears complete or not at all. Throws io::FileError.
void write_drawing(const std::filesystem::path& path, const Drawing& drawing);
/// The same bytes in memory. `format` is an extension without the dot.
std::string drawing_bytes(const Drawing& drawing, std::string_view format);

/// The shortest decimal number that is the same float, as coordinates of meshes are; without a sign if it is 0. What a
/// float has no room for is written as a double.
std::string number_text(double value);

}  // namespace kerf::core::drawings
