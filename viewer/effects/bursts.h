#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "viewer/effects/drops.h"
#include "viewer/effects/stains.h"

namespace kerf::effects {

/// What a cut let out. World units and seconds.
struct Splash
{
    std::uint64_t seed = 0;
    std::vector<glm::vec3> outline;  ///< points of the section's loops; empty: from the centre alone
    glm::vec3 centre{0.0f};
    glm::vec2 behind{0.0f};              ///< where the wall is stained: behind the centre, as the eye sees it
    glm::vec3 normal{0.0f, 1.0f, 0.0f};  ///< of the cut
    glm::vec3 velocity{0.0f};            ///< of the object
    glm::vec3 colour{1.0f};              ///< of its juice, linear
    float size = 1.0f;                   ///< radius of the object
    float strength = 1.0f;               ///< 1: juicy, 0: dry
};

/// Drops from the outline and the inside of the section, to both sides of the cut, and one stain on the wall behind.
void add_splash(const Splash& splash, Drops& drops, Stains& stains);

/// A shower of sparks, for a critical hit.
void add_sparkle(const glm::vec3& centre, const glm::vec3& colour, std::uint64_t seed, Drops& drops);

/// A bomb: fire and smoke.
void add_explosion(const glm::vec3& centre, std::uint64_t seed, Drops& drops);

/// What leaves where something breaks: dust, and crumbs that fall.
struct Dust
{
    std::uint64_t seed = 0;
    glm::vec3 centre{0.0f};
    glm::vec3 velocity{0.0f};  ///< of the object
    glm::vec3 colour{1.0f};    ///< linear
    float size = 1.0f;         ///< radius of what it comes from
    float strength = 1.0f;     ///< 1: all of it broke, 0: nothing did
};
void add_dust(const Dust& dust, Drops& drops);

/// What glows at the end of a fuse: a spark or two each tick.
void add_fuse_sparks(const glm::vec3& tip, std::uint64_t seed, Drops& drops);

}  // namespace kerf::effects
