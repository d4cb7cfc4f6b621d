#include "viewer/sound/speaker.h"

#include <AL/al.h>
#include <AL/alc.h>
#include <dlfcn.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <future>
#include <vector>

#include "viewer/sound/synthesis.h"

namespace kerf::sound {

namespace {

using Words = std::vector<std::int16_t>;

/// Every sound as OpenAL wants it: a third of a second of work.
std::array<Words, kAllSounds.size()> all_words()
{
    std::array<Words, kAllSounds.size()> all;
    for (const Sound sound : kAllSounds)
        for (const float sample : synthesise(sound))
            all[static_cast<std::size_t>(sound)].push_back(static_cast<std::int16_t>(std::lround(32767.0f * sample)));
    return all;
}

void say_nothing(const char*, int, const char*, int, const char*, ...) {}

/// A player without a sound device does not want to read about it: ALSA and OpenAL say on stderr what they can't find.
/// OpenAL's messages come back with ALSOFT_LOGLEVEL in the environment.
void hush()
{
    ::setenv("ALSOFT_LOGLEVEL", "0", 0);
    // OpenAL brings ALSA along or does not; it stays loaded, with a function that says nothing.
    using Handler = void (*)(const char*, int, const char*, int, const char*, ...);
    using SetHandler = int (*)(Handler);
    void* const alsa = ::dlopen("libasound.so.2", RTLD_LAZY);
    if (alsa == nullptr) return;
    if (void* const found = ::dlsym(alsa, "snd_lib_error_set_handler"))
        reinterpret_cast<SetHandler>(found)(say_nothing);
}

}  // namespace

/// OpenAL's names, and what frees them in the right order.
struct Speaker::Device
{
    ALCdevice* device = nullptr;
    ALCcontext* context = nullptr;
    std::array<ALuint, kAllSounds.size()> buffers{};
    std::array<ALuint, kVoices> voices{};  ///< the first is the fuse's
    std::size_t next_voice = 1;
    std::future<std::array<Words, kAllSounds.size()>> samples;  ///< being computed while the program opens its window

    ~Device()
    {
        if (context != nullptr) {
            for (const ALuint voice : voices) alSourceStop(voice);
            alDeleteSources(kVoices, voices.data());
            alDeleteBuffers(static_cast<ALsizei>(buffers.size()), buffers.data());
            alcMakeContextCurrent(nullptr);
            alcDestroyContext(context);
        }
        if (device != nullptr) alcCloseDevice(device);
    }

    /// Null when there is nothing to hear with.
    static std::unique_ptr<Device> open()
    {
        hush();
        auto opened = std::make_unique<Device>();
        opened->device = alcOpenDevice(nullptr);
        if (opened->device == nullptr) return nullptr;
        opened->context = alcCreateContext(opened->device, nullptr);
        if (opened->context == nullptr || alcMakeContextCurrent(opened->context) == ALC_FALSE) return nullptr;
        alGetError();
        alGenSources(kVoices, opened->voices.data());
        alGenBuffers(static_cast<ALsizei>(opened->buffers.size()), opened->buffers.data());
        opened->samples = std::async(std::launch::async, all_words);
        return alGetError() == AL_NO_ERROR ? std::move(opened) : nullptr;
    }

    ALuint buffer(Sound sound) const { return buffers[static_cast<std::size_t>(sound)]; }

    /// Before the first sound.
    void fill_buffers()
    {
        if (!samples.valid()) return;
        const auto all = samples.get();
        for (std::size_t i = 0; i < all.size(); ++i)
            alBufferData(buffers[i], AL_FORMAT_MONO16, all[i].data(),
                         static_cast<ALsizei>(all[i].size() * sizeof(std::int16_t)), kSampleRate);
    }

    void play(ALuint voice, Sound sound, const Playing& how, bool repeated)
    {
        constexpr float kWidth = 0.7f;  // of the stage before the listener, in its distance
        fill_buffers();
        alSourceStop(voice);
        alSourcei(voice, AL_BUFFER, static_cast<ALint>(buffer(sound)));
        alSourcei(voice, AL_LOOPING, repeated ? AL_TRUE : AL_FALSE);
        alSourcei(voice, AL_SOURCE_RELATIVE, AL_TRUE);
        alSource3f(voice, AL_POSITION, kWidth * static_cast<float>(how.pan), 0.0f, -1.0f);
        alSourcef(voice, AL_ROLLOFF_FACTOR, 0.0f);
        alSourcef(voice, AL_GAIN, static_cast<float>(std::clamp(how.gain, 0.0, 1.0)));
        alSourcef(voice, AL_PITCH, static_cast<float>(std::clamp(how.pitch, 0.25, 4.0)));
        alSourcePlay(voice);
    }

    static bool is_playing(ALuint voice)
    {
        ALint state = AL_STOPPED;
        alGetSourcei(voice, AL_SOURCE_STATE, &state);
        return state == AL_PLAYING;
    }
};

Speaker::Speaker() : Speaker(Device::open()) {}

Speaker Speaker::silent()
{
    return Speaker(std::unique_ptr<Device>());
}

Speaker::Speaker(std::unique_ptr<Device> device) : device_(std::move(device))
{
    apply_volume();
}

Speaker::~Speaker() = default;
Speaker::Speaker(Speaker&&) noexcept = default;
Speaker& Speaker::operator=(Speaker&&) noexcept = default;

void Speaker::play(Sound sound, const Playing& how)
{
    if (!device_) return;
    Device& d = *device_;
    // A voice that is silent, or the one that has been heard longest.
    std::size_t chosen = d.next_voice;
    for (std::size_t i = 0; i + 1 < d.voices.size(); ++i) {
        const std::size_t candidate = 1 + (d.next_voice - 1 + i) % (d.voices.size() - 1);
        if (Device::is_playing(d.voices[candidate])) continue;
        chosen = candidate;
        break;
    }
    d.next_voice = 1 + chosen % (d.voices.size() - 1);
    d.play(d.voices[chosen], sound, how, false);
}

void Speaker::set_fuse(bool burning)
{
    fuse_burns_ = burning;
    if (!device_ || Device::is_playing(device_->voices.front()) == burning) return;
    if (burning)
        device_->play(device_->voices.front(), Sound::fuse, {}, true);
    else
        alSourceStop(device_->voices.front());
}

void Speaker::silence()
{
    if (device_) alSourceStopv(kVoices, device_->voices.data());
}

void Speaker::set_volume(double volume)
{
    volume_ = volume > 0.0 ? std::min(volume, 1.0) : 0.0;
    apply_volume();
}

void Speaker::set_muted(bool muted)
{
    muted_ = muted;
    apply_volume();
}

void Speaker::apply_volume()
{
    // Loudness is heard as a power of the amplitude: a slider at the middle should sound half as loud.
    if (device_) alListenerf(AL_GAIN, muted_ ? 0.0f : static_cast<float>(volume_ * volume_));
}

}  // namespace kerf::sound
