#pragma once

#include <kerf/io.h>
#include <kerf/section.h>

namespace kerf {

/// @addtogroup sections
/// @{

/// A unit of length.
enum class LengthUnit : unsigned char
{
    millimetre = 0,
    centimetre = 1,
    metre = 2,
    inch = 3,
    foot = 4,
};

/// "mm", "cm", "m", "in" or "ft"; "mm" for a number that is none of them. Never null.
KERF_API const char* text(LengthUnit unit) noexcept;
/// Millimetres in a unit.
KERF_API double millimetres(LengthUnit unit) noexcept;

/// Options of drawings.
struct DrawingOptions
{
    LengthUnit unit = LengthUnit::millimetre;  ///< of the mesh: files are in millimetres, at true scale
};

/// Writes sections as lines: SVG, DXF (R12) or OBJ, by the extension. They are seen from the positive side of their
/// planes, in their frames. SVG has a group for each section, and a path for each outer loop, whose holes are left
/// out by the even-odd rule (filled, or, of several sections, as contours); DXF a polyline for each loop or chain, in
/// the layers OUTER, HOLES and CHAINS, several sections above one another; OBJ lines in space, in the mesh's unit. A
/// loop is a hole of the loop around it, so that sections must have been found with SectionOptions::nesting. The file
/// appears complete or not at all. Component `io`. O(k).
/// Status: `unusable_file` (a format that is not written, a folder that is not there, a full disk), `invalid_argument`
/// (no section with a path, a null path), `out_of_memory`.
KERF_API Outcome write_drawing(std::span<const Section> sections, const char* path,
                               const DrawingOptions& options = {}) noexcept;

/// The bytes that write_drawing() writes, with its statuses.
///
///     const kerf::Section section = kerf::section(object, plane);
///     const kerf::Result<kerf::FileBytes> svg = kerf::drawing_bytes({&section, 1}, "svg");
///
/// @param format  an extension without the dot
KERF_API Result<FileBytes> drawing_bytes(std::span<const Section> sections, const char* format,
                                         const DrawingOptions& options = {}) noexcept;

/// @}

}  // namespace kerf
