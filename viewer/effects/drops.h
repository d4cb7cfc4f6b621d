#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace kerf::effects {

/// Where the wall behind the stage stands, world units.
inline constexpr float kWallZ = -2.6f;

enum class DropKind : std::uint8_t
{
    juice,  ///< falls, and stains the wall that it meets
    spark,  ///< glows, is slowed down by the air
    smoke,  ///< rises, grows, thins out
    mist,   ///< juice too fine for drops, or dust: stands, grows, thins out
    crumb,  ///< falls, and stops at the wall
};

/// One of the many small things that fly about. World units and seconds.
struct Drop
{
    DropKind kind = DropKind::juice;
    glm::vec3 place{0.0f};
    glm::vec3 velocity{0.0f};
    glm::vec3 colour{1.0f};  ///< linear
    float size = 0.05f;      ///< radius
    float age = 0.0f;
    float life = 1.0f;  ///< age at which it vanishes

    float left() const { return 1.0f - age / life; }  ///< 1: new, 0: gone
};

/// A drop of juice that reached the wall.
struct WallHit
{
    glm::vec3 place{0.0f};
    glm::vec3 colour{1.0f};
    float size = 0.0f;  ///< radius of the drop
};

/// What flies, at most kMost; the oldest make room. It only ever looks: nothing in the simulation depends on it.
class Drops
{
public:
    static constexpr std::size_t kMost = 900;

    void add(const Drop& drop);
    /// Moves everything; tells what met the wall. O(drops)
    void advance(float seconds, std::vector<WallHit>& hits);
    void clear() { drops_.clear(); }

    std::span<const Drop> all() const { return drops_; }

private:
    std::vector<Drop> drops_;
    std::size_t oldest_ = 0;  ///< place of the next one when there is no room
};

}  // namespace kerf::effects
