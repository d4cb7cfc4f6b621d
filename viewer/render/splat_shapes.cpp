#include "viewer/render/splat_shapes.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <numbers>

#include "common/support/random.h"

namespace kerf::render {

namespace {

constexpr int kSide = SplatShapes::kSide;
constexpr float kTexelsARadius = kSide / (2.0f * SplatShapes::kReach);

class HeightField
{
public:
    HeightField() : heights_(std::size_t(kSide) * kSide) {}

    /// A round heap of juice whose outline, alone, has this radius. Lengths in radii of the stain.
    void add_drop(const glm::vec2& place, float radius, float height = 1.0f)
    {
        // The kernel height * (1 - r^2)^2 is kEdge high where r^2 is 1 - sqrt(kEdge / height).
        const float support = radius / std::sqrt(1.0f - std::sqrt(SplatShapes::kEdge / height));
        const glm::vec2 middle = (place + SplatShapes::kReach) * kTexelsARadius - 0.5f;
        const float reach = support * kTexelsARadius;
        const auto first = [&](float at) { return std::max(static_cast<int>(std::ceil(at - reach)), 1); };
        const auto last = [&](float at) { return std::min(static_cast<int>(std::floor(at + reach)), kSide - 2); };
        for (int y = first(middle.y); y <= last(middle.y); ++y)
            for (int x = first(middle.x); x <= last(middle.x); ++x) {
                const glm::vec2 d = (glm::vec2(x, y) - middle) / reach;
                const float inside = std::max(1.0f - glm::dot(d, d), 0.0f);
                at(x, y) += height * inside * inside;
            }
    }

    /// Thick juice levels out: heights approach 1.
    void level()
    {
        for (float& height : heights_)
            height = height < 0.35f ? height : 1.0f - 0.65f * std::exp(-(height - 0.35f) / 0.65f);
    }

    float& at(int x, int y) { return heights_[static_cast<std::size_t>(y) * kSide + static_cast<std::size_t>(x)]; }

private:
    std::vector<float> heights_;
};

/// Drops in a row from the body outwards, thinner and thinner; what was fastest tore off and lies beyond.
void add_ray(HeightField& field, core::Random& random, float angle)
{
    const auto between = [&](float low, float high) { return low + (high - low) * static_cast<float>(random.unit()); };
    const glm::vec2 along(std::cos(angle), std::sin(angle));
    const glm::vec2 across(-along.y, along.x);
    const float power = between(0.0f, 1.0f);
    const float reach = 0.55f + 0.62f * power * power;
    const float width = between(0.035f, 0.10f);
    const float bow = between(-0.05f, 0.05f);
    float far = 0.3f;
    while (far < reach) {
        const float share = (far - 0.3f) / (reach - 0.3f);
        const float thin = 1.0f - 0.78f * std::sqrt(share);
        field.add_drop(along * far + across * (bow * share * share), width * thin, 0.6f);
        far += 0.025f;
    }
    field.add_drop(along * reach + across * bow, width * between(0.45f, 0.85f));
    far = reach;
    for (int drops = static_cast<int>(between(0.0f, 4.0f)); drops > 0; --drops) {
        far += between(0.06f, 0.26f);
        const float size = between(0.012f, 0.055f);
        // A drop that came in at a slant is longer than wide.
        for (int part = 0; part < 3; ++part)
            field.add_drop(along * (far + 0.7f * size * float(part)) + across * (bow + between(-0.02f, 0.02f)),
                           size * (1.0f - 0.22f * float(part)), 0.7f);
    }
}

HeightField made(std::uint64_t seed)
{
    HeightField field;
    core::Random random(core::Random::mix(seed));
    const auto between = [&](float low, float high) { return low + (high - low) * static_cast<float>(random.unit()); };
    const auto direction = [&] { return between(0.0f, 2.0f * std::numbers::pi_v<float>); };
    // Splashes have a side that they go to.
    const float aim = direction(), bias = between(0.15f, 0.5f);
    const auto aimed = [&](float angle) { return 1.0f + bias * std::cos(angle - aim); };
    field.add_drop({0.0f, 0.0f}, 0.30f);
    for (int i = 0; i < 16; ++i) {
        const float angle = direction(), far = between(0.12f, 0.36f) * aimed(angle);
        field.add_drop(far * glm::vec2(std::cos(angle), std::sin(angle)), between(0.06f, 0.19f), 0.8f);
    }
    const int rays = 15 + static_cast<int>(between(0.0f, 10.0f));
    for (int i = 0; i < rays; ++i) {
        float angle = direction();
        if (between(0.0f, 1.4f) > aimed(angle)) angle = aim + between(-0.9f, 0.9f);
        add_ray(field, random, angle);
    }
    for (int i = 0; i < 130; ++i) {
        const float angle = direction(), share = between(0.0f, 1.0f), small = between(0.0f, 1.0f);
        const float far = (0.5f + 1.0f * share * share) * std::min(aimed(angle), 1.1f);
        field.add_drop(far * glm::vec2(std::cos(angle), std::sin(angle)), 0.006f + 0.034f * small * small * small,
                       0.6f);
    }
    field.level();
    return field;
}

std::uint8_t byte_of(float value)
{
    return static_cast<std::uint8_t>(std::lround(255.0f * std::clamp(value, 0.0f, 1.0f)));
}

}  // namespace

SplatShapes make_splat_shapes()
{
    SplatShapes shapes;
    shapes.texels.reserve(std::size_t(4) * SplatShapes::kShapes * kSide * kSide);
    for (int shape = 0; shape < SplatShapes::kShapes; ++shape) {
        HeightField field = made(static_cast<std::uint64_t>(shape) + 40);
        constexpr float kToByte = 0.5f * kTexelsARadius / (2.0f * SplatShapes::kMostSlope);
        for (int y = 0; y < kSide; ++y)
            for (int x = 0; x < kSide; ++x) {
                const int left = std::max(x - 1, 0), right = std::min(x + 1, kSide - 1);
                const int below = std::max(y - 1, 0), above = std::min(y + 1, kSide - 1);
                constexpr float kLevel = 128.0f / 255.0f;
                shapes.texels.push_back(byte_of(field.at(x, y)));
                shapes.texels.push_back(byte_of(kLevel + kToByte * (field.at(right, y) - field.at(left, y))));
                shapes.texels.push_back(byte_of(kLevel + kToByte * (field.at(x, above) - field.at(x, below))));
                shapes.texels.push_back(255);
            }
    }
    return shapes;
}

}  // namespace kerf::render
