#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "common/caps/cap_quality.h"
#include "common/cutting/buffer_identity.h"
#include "common/cutting/plane_section.h"
#include "common/cutting/progress.h"
#include "common/cutting/statistics.h"
#include "common/cutting/status.h"
#include "common/mesh/indexed_mesh.h"
#include "common/mesh/mass_properties.h"
#include "common/mesh/plane.h"
#include "common/mesh/side.h"
#include "common/mesh/support_directions.h"
#include "common/repair/proven_mesh.h"

// The contract of the back ends: a Backend prepares an IndexedMesh into a Cuttable; cut() turns a Cuttable into the
// fragments on both sides of a plane, each a Cuttable again. What the result is, bit for bit, is in
// docs/cutting-rules.md.

namespace kerf::core {

/// A polyline of the section, in mesh coordinates. Seen from the plane's positive side an outer loop runs
/// counter-clockwise and a hole clockwise. The last point is not repeated.
struct SectionLoop
{
    std::vector<glm::vec3> points;
    bool closed = true;  ///< false: a chain that ends at the boundary of an open mesh
};

/// A run of the index buffer that is drawn with one material.
struct DrawRange
{
    std::uint32_t first_index = 0;
    std::uint32_t index_count = 0;
    std::uint32_t material = 0;  ///< index into DrawView::materials
    TriangleKind kind = TriangleKind::surface;
};

/// A stream in the vertex buffer's order.
struct StreamView
{
    std::string_view name;
    std::uint32_t width = 1;        ///< floats for each vertex
    std::span<const float> values;  ///< width for each vertex of the view
};

/// A run of bytes inside a buffer.
struct ByteRange
{
    std::uint64_t offset = 0;
    std::uint64_t size = 0;
};

/// What to draw of an object, and what to upload first. Valid until the object is cut, compacted, detached or
/// destroyed, whatever becomes of its relatives meanwhile: what it shows never moves and never changes.
struct DrawView
{
    std::uint64_t buffers = 0;               ///< a serial number, never used again; equal ones are the same buffers
    std::span<const Vertex> vertices;        ///< the whole vertex buffer
    std::span<const std::uint32_t> indices;  ///< the whole index buffer
    std::vector<DrawRange> ranges;           ///< sorted by kind and material, adjacent runs merged
    std::span<const Material> materials;
    std::vector<StreamView> streams;
    std::vector<ByteRange> new_vertex_bytes;  ///< of the vertex buffer, not yet given to mark_uploaded()
    std::vector<ByteRange> new_index_bytes;   ///< of the index buffer, not yet given to mark_uploaded()
};

/// The material that fills a section when the user names none: "cap", or "cap.1" and so on if the surface has one of
/// that name.
inline constexpr std::uint32_t kDefaultCapMaterial = std::numeric_limits<std::uint32_t>::max();

/// Whether this program can close sections so: by `delaunay` with CGAL's ways alone. O(1), from any thread.
bool can_close(CapQuality quality) noexcept;

/// A part of a section, found by a point: the path of it that is nearest, and what belongs to that.
struct OnlyNear
{
    enum class Extent : std::uint8_t
    {
        region,  ///< an outer loop with the holes right in it, or a chain
        solid,   ///< all paths of one solid
    };
    glm::dvec3 point{0.0};
    Extent extent = Extent::region;
};

struct CutOptions
{
    bool build_caps = true;         ///< close the section
    bool split_components = false;  ///< each side comes as its connected pieces, otherwise as one fragment a side
    /// Index into the object's materials. One that does not exist means the default: a material named "cap", which is
    /// added once.
    std::uint32_t cap_material = kDefaultCapMaterial;
    double cap_uv_scale = 1.0;                  ///< uv of caps for each mesh unit (PlaneFrame)
    CapQuality cap_quality = CapQuality::fast;  ///< the fan of the report's back ends knows only that
    /// If it is set, the object is cut there alone. The rest stays whole: what the plane crosses there goes to one side
    /// with what it is connected with, and a solid that is not cut at all but crosses the plane to the negative one. The
    /// status is `not_separated` if what lies on both sides of the cut is connected elsewhere.
    std::optional<OnlyNear> only = std::nullopt;
};

struct CutResult;
class Breakable;

/// The sections of an object by parallel planes: what they have in common was found once. Any number of threads may ask at
/// the same time, as long as the object stays as it is.
class StackSearch
{
public:
    virtual ~StackSearch() = default;
    /// Fills `section`, which is clear, for the plane of that number. May throw std::bad_alloc.
    virtual void find(std::size_t number, PlaneSection& section) const = 0;

protected:
    StackSearch() = default;
    StackSearch(const StackSearch&) = default;
    StackSearch& operator=(const StackSearch&) = default;
};

/// An object that can be cut: a prepared mesh or a fragment of one.
///
/// Threads. Objects that share buffers (shares_buffers_with()) are relatives: fragments of one prepare() or clone(), pieces
/// of one Breakable, but for those that were detached or compacted since. All others are strangers. To *read* an object is to call a
/// const member or section(), or to hand it to one (the `other` of shares_buffers_with()); to *change* it is cut(), compact(),
/// detach(), mark_uploaded() or its end. While one thread is at an object, another thread may do this to the same
/// object, a relative or a stranger:
///
/// | one thread                | another thread              | same object | relative     | stranger |
/// |---------------------------|-----------------------------|-------------|--------------|----------|
/// | reads                     | reads                       | yes         | yes          | yes      |
/// | reads                     | changes                     | no          | yes, in turn | yes      |
/// | changes                   | changes                     | no          | yes, in turn | yes      |
/// | uses what a DrawView says | reads                       | yes         | yes          | yes      |
/// | uses what a DrawView says | changes, but does not cut   | no          | yes          | yes      |
/// | uses what a DrawView says | cuts                        | no          | yes          | yes      |
///
/// "In turn": inside, one waits until the other is done; readers wait for nobody but a change. To cut an object that
/// another thread is at is the caller's error, because it is gone then. What a relative's cut adds to the buffers is
/// news of the next view: mark_uploaded() is told which view was uploaded. A pointer to an object is handed from thread
/// to thread as any other. Which relatives are cut when changes no byte of to_indexed_mesh(); it changes where things
/// lie in the buffers, and CutStatistics::bytes_grown.
class Cuttable
{
public:
    virtual ~Cuttable() = default;

