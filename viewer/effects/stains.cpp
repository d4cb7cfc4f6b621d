#include "viewer/effects/stains.h"

#include <algorithm>
#include <cmath>

namespace kerf::effects {

namespace {

constexpr float kSpreadTime = 0.07f;  // seconds
constexpr float kFurthestRun = 1.7f;  // sizes
constexpr float kSoaksIn = 3.2f;      // seconds until nothing shines

float smooth(float x)
{
    x = std::clamp(x, 0.0f, 1.0f);
    return x * x * (3.0f - 2.0f * x);
}

}  // namespace

float Stain::spread() const
{
    return smooth(age / kSpreadTime);
}

float Stain::run() const
{
    // A drip is fast while it is full and slows down as it leaves itself behind on the wall.
    return kFurthestRun * (1.0f - std::exp(-0.7f * std::max(age - kSpreadTime, 0.0f)));
}

float Stain::opacity() const
{
    return 1.0f - smooth((age - Stains::kWet) / (Stains::kLife - Stains::kWet));
}

float Stain::wetness() const
{
    return 1.0f - smooth(age / kSoaksIn);
}

void Stains::add(const Stain& stain)
{
    if (stains_.size() >= kMost) stains_.erase(stains_.begin());
    stains_.push_back(stain);
}

void Stains::advance(float seconds)
{
    for (Stain& stain : stains_) stain.age += seconds;
    std::erase_if(stains_, [](const Stain& stain) { return stain.age >= kLife; });
}

}  // namespace kerf::effects
