#pragma once

#include <kerf/object.h>

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "viewer/render/shared_buffers.h"
#include "viewer/render/surface_look.h"
#include "viewer/render/swarm.h"

namespace kerf::render {

/// Runs of the index buffer as glMultiDrawElements wants them.
struct IndexRuns
{
    std::vector<GLsizei> counts;       ///< indices in each run
    std::vector<const void*> offsets;  ///< bytes into the index buffer

    void add(std::uint32_t first_index, std::uint32_t index_count);
};

/// The ranges of an object that are drawn with one material: one call.
struct DrawBatch
{
    std::uint32_t look = 0;  ///< index into the LookTable
    std::uint32_t material = 0;
    TriangleKind kind = TriangleKind::surface;
    IndexRuns runs;
};

/// What is needed to draw an object, whatever becomes of the object. Cheap to keep, made anew after a cut.
struct DrawnFragment
{
    std::shared_ptr<const SharedBuffers> buffers;
    std::vector<DrawBatch> batches;
    IndexRuns everything;  ///< whatever the material: for shadows
    std::uint64_t triangles = 0;
    Box bounds;                           ///< mesh coordinates
    std::optional<std::uint32_t> member;  ///< its number, if the buffers are a Swarm's
};

/// Names what small objects come from, whose materials all of them have: those of one name become members of one Swarm. 0
/// is nobody's name.
using Kin = std::uint64_t;

/// How much larger than its content a buffer starts.
enum class Room
{
    exact,    ///< for what will not grow
    to_grow,  ///< as much again, from kLeastRoom to kMostRoom: for an object that is about to be cut
};

/// For several cuts of the smallest models: what a cut adds may be more than all that was there.
inline constexpr std::uint64_t kLeastRoom = 64u << 10;

/// For more than thirty cuts of four million triangles. Room costs time, too: drivers clear it.
inline constexpr std::uint64_t kMostRoom = 32u << 20;

/// How far an object is that is brought onto the graphics card bit by bit.
struct Arrival
{
    std::shared_ptr<SharedBuffers> buffers;  ///< null before the first bit
    std::uint64_t vertex_bytes = 0;          ///< that are there
    std::uint64_t index_bytes = 0;
    std::uint64_t bytes = 0;  ///< of vertices and indices when all is there
    bool is_whole = false;

    /// 0 to 1.
    double share() const { return bytes == 0 ? 0.0 : double(vertex_bytes + index_bytes) / double(bytes); }
};

/// Puts objects onto the graphics card and keeps count of every byte. Objects with equal DrawView::buffers share their
/// buffers, and only what is new is uploaded.
class FragmentStore
{
public:
    explicit FragmentStore(LookTable& looks) : looks_(looks) {}

    /// Uploads what is new of the object, tells it so, and gives what is needed to draw it. O(ranges + new bytes).
    /// Add the fragments of a cut before the next release_unused(), so that they find their object's buffers.
    /// @param images  for each material the file of its image, or nothing; empty: as the materials name them
    /// @param kin     of an object of which nothing was uploaded yet: with whom it is drawn, if it is small
    /// @throws RenderError  the graphics card has no memory left; the object does not count as uploaded then
    DrawnFragment add(Object& object, std::span<const std::string> images = {}, Room room = Room::exact, Kin kin = 0);

    /// Uploads at most so many bytes of an object of which nothing was uploaded yet, from where `arrival` ends, and
    /// says how many. Each of the two buffers is allocated in a call of its own. When all is there the object is told
    /// so, and add() has nothing left to upload as long as `arrival` is kept. The object must be the same each time and
    /// not be cut meanwhile. Of an object whose buffers are here already, because it shares them with another one, all that
    /// is new comes at once, whatever `most` says; and so does what becomes a member of a Swarm. O(bytes)
    /// @throws RenderError  the graphics card has no memory left
    std::uint64_t bring(Object& object, Arrival& arrival, std::uint64_t most, Room room = Room::exact, Kin kin = 0);

    /// Frees the buffers that no DrawnFragment and no Arrival uses. For once a frame. O(objects)
    void release_unused();

    std::uint64_t bytes_uploaded() const { return bytes_uploaded_; }  ///< ever; vertices and indices
    std::size_t buffer_sets() const;
    std::uint64_t bytes_held() const;  ///< on the graphics card now

private:
    /// Where an object's vertices and indices are.
    struct Home
    {
        std::shared_ptr<SharedBuffers> buffers;
        std::optional<Swarm::Member> member;
    };

    Home home_for(Object& object, const DrawView& view, Room room, Kin kin);
    std::shared_ptr<SharedBuffers> upload_new(Object& object, const DrawView& view, Room room);
    std::shared_ptr<SharedBuffers> buffers_for(const DrawView& view, Room room, bool& is_new);
    bool joins_a_swarm(const DrawView& view, Kin kin) const;
    Home take_into_swarm(Object& object, const DrawView& view, Kin kin);

    /// Fills `view_`. @throws RenderError
    const DrawView& look_at(const Object& object);

    LookTable& looks_;
    DrawView view_;                                                           ///< used again and again
    std::unordered_map<std::uint64_t, std::shared_ptr<SharedBuffers>> sets_;  ///< by DrawView::buffers
    std::vector<std::shared_ptr<SharedBuffers>> arriving_;                    ///< all is not there yet
    std::map<Kin, std::vector<Swarm>> swarms_;                                ///< the last one may have room
    /// Who was brought into a swarm and not added yet, by DrawView::buffers.
    std::unordered_map<std::uint64_t, std::pair<std::weak_ptr<SharedBuffers>, Swarm::Member>> newcomers_;
    std::uint64_t bytes_uploaded_ = 0;
};

}  // namespace kerf::render