    /// An independent copy that shares nothing. Costs a copy, not a prepare. May run on a worker thread.
    virtual std::unique_ptr<Cuttable> clone() const = 0;

    virtual std::uint64_t triangle_count() const = 0;
    virtual Box bounds() const = 0;

    virtual DrawView draw_view() const = 0;
    /// Declares that all bytes which a view of this object or a relative named as new are on the GPU now. Views may
    /// come in any order; one of buffers that the object no longer has changes nothing.
    virtual void mark_uploaded(const DrawView& view) = 0;

    /// Of the closed solid. The sums are about the centre of the object's bounds, or no less precise than such sums.
    virtual MassProperties mass_properties() const = 0;
    /// The extreme vertex in each support direction, as core::support_points() defines it. O(log n) for ordinary shapes
    /// with the half-edge back end, O(n) with the baseline.
    virtual std::array<glm::vec3, kSupportDirections> support_points() const = 0;
    /// The vertices that the object uses, each once: its own, or `room`, which is filled then. Valid as long as both.
    /// O(n).
    virtual std::span<const Vertex> used_vertices(std::vector<Vertex>& room) const = 0;

    /// The outline of the last cut on this fragment, with the chains of an open section; empty before any cut.
    virtual std::span<const SectionLoop> section_loops() const = 0;

    /// What programs remember of an object: pieces and copies have what it had.
    struct Memory
    {
        const char* back_end = "";  ///< a name that lives as long as the program
        bool is_of_solid = false;   ///< the mesh was closed, and so is each cut since
    };
    Memory memory;

