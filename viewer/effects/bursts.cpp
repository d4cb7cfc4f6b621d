#include "viewer/effects/bursts.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "common/support/random.h"

namespace kerf::effects {

namespace {

class Dice
{
public:
    explicit Dice(std::uint64_t seed) : random_(core::Random::mix(seed)) {}

    float between(float low, float high) { return low + (high - low) * static_cast<float>(random_.unit()); }
    std::uint32_t below(std::size_t n) { return random_.below(static_cast<std::uint32_t>(n)); }

    /// Uniform in the unit ball, but not in its very middle.
    glm::vec3 direction()
    {
        for (;;) {
            const glm::vec3 p(between(-1, 1), between(-1, 1), between(-1, 1));
            const float square = glm::dot(p, p);
            if (square <= 1.0f && square > 0.01f) return p;
        }
    }

private:
    core::Random random_;
};

glm::vec3 varied(Dice& dice, const glm::vec3& colour)
{
    return glm::clamp(colour * dice.between(0.75f, 1.25f), glm::vec3(0.0f), glm::vec3(1.0f));
}

}  // namespace

void add_splash(const Splash& splash, Drops& drops, Stains& stains)
{
    Dice dice(splash.seed);
    const float strength = std::clamp(splash.strength, 0.0f, 1.5f);
    const int count = static_cast<int>(150.0f * strength);
    for (int i = 0; i < count; ++i) {
        const glm::vec3 rim = splash.outline.empty() ? splash.centre + splash.size * dice.direction()
                                                     : splash.outline[dice.below(splash.outline.size())];
        // More from the rim, where the skin bursts, than from the inside.
        const float depth = std::sqrt(dice.between(0.0f, 1.0f));
        const glm::vec3 outwards = (rim - splash.centre) / std::max(splash.size, 1e-3f);
        const float side = dice.between(0.0f, 1.0f) < 0.5f ? -1.0f : 1.0f;
        Drop drop;
        drop.place = glm::mix(splash.centre, rim, depth);
        drop.velocity = 0.55f * splash.velocity + dice.between(0.8f, 4.2f) * depth * outwards +
                        side * dice.between(0.2f, 2.4f) * splash.normal + 1.3f * dice.direction();
        // Few are large, and those are slower.
        const float share = dice.between(0.0f, 1.0f), heavy = share * share * share * share;
        drop.size = splash.size * (0.009f + 0.066f * heavy);
        drop.velocity *= 1.15f - 0.4f * heavy;
        drop.life = dice.between(0.7f, 1.6f);
        drop.colour = varied(dice, splash.colour);
        drops.add(drop);
    }
    for (int i = 0; i < static_cast<int>(7.0f * strength); ++i) {
        Drop mist;
        mist.kind = DropKind::mist;
        const glm::vec3 rim = splash.outline.empty() ? splash.centre + splash.size * dice.direction()
                                                     : splash.outline[dice.below(splash.outline.size())];
        mist.place = glm::mix(splash.centre, rim, dice.between(0.3f, 0.9f));
        mist.velocity = 0.4f * splash.velocity + dice.between(0.5f, 2.0f) * dice.direction();
        mist.size = splash.size * dice.between(0.25f, 0.5f);
        mist.life = dice.between(0.25f, 0.5f);
        mist.colour = varied(dice, splash.colour);
        drops.add(mist);
    }
    if (strength < 0.2f) return;
    Stain stain;
    stain.place = splash.behind + 0.25f * splash.size * glm::vec2(dice.direction());
    stain.colour = splash.colour;
    stain.size = splash.size * dice.between(1.5f, 1.95f) * std::min(strength, 1.0f);
    stain.shape = dice.between(0.0f, 1.0f);
    stains.add(stain);
}

void add_sparkle(const glm::vec3& centre, const glm::vec3& colour, std::uint64_t seed, Drops& drops)
{
    Dice dice(seed);
    for (int i = 0; i < 46; ++i) {
        Drop spark;
        spark.kind = DropKind::spark;
        spark.place = centre;
        spark.velocity = dice.between(5.0f, 11.0f) * dice.direction();
        spark.colour = glm::mix(colour, glm::vec3(1.0f), dice.between(0.0f, 0.5f));
        spark.size = dice.between(0.03f, 0.07f);
        spark.life = dice.between(0.35f, 0.9f);
        drops.add(spark);
    }
}

void add_explosion(const glm::vec3& centre, std::uint64_t seed, Drops& drops)
{
    Dice dice(seed);
    for (int i = 0; i < 46; ++i) {
        Drop smoke;
        smoke.kind = DropKind::smoke;
        smoke.place = centre + 0.5f * dice.direction();
        smoke.velocity = dice.between(2.0f, 7.0f) * dice.direction();
        smoke.colour = glm::vec3(dice.between(0.03f, 0.12f));
        smoke.size = dice.between(0.3f, 0.7f);
        smoke.life = dice.between(0.8f, 1.9f);
        drops.add(smoke);
    }
    for (int i = 0; i < 120; ++i) {
        Drop fire;
        fire.kind = DropKind::spark;
        fire.place = centre + 0.3f * dice.direction();
        fire.velocity = dice.between(4.0f, 17.0f) * dice.direction();
        fire.colour = glm::mix(glm::vec3(1.0f, 0.18f, 0.02f), glm::vec3(1.0f, 0.75f, 0.25f), dice.between(0.0f, 1.0f));
        fire.size = dice.between(0.04f, 0.13f);
        fire.life = dice.between(0.3f, 1.2f);
        drops.add(fire);
    }
}

void add_dust(const Dust& dust, Drops& drops)
{
    Dice dice(dust.seed);
    const float strength = std::clamp(dust.strength, 0.0f, 1.0f);
    for (int i = 0; i < static_cast<int>(6.0f + 26.0f * strength); ++i) {
        Drop cloud;
        cloud.kind = DropKind::mist;
        cloud.place = dust.centre + 0.8f * dust.size * dice.direction();
        cloud.velocity = 0.6f * dust.velocity + dice.between(0.4f, 2.2f) * dice.direction();
        cloud.size = dust.size * dice.between(0.12f, 0.3f);
        cloud.life = dice.between(0.35f, 0.9f);
        cloud.colour = varied(dice, dust.colour);
        drops.add(cloud);
    }
    for (int i = 0; i < static_cast<int>(10.0f + 60.0f * strength); ++i) {
        Drop crumb;
        crumb.kind = DropKind::crumb;
        crumb.place = dust.centre + dust.size * dice.direction();
        crumb.velocity = 0.8f * dust.velocity + dice.between(0.8f, 4.5f) * dice.direction();
        const float share = dice.between(0.0f, 1.0f);
        crumb.size = dust.size * (0.012f + 0.04f * share * share * share);
        crumb.life = dice.between(0.6f, 1.5f);
        crumb.colour = varied(dice, 0.8f * dust.colour);
        drops.add(crumb);
    }
}

void add_fuse_sparks(const glm::vec3& tip, std::uint64_t seed, Drops& drops)
{
    Dice dice(seed);
    if (dice.between(0.0f, 1.0f) < 0.4f) return;
    Drop spark;
    spark.kind = DropKind::spark;
    spark.place = tip;
    spark.velocity = dice.between(1.0f, 3.0f) * dice.direction();
    spark.colour = glm::mix(glm::vec3(1.0f, 0.35f, 0.05f), glm::vec3(1.0f, 0.9f, 0.5f), dice.between(0.0f, 1.0f));
    spark.size = dice.between(0.02f, 0.045f);
    spark.life = dice.between(0.15f, 0.4f);
    drops.add(spark);
}

}  // namespace kerf::effects
