#include "viewer/sound/synthesis.h"

#include <algorithm>
#include <array>
#include <numbers>

#include "viewer/sound/oscillators.h"

namespace kerf::sound {

namespace {

using Samples = std::vector<float>;

constexpr double kFade = 0.004;  ///< seconds at the end of a sound that lead into silence

/// Calls `sample(t)` for each sample; t in seconds.
template <typename Function>
Samples generated(double seconds, Function sample)
{
    Samples samples(static_cast<std::size_t>(seconds * kSampleRate));
    for (std::size_t i = 0; i < samples.size(); ++i)
        samples[i] = static_cast<float>(sample(double(i) / double(kSampleRate)));
    return samples;
}

void add(Samples& sum, const Samples& more, double start, double gain)
{
    const auto offset = static_cast<std::size_t>(start * kSampleRate);
    sum.resize(std::max(sum.size(), offset + more.size()), 0.0f);
    for (std::size_t i = 0; i < more.size(); ++i) sum[offset + i] += static_cast<float>(gain) * more[i];
}

void set_peak(Samples& samples, double peak)
{
    float most = 0.0f;
    for (const float s : samples) most = std::max(most, std::abs(s));
    if (most > 0.0f)
        for (float& s : samples) s = std::clamp(s * static_cast<float>(peak) / most, -kPeak, kPeak);
}

void end_softly(Samples& samples)
{
    const std::size_t count = std::min(samples.size(), static_cast<std::size_t>(kFade * kSampleRate));
    for (std::size_t i = 0; i < count; ++i)
        samples[samples.size() - 1 - i] *= static_cast<float>(double(i) / double(count));
}

/// 0 to 1 within `attack` seconds, then down to a third in each `decay`.
double struck(double t, double attack, double decay)
{
    return std::min(t / attack, 1.0) * std::exp(-std::max(t - attack, 0.0) / decay);
}

/// 0 at both ends of 0..length, 1 in the middle.
double swell(double t, double length)
{
    const double s = std::sin(std::numbers::pi * std::clamp(t / length, 0.0, 1.0));
    return s * s;
}

/// Air that a blade parts: noise through a band that rises and falls.
Samples swish()
{
    constexpr double kLength = 0.24;
    Noise noise(11);
    Filter band(kSampleRate), air(kSampleRate);
    return generated(kLength, [&](double t) {
        const double n = noise.next(), bow = swell(t, kLength);
        band.put(n, 500.0 + 2600.0 * bow, 2.4);
        air.put(n, 5200.0);
        return bow * (band.band() + 0.12 * air.high());
    });
}

/// Something wet that gives way: a slap of noise, then drops, short sines of falling pitch.
Samples splat()
{
    constexpr double kLength = 0.42;
    Noise noise(23);
    Filter slap(kSampleRate), wet(kSampleRate);
    Sine body(kSampleRate);
    Samples sound = generated(kLength, [&](double t) {
        const double n = noise.next();
        slap.put(n, 300.0 + 3800.0 * std::exp(-t / 0.03), 1.1);
        wet.put(n, 700.0 + 500.0 * std::sin(190.0 * t * (1.0 - t)), 3.0);
        return 1.2 * struck(t, 0.002, 0.035) * slap.low() + 0.5 * struck(t, 0.03, 0.07) * wet.band() +
               0.5 * struck(t, 0.003, 0.05) * body.next(170.0 * std::exp(-6.0 * t) + 50.0);
    });
    for (int i = 0; i < 7; ++i) {
        const double start = 0.03 + 0.26 * noise.unit(), pitch = 500.0 + 900.0 * noise.unit();
        Sine drop(kSampleRate);
        add(sound,
            generated(0.05, [&](double t) { return struck(t, 0.003, 0.012) * drop.next(pitch * (1.0 + 14.0 * t)); }),
            start, 0.16);
    }
    sound.resize(static_cast<std::size_t>(kLength * kSampleRate));
    return sound;
}

/// @param hertz  where the pitch ends; it starts three times as high
Samples drum(double hertz, double length)
{
    Noise noise(5);
    Filter skin(kSampleRate);
    Sine body(kSampleRate);
    return generated(length, [&](double t) {
        skin.put(noise.next(), 900.0);
        return struck(t, 0.003, 0.22 * length) * body.next(hertz * (1.0 + 2.0 * std::exp(-t / 0.025))) +
               0.35 * struck(t, 0.001, 0.012) * skin.low();
    });
}

/// A second of hiss with crackles, which ends where it starts: the tail is blended over the head.
Samples fuse()
{
    constexpr double kLength = 1.2, kBlend = 0.2;
    Noise noise(37);
    Filter hiss(kSampleRate), body(kSampleRate);
    double crackle = 0.0;
    Samples all = generated(kLength + kBlend, [&](double t) {
        const double n = noise.next();
        if (noise.unit() < 45.0 / kSampleRate) crackle = 1.0;
        crackle *= std::exp(-1.0 / (0.0025 * kSampleRate));
        hiss.put(n, 4200.0);
        body.put(n, 1500.0, 1.5);
        return (0.35 + 0.1 * std::sin(31.0 * t)) * hiss.high() + 0.25 * body.band() + 1.1 * crackle * n;
    });
    const auto length = static_cast<std::size_t>(kLength * kSampleRate);
    const std::size_t blend = all.size() - length;
    for (std::size_t i = 0; i < blend; ++i) {
        const float share = static_cast<float>(i) / static_cast<float>(blend);
        // Noise that is not related adds by its squares.
        all[i] = std::sqrt(share) * all[i] + std::sqrt(1.0f - share) * all[length + i];
    }
    all.resize(length);
    return all;
}

Samples explosion()
{
    constexpr double kLength = 2.2;
    Noise noise(41);
    Filter low(kSampleRate), rumble(kSampleRate);
    Sine sub(kSampleRate);
    return generated(kLength, [&](double t) {
        const double n = noise.next();
        low.put(n, 180.0 + 6500.0 * std::exp(-t / 0.10), 0.9);
        rumble.put(n, 130.0, 1.6);
        const double sum = 1.7 * struck(t, 0.002, 0.28) * low.low() + 1.6 * struck(t, 0.05, 0.5) * rumble.low() +
                           0.9 * struck(t, 0.004, 0.3) * sub.next(36.0 + 70.0 * std::exp(-t / 0.09));
        return std::tanh(1.5 * sum);
    });
}

/// A bell: partials of a struck bar (1 : 2.76 : 5.40), the higher the shorter.
Samples bell(double hertz, double length)
{
    struct Partial
    {
        double ratio, gain, share;
    };
    constexpr std::array<Partial, 4> kPartials{
        {{1.0, 1.0, 1.0}, {2.0, 0.35, 0.8}, {2.76, 0.3, 0.45}, {5.4, 0.16, 0.2}}};
    Samples sum;
    for (const Partial& partial : kPartials) {
        Sine sine(kSampleRate);
        add(sum,
            generated(length,
                      [&](double t) {
                          return struck(t, 0.003, 0.22 * length * partial.share) * sine.next(hertz * partial.ratio);
                      }),
            0.0, partial.gain);
    }
    return sum;
}

struct Note
{
    double start, hertz, length, gain;
};

Samples melody(std::initializer_list<Note> notes)
{
    Samples sum;
    for (const Note& note : notes) add(sum, bell(note.hertz, note.length), note.start, note.gain);
    return sum;
}

// Equal temperament, A4 = 440 Hz.
constexpr double kC4 = 261.63, kE4 = 329.63, kG4 = 392.0, kA4 = 440.0, kC5 = 523.25, kE5 = 659.26, kG5 = 783.99,
                 kA5 = 880.0, kC6 = 1046.5, kE6 = 1318.5, kG6 = 1568.0, kC7 = 2093.0;

/// Glass that freezes: high bells and a breath of noise that rises.
Samples freeze()
{
    Samples sum = melody({{0.0, kG6, 0.9, 0.5}, {0.07, kC7, 0.9, 0.45}, {0.14, kE6, 1.0, 0.5}, {0.24, kC7, 0.8, 0.3}});
    Noise noise(53);
    Filter band(kSampleRate);
    add(sum,
        generated(0.9,
                  [&](double t) {
                      band.put(noise.next(), 1500.0 + 6000.0 * t, 3.0);
                      return swell(t, 0.9) * band.band();
                  }),
        0.0, 0.6);
    return sum;
}

Samples click()
{
    Sine sine(kSampleRate);
    return generated(0.06, [&](double t) { return struck(t, 0.001, 0.010) * sine.next(1150.0 - 4000.0 * t); });
}

/// Stone that gives way: a dry snap, a few more behind it, and a short thump below.
Samples crack()
{
    constexpr double kLength = 0.30;
    Noise noise(67);
    Filter snap(kSampleRate);
    Sine body(kSampleRate);
    Samples sound = generated(kLength, [&](double t) {
        snap.put(noise.next(), 1100.0 + 5200.0 * std::exp(-t / 0.012), 1.3);
        return 1.3 * struck(t, 0.0006, 0.014) * snap.band() +
               0.5 * struck(t, 0.002, 0.045) * body.next(95.0 + 160.0 * std::exp(-t / 0.02));
    });
    for (int i = 0; i < 5; ++i) {
        const double start = 0.015 + 0.12 * noise.unit(), pitch = 1500.0 + 3200.0 * noise.unit();
        Filter ring(kSampleRate);
        add(sound,
            generated(0.05,
                      [&](double t) {
                          ring.put(noise.next(), pitch, 4.0);
                          return struck(t, 0.0006, 0.008) * ring.band();
                      }),
            start, 0.5);
    }
    sound.resize(static_cast<std::size_t>(kLength * kSampleRate));
    return sound;
}

/// A heap that comes down: the crack, then many small knocks of all pitches, ever fewer.
Samples shatter()
{
    constexpr double kLength = 1.1;
    constexpr int kKnocks = 46;
    Samples sound = crack();
    sound.resize(static_cast<std::size_t>(kLength * kSampleRate));
    Noise noise(71);
    for (int i = 0; i < kKnocks; ++i) {
        const double share = noise.unit();
        const double start = 0.02 + 0.95 * share * share, pitch = 500.0 + 3600.0 * noise.unit() * noise.unit();
        Filter knock(kSampleRate);
        Noise grain(100 + std::uint64_t(i));
        add(sound,
            generated(0.07,
                      [&](double t) {
                          knock.put(grain.next(), pitch, 7.0);
                          return struck(t, 0.0008, 0.012) * knock.band();
                      }),
            start, 0.75 * (1.0 - share) + 0.1);
    }
    sound.resize(static_cast<std::size_t>(kLength * kSampleRate));
    return sound;
}

struct Recipe
{
    Samples samples;
    double peak;  ///< how loud it is next to the others
};

Recipe recipe(Sound sound)
{
    switch (sound) {
        case Sound::swish:
            return {swish(), 0.35};
        case Sound::splat:
            return {splat(), 0.80};
        case Sound::thud:
            return {drum(62.0, 0.32), 0.45};
        case Sound::miss:
            return {drum(41.0, 0.55), 0.80};
        case Sound::fuse:
            return {fuse(), 0.22};
        case Sound::bomb:
            return {explosion(), kPeak};
        case Sound::chime:
            return {melody({{0.0, kC5, 0.9, 0.8}, {0.06, kE5, 0.9, 0.8}, {0.12, kG5, 1.1, 0.9}}), 0.60};
        case Sound::sparkle:
            return {melody({{0.0, kC6, 0.5, 0.6}, {0.05, kG6, 0.5, 0.5}, {0.10, kC7, 0.7, 0.5}}), 0.50};
        case Sound::freeze:
            return {freeze(), 0.55};
        case Sound::extra_life:
            return {melody({{0.0, kG5, 0.6, 0.8}, {0.10, kC6, 0.6, 0.8}, {0.20, kE6, 1.0, 0.8}}), 0.60};
        case Sound::tick:
            return {bell(kA5, 0.16), 0.40};
        case Sound::start:
            return {melody({{0.0, kC4, 0.5, 0.7}, {0.11, kG4, 0.5, 0.8}, {0.22, kC5, 0.9, 0.9}}), 0.60};
        case Sound::game_over:
            return {melody({{0.0, kA4, 0.9, 0.9}, {0.24, kE4, 0.9, 0.9}, {0.5, kC4, 1.6, 1.0}}), 0.70};
        case Sound::click:
            return {click(), 0.35};
        case Sound::crack:
            return {crack(), 0.75};
        case Sound::shatter:
            return {shatter(), 0.85};
    }
    return {};
}

}  // namespace

std::string_view name_of(Sound sound)
{
    constexpr std::array<std::string_view, kAllSounds.size()> kNames{
        "swish",  "splat",      "thud", "miss",  "fuse",      "bomb",  "chime", "sparkle",
        "freeze", "extra_life", "tick", "start", "game_over", "click", "crack", "shatter"};
    return kNames[static_cast<std::size_t>(sound)];
}

std::vector<float> synthesise(Sound sound)
{
    auto [samples, peak] = recipe(sound);
    if (sound != Sound::fuse) end_softly(samples);
    set_peak(samples, peak);
    return samples;
}

}  // namespace kerf::sound