    /// plane_noise() of the mesh that was prepared, in its unit: pieces have that of the whole, so that all back ends agree on
    /// what misses them.
    virtual double noise() const = 0;
    virtual void set_noise(double noise) = 0;

    /// Valid until one is added or the object ends.
    virtual std::span<const Material> materials() const = 0;
    /// Appends a material, for caps of later cuts, and returns its index. Relatives that have the same buffers don't
    /// have it, but its index is not given again. Throws std::bad_alloc.
    virtual std::uint32_t add_material(const Material& material) = 0;

    /// A compact copy: only what the fragment uses, dense point ids. O(n).
    virtual IndexedMesh to_indexed_mesh() const = 0;

    /// For many sections by parallel planes with this normal, of unit length, and these offsets. Null: to ask for one after
    /// the other costs no more. May throw std::bad_alloc and Cancelled.
    virtual std::unique_ptr<StackSearch> search_stack(const glm::dvec3& /*normal*/, std::span<const double> /*offsets*/,
                                                      const ProgressOfStep& /*progress*/) const
    {
        return nullptr;
    }

    /// A copy of the object that can be broken without a look at all of its triangles, or null: it is broken as a mesh. O(n)
    /// to copy memory. May throw std::bad_alloc.
    virtual std::unique_ptr<Breakable> breakable() const;

    /// Whether many cuts have scattered the object over shared buffers, so that compact() is worth its time.
    virtual bool wants_compaction() const { return false; }
    /// Moves the object into buffers of its own that hold nothing else; to_indexed_mesh() keeps its bytes, and
    /// everything is to be uploaded again. O(n): for when nothing waits. Throws std::bad_alloc, and the object is
    /// unchanged then. To keep it off the critical path clone() the object on a worker thread, compact the clone there
    /// and put it in the object's place, if that was not cut meanwhile.
    virtual void compact() {}

    /// Whether two objects, also of different back ends, are relatives; each is its own. O(1).
    bool shares_buffers_with(const Cuttable& other) const noexcept { return buffers() == other.buffers(); }
    /// Makes the object a stranger to all others: it can then be cut while they are drawn, and drawn while they are
    /// cut. Calls compact() if it has relatives. Never throws.
    ///
    /// @return  `done` if it shares nothing, `out_of_memory` if it could not be copied and is unchanged
    Status detach() noexcept;

protected:
    Cuttable() = default;
    Cuttable(const Cuttable&) = default;
    Cuttable& operator=(const Cuttable&) = default;

private:
    friend CutResult cut(std::unique_ptr<Cuttable> object, const Plane& plane, const CutOptions& options);
    friend Status section(const Cuttable& object, const Plane& plane, PlaneSection& section) noexcept;

    /// Cuts by a valid plane. With status `done` or `open_section` the fragments are in the result and the object is
    /// spent; with any other status, or an exception, the object is as it was. `CutResult::object` is not set.
    virtual CutResult cut_by(const Plane& plane, const CutOptions& options) = 0;

    /// Fills `section`, which is clear, for a valid plane. May throw std::bad_alloc.
    virtual void find_section(const Plane& plane, PlaneSection& section) const = 0;

