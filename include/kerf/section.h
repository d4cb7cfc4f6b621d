#pragma once

#include <kerf/cut.h>
#include <kerf/draw.h>
#include <kerf/object.h>

#include <optional>
#include <span>

namespace kerf {

/// @addtogroup sections
/// What a plane meets of an object that stays as it is.
/// @{

/// Options of section().
struct SectionOptions
{
    bool nesting = true;  ///< find for each loop the one that it lies in; `fill` finds them in any case
    bool fill = false;    ///< the triangles that close the section: what the cap of a cut would be
    CapQuality fill_quality = CapQuality::fast;  ///< of those triangles
    bool attributes = false;                     ///< normals, uvs and streams along the outline (SectionPath::ends)
    /// The direction in space that points upwards in the section's frame, as far as it lies in the plane; of any length
    /// but 0. If it is not set, z points upwards, and y in planes that are nearly level (their normal is within 26
    /// degrees of z).
    std::optional<Vec3d> up;
};

/// Where an edge of a section comes from: of two triangles, if it is an edge of the mesh in the plane, from the one that
/// a cut would keep on the negative side.
struct SectionEdge
{
    std::uint32_t source = kNone;  ///< the input triangle that it lies in (MeshArrays::sources); kNone in a cap
    std::uint32_t material = 0;    ///< its number in Object::material()
};

/// A closed loop of a section, or a chain that ends at holes of the mesh. Edge i leads from point i to the next one, and
/// the last edge of a loop to its first point. Seen from the plane's positive side an outer loop runs counter-clockwise,
/// and a hole clockwise.
struct SectionPath
{
    std::span<const Vec3f> points;       ///< in mesh coordinates; of a chain one more than edges
    std::span<const SectionEdge> edges;  ///< in the order of the points
    /// With SectionOptions::attributes: of edge i the two ends, at 2 i and 2 i + 1, with the normal and uv of the surface
    /// there, as a cut gives them to its vertices. Two edges that meet at a seam differ where they meet.
    std::span<const DrawVertex> ends;
    std::size_t first_edge = 0;  ///< how many edges the paths before it have
    double area = 0.0;           ///< enclosed, in the mesh's unit, squared; negative of a hole, 0 of a chain
    double length = 0.0;         ///< in the mesh's unit
    /// Number of the smallest loop around it, or kNone: a hole lies in an outer loop, and what stands in the hole lies
    /// in the hole. None of chains, and without SectionOptions::nesting.
    std::uint32_t parent = kNone;
    std::uint32_t solid = 0;  ///< number of the solid that it bounds: paths of one solid have the same
    bool is_closed = true;    ///< false of a chain
};

/// Coordinates in a plane: two axes of length 1, and a right angle between them. Seen from the plane's positive side x
/// points to the right if y points upwards.
struct KERF_API SectionFrame
{
    Vec3d origin;         ///< the place of the plane that is nearest to the origin of space
    Vec3d x;              ///< direction of the first axis
    Vec3d y;              ///< direction of the second axis
    Vec3d normal;         ///< of the plane
    double height = 0.0;  ///< signed distance of the plane from the origin of space, along the normal

    /// The place in the plane that is nearest to a point, in the mesh's unit.
    Vec2d to_plane(Vec3d point) const noexcept;
    /// Where a place of the plane lies in space.
    Vec3d to_space(Vec2d place) const noexcept;
};

/// What a plane meets of an object. To use one again saves its memory. One thread at a time.
///
///     kerf::Section section;
///     for (const kerf::Plane& plane : planes)
///         if (ok(kerf::section(object, plane, section))) draw(section);
struct [[nodiscard]] KERF_API Section
{
    Status status = Status::missed;        ///< section() lists them
    Side side_of_object = Side::negative;  ///< of a miss: the side that the object lies on
    double area = 0.0;                     ///< enclosed by all loops, holes taken away; in the mesh's unit, squared
    double length = 0.0;                   ///< of all loops and chains, in the mesh's unit
    /// Centre of the enclosed area; of the outline, if nothing is enclosed. The origin of a section without points.
    Vec3d centroid;
    Box bounds;          ///< around all paths; empty of a section without points
    SectionFrame frame;  ///< coordinates in the plane
    /// A warning: the triangles overlap, because the section crosses itself or winds backwards.
    bool fill_exceeds_section = false;

    /// Why there is none, in one sentence; "" if there is one, or the plane missed. Never null; valid for ever.
    const char* reason() const noexcept;

    std::size_t path_count() const noexcept;  ///< loops and chains
    /// An empty one if there is none of that number. Its points and edges live until the section is filled again or
    /// ends.
    SectionPath path(std::size_t i) const noexcept;

    /// All points, path by path. With SectionOptions::fill those follow where loops cross one another. Valid as those of
    /// a path.
    std::span<const Vec3f> points() const noexcept;
    /// With SectionOptions::fill: three numbers of points() for each triangle, counter-clockwise seen from the positive
    /// side. Valid as those of a path.
    std::span<const std::uint32_t> triangles() const noexcept;

    /// With SectionOptions::attributes: the streams of the mesh along the outline. Values for two ends of each edge, path
    /// by path; those of a path begin with the end 2 * SectionPath::first_edge. Valid as those of a path, and none (an
    /// empty one) if there is none of that number.
    /// @{
    std::size_t stream_count() const noexcept;
    Stream stream(std::size_t i) const noexcept;
    /// @}

