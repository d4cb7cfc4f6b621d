#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace kerf {

/// An edge of a section, as it runs in the surface of the positive side.
struct OutlineEdge
{
    std::uint32_t from = 0, to = 0;       ///< numbers of points
    std::array<std::uint32_t, 2> part{};  ///< by Side, what it bounds there
};

/// A closed loop of outline edges that bound one part.
struct OutlineLoop
{
    std::uint32_t part = 0;
    std::vector<std::uint32_t> points;
};

/// The edges of a section in an order of their own: the same for equal edges, however they were found. Points are
/// numbered by position, edges sorted by their points, edges that run forth and back between the same points are gone.
class SortedOutline
{
public:
    /// O(e log e).
    SortedOutline(std::span<const glm::vec3> points, std::span<const OutlineEdge> edges);

    std::span<const OutlineEdge> edges() const { return edges_; }
    const glm::vec3& position(std::uint32_t point) const { return positions_[point]; }

    /// Several edges leave some point: loops meet there.
    bool has_joints() const { return has_joints_; }

    /// Links the edges into simple loops: edges of one part on `side` follow one another. Chains are left out. O(e).
    std::vector<OutlineLoop> loops(std::size_t side) const;

private:
    void sort_by_points();
    bool some_run_forth_and_back() const;

    std::vector<glm::vec3> positions_;
    std::vector<OutlineEdge> edges_;
    std::vector<std::uint32_t> row_;  ///< first edge that leaves each point
    bool has_joints_ = false;
};

}  // namespace kerf