    /// DrawView::buffers, from a BufferIdentity (cutting/buffer_identity.h).
    virtual std::uint64_t buffers() const noexcept = 0;
    /// Whether some other object has the same buffers.
    virtual bool has_relatives() const noexcept { return false; }
};

/// What became of an object.
struct CutResult
{
    Status status = Status::missed;
    std::unique_ptr<Cuttable> object;                 ///< the object itself, unless it was cut
    std::vector<std::unique_ptr<Cuttable>> positive;  ///< fragments with signed_distance >= 0
    std::vector<std::unique_ptr<Cuttable>> negative;  ///< fragments with signed_distance < 0
    /// Of a miss: where the object lies. One within plane_noise of the plane lies on the negative side.
    Side side_of_object = Side::negative;
    /// Signed sum of the closed loops' areas, mesh units squared: what caps should cover. 0 of a miss.
    double section_area = 0.0;
    /// A warning: the caps are closed and have the section's signed area, but some of their triangles are turned over,
    /// and others lie on those. There are three causes: the section winds around something backwards (the surface runs
    /// through itself inside out, or is open); it crosses itself too often to be untangled; or the baseline covers a
    /// section by a fan that is not star-shaped. Never set without caps.
    bool caps_exceed_section = false;
    CutStatistics statistics;
};

/// Cuts an object and consumes it; it comes back in `CutResult::object` if it was not cut. Never throws: running out of
/// memory is a status. The same object and the same plane give the same bytes in every run.
///
/// @param plane  in the mesh's own coordinates, which no cut ever changes
/// @note  Nothing to cut, as after a failed prepare(), is an `invalid_mesh`.
/// @note  The baseline costs O(n); the half-edge back end what its section costs.
CutResult cut(std::unique_ptr<Cuttable> object, const Plane& plane, const CutOptions& options = {});

/// The section of an object that stays as it is: the loops and chains, the area and the status of cut(), with the same
/// bytes. Reads the object, so any number of threads may ask at once. Never throws.
///
/// @param section  its memory is used again
/// @return         PlaneSection::status; of a plane that is not valid `invalid_argument`
/// @note  The linear back ends cost O(n), without a copy; the half-edge back end O(s log(n / s) + k), as FIND and WALK of
///        its cuts.
Status section(const Cuttable& object, const Plane& plane, PlaneSection& section) noexcept;

/// The same for a plane of a stack.
Status section(const StackSearch& stack, std::size_t number, PlaneSection& section) noexcept;

/// What became of a mesh.
struct PrepareResult
{
    Status status = Status::invalid_mesh;  ///< done, invalid_mesh, out_of_memory or cancelled
    std::unique_ptr<Cuttable> object;      ///< set when the status is `done`
    std::string reason;                    ///< one sentence when it is not
    bool coarse_coordinates = false;       ///< a warning, see has_coarse_coordinates(): results are closed but rounded
};

struct PrepareOptions
{
    BufferListener listener;  ///< of the object's buffers, and of all that descend from it
    Progress progress;
    unsigned threads = 1;              ///< that may work at it
    std::uint32_t cuts_with_room = 1;  ///< for how many cuts memory is got in advance; 0 as 1
};

/// A way to cut. Stateless: one backend may prepare any number of objects from any number of threads.
class Backend
{
public:
    virtual ~Backend() = default;

    /// "baseline/hash", "halfedge": what tables and file names show.
    virtual std::string name() const = 0;

    /// Makes a mesh ready for cutting; all sorting and building of trees happens here. Never throws. A mesh that was
    /// moved away is an `invalid_mesh`, as it has no triangles.
    PrepareResult prepare(ProvenMesh&& mesh, const PrepareOptions& options = {}) const;
    /// The same, and the mesh stays: only what the object keeps is copied.
    PrepareResult prepare(const ProvenMesh& mesh, const PrepareOptions& options = {}) const;
    /// The same for a mesh that nothing is known of: proves it first, which costs O(n) more, and refuses it with a
    /// reason when it breaks a promise. To prepare one mesh several times prove() it once.
    PrepareResult prepare(IndexedMesh mesh) const;

private:
    /// `mesh` has triangles. May throw std::bad_alloc, and Cancelled.
    virtual std::unique_ptr<Cuttable> make(ProvenMesh&& mesh, const PrepareOptions& options) const = 0;
    /// The same for a mesh that stays. A back end that keeps no array of the mesh needs no copy of it.
    virtual std::unique_ptr<Cuttable> make_beside(const ProvenMesh& mesh, const PrepareOptions& options) const
    {
        return make(ProvenMesh(mesh), options);
    }
};

}  // namespace kerf::core
