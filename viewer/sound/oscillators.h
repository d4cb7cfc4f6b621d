#pragma once

#include <cmath>
#include <numbers>

#include "common/support/random.h"

// The parts that sounds are made of. Each is advanced one sample at a time.

namespace kerf::sound {

/// A sine whose frequency may change from sample to sample without a jump.
class Sine
{
public:
    explicit Sine(double sample_rate) : rate_(sample_rate) {}

    double next(double hertz)
    {
        phase_ += hertz / rate_;
        phase_ -= std::floor(phase_);
        return std::sin(2.0 * std::numbers::pi * phase_);
    }

private:
    double rate_, phase_ = 0.0;
};

/// White noise, -1 to 1.
class Noise
{
public:
    explicit Noise(std::uint64_t seed) : random_(seed) {}
    double next() { return 2.0 * random_.unit() - 1.0; }
    double unit() { return random_.unit(); }

private:
    core::Random random_;
};

/// A state variable filter: low, band and high pass at once, whose frequency may change from sample to sample (Simper,
/// "Linear trapezoidal integrated state variable filter", 2013). Stable below half the sample rate.
class Filter
{
public:
    explicit Filter(double sample_rate) : rate_(sample_rate) {}

    /// @param hertz    where it cuts off, or its middle; kept below 0.45 of the sample rate
    /// @param quality  1/sqrt(2): flat; larger: it rings
    void put(double input, double hertz, double quality = 0.7071)
    {
        const double g = std::tan(std::numbers::pi * std::fmin(hertz / rate_, 0.45));
        const double k = 1.0 / quality;
        const double a = 1.0 / (1.0 + g * (g + k));
        const double v3 = input - second_;
        band_ = a * (first_ + g * v3);
        low_ = second_ + g * band_;
        first_ = 2.0 * band_ - first_;
        second_ = 2.0 * low_ - second_;
        high_ = input - k * band_ - low_;
    }

    double low() const { return low_; }
    double band() const { return band_; }
    double high() const { return high_; }

private:
    double rate_;
    double first_ = 0.0, second_ = 0.0;
    double low_ = 0.0, band_ = 0.0, high_ = 0.0;
};

}  // namespace kerf::sound
