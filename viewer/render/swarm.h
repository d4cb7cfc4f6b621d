#pragma once

#include <cstdint>
#include <memory>

#include "viewer/render/shared_buffers.h"

namespace kerf::render {

/// Many small objects in one pair of buffers, each where it likes to be: each vertex knows whose it is, and a shader finds
/// the object's place by that. So all members that look alike are drawn with one call (SwarmPass). What an object of its
/// own costs is a call for each of its looks and one for its shadow, some microseconds each, whatever its size.
class Swarm
{
public:
    /// Fewer objects are as soon drawn one by one: swarms are drawn with programs of their own, which drivers have to
    /// translate.
    static constexpr std::size_t kFewestMembers = 64;
    /// So many matrices are a uniform block of 16 KiB, which every driver offers.
    static constexpr std::uint32_t kMostMembers = 256;
    /// Of all vertices. Buffers grow by moving, which takes a frame's time if they are larger.
    static constexpr std::uint64_t kMostBytes = 4u << 20;
    /// Of one object's vertices: some two thousand. To draw more takes so long that a call of their own does not matter.
    static constexpr std::uint64_t kMostBytesOfAMember = 64u << 10;

    /// What of the swarm one object is.
    struct Member
    {
        std::uint32_t number = 0;       ///< below kMostMembers
        std::uint32_t first_index = 0;  ///< where its index buffer begins in the swarm's
    };

    /// @throws RenderError  the graphics card has no memory left
    Swarm();

    /// Whether an object can become a member.
    bool has_room_for(const DrawView& view) const;

    /// Uploads all of an object that there is room for. O(vertices + indices)
    /// @throws RenderError  the graphics card has no memory left
    Member take_in(const DrawView& view);

    const std::shared_ptr<SharedBuffers>& buffers() const { return buffers_; }

private:
    std::shared_ptr<SharedBuffers> buffers_;
    std::uint32_t members_ = 0;
    std::uint64_t vertices_ = 0, indices_ = 0;  ///< so many are there
};

}  // namespace kerf::render
