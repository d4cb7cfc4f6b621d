#include "viewer/effects/drops.h"

#include <cmath>
#include <glm/geometric.hpp>

namespace kerf::effects {

namespace {

/// Below what any window sees: nothing is to be seen of it any more. World units.
constexpr float kFloor = -7.0f;

struct Behaviour
{
    float gravity;  ///< downwards, per second squared
    float drag;     ///< share of the speed that is lost in a second
    float growth;   ///< of the radius, per second
};

Behaviour behaviour_of(DropKind kind)
{
    switch (kind) {
        case DropKind::juice:
            return {9.81f, 0.6f, 0.0f};
        case DropKind::spark:
            return {1.5f, 2.6f, 0.0f};
        case DropKind::smoke:
            return {-0.9f, 2.2f, 0.9f};
        case DropKind::mist:
            return {2.0f, 4.0f, 1.3f};
        case DropKind::crumb:
            return {9.81f, 0.4f, 0.0f};
    }
    return {};
}

bool is_gone(const Drop& drop)
{
    return drop.age >= drop.life || drop.place.y < kFloor;
}

}  // namespace

void Drops::add(const Drop& drop)
{
    if (drops_.size() < kMost) {
        drops_.push_back(drop);
    } else {
        drops_[oldest_ % kMost] = drop;
        oldest_ = (oldest_ + 1) % kMost;
    }
}

void Drops::advance(float seconds, std::vector<WallHit>& hits)
{
    for (Drop& drop : drops_) {
        const Behaviour b = behaviour_of(drop.kind);
        drop.age += seconds;
        drop.velocity.y -= b.gravity * seconds;
        drop.velocity *= std::exp(-b.drag * seconds);
        drop.place += drop.velocity * seconds;
        drop.size += b.growth * seconds;
        if (drop.place.z > kWallZ) continue;
        if (drop.kind == DropKind::juice) {
            hits.push_back({{drop.place.x, drop.place.y, kWallZ}, drop.colour, drop.size});
            drop.age = drop.life;
        } else {
            drop.place.z = kWallZ + 0.01f;
        }
    }
    std::erase_if(drops_, is_gone);
}

}  // namespace kerf::effects
