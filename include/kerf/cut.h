#pragma once

#include <kerf/object.h>
#include <kerf/statistics.h>

#include <optional>

namespace kerf {

/// @addtogroup cutting
/// An object and a plane become pieces.
/// @{

/// Which triangles close a section. All use each of its points, and add none but where it crosses itself.
enum class CapQuality : unsigned char
{
    /// Those that are found in the shortest time; with and without CGAL the same, unless a section crosses itself. Many
    /// are needles, which no eye sees on a flat cap.
    fast = 0,
    /// A constrained Delaunay triangulation, of the section seen along the coordinate axis that is nearest to the plane's
    /// normal: no needles but where the outline forces them, for caps that are solved on, or refined. This phase takes
    /// three to six times as long. Needs the component caps_cgal: has_cap_quality().
    delaunay = 1,
};

/// Whether this program can close sections so: by `fast` always, by `delaunay` with CGAL's triangulation. O(1), from
/// any thread.
KERF_API bool has_cap_quality(CapQuality quality) noexcept;

/// A part of a section, found by a point in the object's own coordinates: that path of it which is nearest to the point,
/// and what belongs to the path.
struct OnlyNear
{
    /// What belongs to the path.
    enum class Extent : unsigned char
    {
        region = 0,  ///< an outer loop with the holes right in it, or a chain
        solid = 1,   ///< all paths of one solid (SectionPath::solid)
    };
    Vec3d point;                     ///< in the mesh's unit
    Extent extent = Extent::region;  ///< what is cut of the section
};

/// Options of cut().
struct CutOptions
{
    bool cap = true;                     ///< close the section; false leaves it open
    bool components = false;             ///< each side as its connected pieces, not as one object
    std::uint32_t cap_material = kNone;  ///< of the caps; a number that the object lacks: one is added, "cap"
    double cap_uv_scale = 1.0;           ///< uv of a cap for each unit of length, along two axes of the plane
    /// Width of the blade, in the mesh's unit: what lies within half of it on either side is taken away. 0 takes
    /// nothing.
    double gap = 0.0;
    CapQuality cap_quality = CapQuality::fast;  ///< the fan of the report's slicer knows only that
    /// If it is set, cut there alone: one leg of two, one tooth of a comb. The rest stays whole, bit for bit, and goes to
    /// the side of what it is connected with; a solid that the plane crosses elsewhere goes to the negative side. Status
    /// `not_separated`, and the object stays as it is, if what lies on both sides of that cut is connected elsewhere: a ring
    /// does not come apart by one cut. Costs a cut and a section more; linear back ends cut three times. Not with a gap.
    std::optional<OnlyNear> only;
};

/// What became of an object.
struct [[nodiscard]] KERF_API Cut
{
    Status status = Status::missed;  ///< cut() lists them
    /// Of a miss: the side that the object lies on.
    Side side_of_object = Side::negative;
    /// The object itself, if it was not cut; otherwise empty.
    Object object;
    /// Area of the section: what its closed loops enclose, in the mesh's unit, squared. With a gap that of the positive
    /// side's section, or of the negative one's if that is the only one.
    double section_area = 0.0;
    /// A warning: caps overlap, because the section crosses itself or winds backwards, or because the build has no way
    /// to close it exactly. Caps are closed all the same, and have the section's signed area.
    bool caps_exceed_section = false;

    /// Why it was not cut, in one sentence; "" if it was, or was missed. Never null; valid for ever.
    const char* reason() const noexcept;

    /// How many pieces a side has.
    std::size_t count(Side side) const noexcept;
    /// Piece i of a side; null beyond the last.
    ///
    ///     for (std::size_t i = 0; kerf::Object* piece = cut.piece(kerf::Side::positive, i); ++i)
    ///         keep(std::move(*piece));
    Object* piece(Side side, std::size_t i) noexcept;
    /// The piece of a side with the most triangles, empty if it was moved from; null if nothing is there. Without
    /// CutOptions::components there is one piece at most.
    ///
    ///     if (kerf::Object* top = cut.one(kerf::Side::positive)) keep(std::move(*top));
    Object* one(Side side) noexcept;
    /// What the cut, or the miss, has cost; with a gap, that of both cuts. All 0 for what is not an object.
    const CutStatistics& statistics() const noexcept;

    /// One without pieces; what is moved from is such a one.
    /// @{
    Cut() noexcept;
    Cut(Cut&& other) noexcept;
    Cut& operator=(Cut&& other) noexcept;
    /// @}
    ~Cut();

    /// @cond For the library itself.
    struct Data;
    Data* data() const noexcept { return data_; }
    /// @endcond

private:
    friend struct CutMaker;
    Data* data_ = nullptr;
    const char* refusal_ = "";  ///< what reason() says of an invalid argument
};

/// What became of a cut in one word, for logs and files: "cut", "missed", "open_section", ... Never null.
KERF_API const char* outcome_name(Status status) noexcept;

/// Cuts an object by a plane, in the object's own coordinates, and consumes it; it comes back in `Cut::object` if it
/// was not cut. The same object and plane give the same bytes in every run (kerf/version.h: bits_version()).
///
/// Half-edge back end: O(s log n + k) for a section of k triangles in s leaves of the tree; linear: O(n).
/// Status: `done`, `open_section`, `missed`, `invalid_argument` (an empty object, a gap or a scale that is not finite,
/// a gap below 0, a quality of caps that this program does not have, a point of `only` that is not finite, or `only` with a gap),
/// `not_separated`, `out_of_memory`. All but the first two leave the object as it was, but for a gap, below.
///
/// A gap cuts twice: what is above it goes to the positive side, what is below to the negative one, and what is left
/// is thrown away; that may be all of the object, and then the status is `done` without a piece. If memory runs out in
/// the second cut, the status is `out_of_memory` and the pieces of the first one are there.
KERF_API Cut cut(Object&& object, const Plane& plane, const CutOptions& options = {}) noexcept;

/// The same, and the object stays: a copy of it is cut, O(n) more. `Cut::object` is always empty.
KERF_API Cut cut_copy(const Object& object, const Plane& plane, const CutOptions& options = {}) noexcept;

/// @}

}  // namespace kerf
