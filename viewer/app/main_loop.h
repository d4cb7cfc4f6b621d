#pragma once

#include <cstdint>
#include <filesystem>
#include <glm/vec2.hpp>
#include <optional>

#include "common/support/stopwatch.h"
#include "viewer/app/display.h"
#include "viewer/render/gl_error_log.h"
#include "viewer/render/picture.h"

namespace kerf::app {

/// What a frame's time is.
enum class Pace
{
    real_time,   ///< what the clock on the wall says
    fixed_step,  ///< two ticks, so that a run is the same on every machine
};

/// A frame of the main loop.
struct Frame
{
    std::int64_t number = 0;  ///< from 0
    Pace pace = Pace::real_time;
    double seconds = 0.0;  ///< since the frame before, on the clock on the wall whatever the pace
    bool is_last = false;
};

/// What the main loop runs: the game, or one simulation to look at, in a window or without.
class Program
{
public:
    virtual ~Program() = default;

    /// It has nothing more to do.
    virtual bool has_ended() const { return false; }
    /// Takes input and lets a frame go by. @throws core::io::FileError, render::RenderError
    virtual void advance(const Frame& frame) = 0;
    /// Uploads what is new, for a frame that nobody sees. @throws render::RenderError
    virtual void sync() = 0;
    /// Uploads what is new and draws the picture with all that is written over it.
    /// @param size  pixels, at least 1x1
    /// @throws render::RenderError
    virtual void draw(const Frame& frame, const glm::ivec2& size) = 0;
    /// The picture that was drawn is finished, so long after its frame began.
    virtual void take_frame_time(double /*ms*/) {}
    /// The picture that was drawn last.
    virtual const render::FrameTarget& picture() const = 0;
};

/// How long a loop goes on, and what it leaves behind.
struct LoopPlan
{
    Pace pace = Pace::real_time;
    std::int64_t frames = 0;                ///< 0: until the display is closed or the program has ended
    int draw_every = 1;                     ///< pictures; 0: only those that are written
    std::filesystem::path screenshot = {};  ///< of the last frame; empty: none
    std::filesystem::path record = {};      ///< folder for all frames; empty: none
};

/// The one loop of every program: input, ticks, picture, over and over.
class MainLoop
{
public:
    /// All outlive it. @throws core::io::FileError  the folder of a recording cannot be made
    MainLoop(Program& program, Display& display, render::GlErrorLog& errors, LoopPlan plan);

    /// One frame. False when it was the last. @throws core::io::FileError, render::RenderError
    bool frame();
    void run();

private:
    bool is_drawn(const Frame& frame) const;
    void draw(const Frame& frame, const glm::ivec2& size);

    Program& program_;
    Display& display_;
    render::GlErrorLog& errors_;
    LoopPlan plan_;
    std::optional<render::Recording> recording_;
    std::int64_t number_ = 0;
    core::Stopwatch since_last_, in_frame_;
};

}  // namespace kerf::app
