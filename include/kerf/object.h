#pragma once

#include <kerf/back_ends.h>
#include <kerf/draw.h>
#include <kerf/export.h>
#include <kerf/mass.h>
#include <kerf/mesh.h>
#include <kerf/plane.h>
#include <kerf/status.h>

#include <cstdint>
#include <span>
#include <utility>

namespace kerf {

namespace core {
class Cuttable;
}

/// @addtogroup objects
/// What is cut, from the mesh that it was made of to its pieces.
/// @{

/// Options of prepare().
struct PrepareOptions
{
    BackEnd back_end = BackEnd::automatic;  ///< the way to cut; a number that is none of them is `automatic`
    /// A back end by its name instead (find_back_end()): what a user chooses on a command line. May be null.
    const char* back_end_name = nullptr;
    /// How many times the object and its pieces will be cut, about. `automatic` goes by it.
    std::uint32_t cuts_expected = 1000;
    /// Called now and then from the thread that prepares, with the share that is done: 0 first, 1 last. Returns false
    /// to stop; prepare() then says `cancelled`. Must not throw: that ends the program. May be null.
    bool (*progress)(void* user, double share) = nullptr;
    void* user = nullptr;          ///< for `progress`
    BufferListener listener = {};  ///< of the object's buffers and of all that descend from it
    /// Threads that may work at it, the caller's among them; 0: as many as the processor has. The half-edge back end
    /// takes up to two, for meshes of 20 000 triangles and more; the linear one has nothing to share out. The object is
    /// the same, whatever the number. If no thread is to be had, the caller's does it alone.
    std::uint32_t threads = 1;
    /// For how many cuts the object has room from the start, in memory that was touched; clones have the same. A later
    /// cut gets memory for what it adds, and the first touch of a page can cost more than the work of a small cut on it
    /// (`CutStatistics::bytes_grown`). A game asks for as many as an object and its pieces will get. Half-edge back end:
    /// the room for a cut grows with the square root of the triangles. The linear one copies in any case.
    std::uint32_t cuts_with_room = 1;
};

/// A closed polyline, or a chain that ends at holes of the mesh: an outline of the section that made an object.
struct SectionLoop
{
    std::span<const Vec3f> points;  ///< in order; of a chain also its end
    bool is_closed = true;          ///< false of a chain
};

/// Something that can be cut: made by prepare(), or a piece of a cut. Move-only; its members are hidden, so programs
/// stay source-compatible within a version. An empty object (made by default, moved from, or spent by a cut) has
/// nothing, and every call says so.
///
/// Threads. Objects that share buffers (shares_buffers_with()) are relatives: with the half-edge back end the pieces
/// of one prepare(), clone() or fracture(). To read is to call a const member; to change is all else, and the end of an object.
///
/// | one thread                | another thread | same object | relative     | stranger |
/// |---------------------------|----------------|-------------|--------------|----------|
/// | reads                     | reads          | yes         | yes          | yes      |
/// | reads                     | changes        | no          | yes, in turn | yes      |
/// | changes                   | changes        | no          | yes, in turn | yes      |
/// | uses what a DrawView says | reads          | yes         | yes          | yes      |
/// | uses what a DrawView says | changes        | no          | yes          | yes      |
///
/// "In turn": inside, one waits until the other is done; readers wait for nobody but a change.
class KERF_API Object
{
public:
    /// An empty one; what is moved from is empty, too.
    /// @{
    Object() noexcept = default;
    Object(Object&& other) noexcept;
    Object& operator=(Object&& other) noexcept;
    /// @}
    ~Object();

    bool is_empty() const noexcept { return inside_ == nullptr; }    ///< whether there is nothing to cut
    explicit operator bool() const noexcept { return !is_empty(); }  ///< whether there is something to cut

    /// An independent copy that shares nothing: a copy of memory, not a prepare(). O(n) of all that it shares buffers
    /// with. Status: `out_of_memory`, `invalid_argument` for an empty object.
    Result<Object> clone() const noexcept;

    std::uint64_t triangle_count() const noexcept;  ///< with caps; 0 of an empty object. O(1).
    /// The smallest box around it; empty of an empty object. O(1).
    Box bounds() const noexcept;
    /// Volume, centre of mass and inertia. O(log n) with the half-edge back end, O(n) with the linear one. No volume
    /// for an empty object.
    MassProperties mass_properties() const noexcept;
    /// A compact copy of the triangles: what to write or to hand on. O(n). Status: `out_of_memory`, `invalid_argument`
    /// for an empty object.
    Result<Mesh> mesh() const noexcept;

    /// The outlines of the cut that made this piece; none before any cut.
    std::size_t loop_count() const noexcept;
    /// An empty one if there is none of that number. Its points live until the object changes or ends.
    SectionLoop loop(std::size_t i) const noexcept;

    /// Fills a view, new or used: what to draw. Status: `invalid_argument` for an empty object, `out_of_memory`; then
    /// the view is empty.
    Status draw(DrawView& view) const noexcept;
    /// What `view` calls new is on the GPU now.
    void mark_uploaded(const DrawView& view) noexcept;

    /// Whether both are relatives. An empty object has none.
    bool shares_buffers_with(const Object& other) const noexcept;
    /// Gives the object buffers of its own; then it is a stranger to all others. O(n) if it has relatives. Status:
    /// `done`, `invalid_argument` for an empty object, or `out_of_memory`, and the object is as it was.
    Status detach() noexcept;
    /// Whether many cuts have scattered the object over shared buffers, so that it is worth to compact() it.
    bool is_scattered() const noexcept;
    /// Moves the object into buffers of its own that hold nothing else. Nothing of the object changes but where it
    /// lies: all of it is to be uploaded again. Of `linear`, whose objects share nothing, nothing changes. O(n). Status:
    /// `done`, `invalid_argument` for an empty object, or `out_of_memory`, and the object is as it was.
    Status compact() noexcept;

    /// Adds a material, for caps of later cuts. Returns its number, or kNone if there is no memory or the object is
    /// empty.
    std::uint32_t add_material(const Material& material) noexcept;
    std::size_t material_count() const noexcept;  ///< of material()
    /// Its texts live until a material is added or the object changes or ends; one without a name if there is none of
    /// that number.
    Material material(std::size_t i) const noexcept;
    /// Name of the back end that cuts the object; "" of an empty one.
    const char* back_end_name() const noexcept;

    /// @cond For the library itself.
    explicit Object(core::Cuttable* inside) noexcept : inside_(inside) {}
    core::Cuttable* inside() const noexcept { return inside_; }
    core::Cuttable* release() noexcept { return std::exchange(inside_, nullptr); }
    /// @endcond

private:
    core::Cuttable* inside_ = nullptr;
};

/// Makes an object of a mesh. O(n). The half-edge back end copies what it keeps of the mesh; the linear one keeps its
/// arrays, and copies them only if there are other copies of the mesh: give it yours by std::move(). It is gone then,
/// whatever becomes of it; who wants to try again keeps a copy. The mesh of a piece on which surfaces lie on one
/// another is repaired before, as Mesh::make() does. Status: `invalid_mesh` for an empty mesh, `invalid_argument` for a
/// back end that this build lacks, `cancelled`, `out_of_memory`.
///
///     kerf::PrepareOptions options;
///     options.cuts_expected = 1;
///     kerf::Result<kerf::Object> object = kerf::prepare(std::move(mesh), options);
///     if (!object) return complain(object.reason());
KERF_API Result<Object> prepare(Mesh mesh, const PrepareOptions& options = {}) noexcept;

/// @}

}  // namespace kerf
