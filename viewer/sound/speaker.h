#pragma once

#include <memory>

#include "viewer/sound/sounds.h"

namespace kerf::sound {

/// How a sound is played.
struct Playing
{
    double gain = 1.0;   ///< 0 to 1
    double pitch = 1.0;  ///< 2: an octave higher, and twice as fast
    double pan = 0.0;    ///< -1: left, 1: right
};

/// Where sounds come out (OpenAL). Without a sound device everything is accepted and nothing is heard. Calls never fail
/// and, once the first sound was played, return at once; more sounds at a time than kVoices, and the oldest makes room.
class Speaker
{
public:
    static constexpr int kVoices = 24;

    /// Looks for a sound device; the sounds are computed by another thread meanwhile.
    Speaker();
    /// A speaker that never looks for a device: for runs that nobody listens to.
    static Speaker silent();
    ~Speaker();
    Speaker(Speaker&&) noexcept;
    Speaker& operator=(Speaker&&) noexcept;

    bool has_device() const { return device_ != nullptr; }

    void play(Sound sound, const Playing& how = {});
    /// Repeats Sound::fuse until it is turned off, at most once at a time.
    void set_fuse(bool burning);
    bool fuse_burns() const { return fuse_burns_; }
    void silence();  ///< ends everything that is heard

    void set_volume(double volume);  ///< 0 to 1; beyond that the nearer end; not a number: 0
    void set_muted(bool muted);
    double volume() const { return volume_; }
    bool muted() const { return muted_; }

private:
    struct Device;
    explicit Speaker(std::unique_ptr<Device> device);
    void apply_volume();

    std::unique_ptr<Device> device_;
    double volume_ = 0.8;
    bool muted_ = false;
    bool fuse_burns_ = false;
};

}  // namespace kerf::sound