    /// What it has cost: crossing triangles, loops, chains, and what was looked at.
    const CutStatistics& statistics() const noexcept;

    /// One without paths; what is moved from is such a one.
    /// @{
    Section() noexcept;
    Section(Section&& other) noexcept;
    Section& operator=(Section&& other) noexcept;
    /// @}
    ~Section();

    /// @cond For the library itself.
    struct Data;
    /// @endcond

private:
    friend struct SectionMaker;
    Data* data_ = nullptr;
    const char* refusal_ = "";  ///< what reason() says of an invalid argument
};

/// What a plane, in the object's own coordinates, meets of it. The object does not change, so that any number of threads
/// may ask at once. The loops and chains are those that a cut would have, bit for bit, and those of all back ends have
/// the same edges.
///
/// Half-edge back end: O(s log n + k) for a section of k triangles in s leaves of the tree, without caps and nesting;
/// linear: O(n). Nested loops, and triangles that close them, cost O(k log k) more.
/// Status: `done`; `open_section` if the mesh has holes there; `missed` where a cut would miss; `invalid_argument` (an
/// empty object, a direction `up` without a length, a quality of caps that this program does not have);
/// `out_of_memory`. All but the first two have no paths.
KERF_API Section section(const Object& object, const Plane& plane, const SectionOptions& options = {}) noexcept;

/// The same, into a section that was used before: it keeps its memory.
KERF_API Status section(const Object& object, const Plane& plane, Section& section,
                        const SectionOptions& options = {}) noexcept;

/// Options of sections().
struct StackOptions
{
    SectionOptions section;  ///< of each
    /// Threads that may work at them, the caller's among them; 0: as many as the processor has. The sections are the
    /// same, whatever the number. If no thread is to be had, the caller's does it alone.
    std::uint32_t threads = 1;
    /// Called now and then from the thread that asks, with the share that is done: 0 first, 1 last. Returns false to
    /// stop; sections() then says `cancelled`. Must not throw: that ends the program. May be null.
    bool (*progress)(void* user, double share) = nullptr;
    void* user = nullptr;  ///< for `progress`
};

/// The sections of an object by parallel planes. To use one again saves its memory. One thread at a time.
///
///     const double heights[] = {0.1, 0.2, 0.3};
///     const kerf::SectionStack stack = kerf::sections(object, kerf::Normal(0, 0, 1), heights);
///     for (const kerf::Section& section : stack.all()) std::printf("%g\n", section.area);
class [[nodiscard]] KERF_API SectionStack
{
public:
    Status status() const noexcept { return status_; }  ///< sections() lists them
    /// Why there are none, in one sentence; "" if there are. Never null; valid for ever.
    const char* reason() const noexcept;
    /// In the order of the heights that were asked for; each has a status of its own. Valid until the stack is filled
    /// again or ends.
    std::span<const Section> all() const& noexcept;
    /// Not of a stack that nobody keeps: its sections would be gone before they are looked at.
    std::span<const Section> all() const&& = delete;

    /// One without sections; what is moved from is such a one.
    /// @{
    SectionStack() noexcept;
    SectionStack(SectionStack&& other) noexcept;
    SectionStack& operator=(SectionStack&& other) noexcept;
    /// @}
    ~SectionStack();

    /// @cond For the library itself.
    struct Data;
    /// @endcond

private:
    friend struct StackMaker;
    Data* data_ = nullptr;
    Status status_ = Status::done;
    const char* refusal_ = "";  ///< what reason() says of an invalid argument
};

/// The back end that finds one stack of sections of a mesh sooner, preparing counted: for PrepareOptions::back_end. `linear`
/// until the planes together cross about as many triangles as the mesh has, then `halfedge`, if it is built. Looks at some
/// thousand triangles: O(h log h) for h heights. `linear` if an argument means nothing to sections(), or there is no memory.
///
///     kerf::PrepareOptions options;
///     options.back_end = kerf::quicker_for_sections(mesh, kerf::Normal(0, 0, 1), heights);
KERF_API BackEnd quicker_for_sections(const Mesh& mesh, Normal normal, std::span<const double> heights) noexcept;

/// What parallel planes meet of an object: those across `normal` at some heights, which are signed distances from the
/// origin along the normal, in the mesh's unit and any order. Each section is what section() gives. A section at which
/// the plane misses has the status `missed`.
///
/// Half-edge back end: as much as section() for each, on each thread. Linear: one sweep, O(n log h + k) for h heights and k
/// pairs of a height and a triangle that it meets, so that a mesh that is asked for one stack need not be prepared for more.
/// quicker_for_sections() says which is quicker.
/// Status: `done`; `invalid_argument` (as section(), a normal without a direction, a height that is not finite);
/// `cancelled`; `out_of_memory`. All but the first have no sections.
KERF_API SectionStack sections(const Object& object, Normal normal, std::span<const double> heights,
                               const StackOptions& options = {}) noexcept;

/// The same, into a stack that was used before: it keeps its memory.
KERF_API Status sections(const Object& object, Normal normal, std::span<const double> heights, SectionStack& stack,
                         const StackOptions& options = {}) noexcept;

/// @}

}  // namespace kerf
