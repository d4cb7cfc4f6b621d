#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <vector>

#include "viewer/sim/pose.h"
#include "viewer/sim/world.h"

namespace kerf::sim {

/// Along the world's axes, metres.
struct WorldBox
{
    glm::dvec3 lo, hi;

    bool overlaps(const WorldBox& other) const;
};

/// Around what has this box in its own frame.
WorldBox world_box(const Box& box, const MeshPose& pose);

/// Where the bodies of a world are at one moment, and what is about to join them: whether there is room for one more.
class Crowd
{
public:
    /// O(bodies).
    explicit Crowd(const World& world);

    std::size_t size() const { return boxes_.size(); }
    void add(const WorldBox& box) { boxes_.push_back(box); }
    /// Whether so many boxes overlap this one. O(size()).
    bool is_thick_at(const WorldBox& box, std::size_t many = kMostNeighbours) const;

private:
    std::vector<WorldBox> boxes_;
};

}  // namespace kerf::sim
