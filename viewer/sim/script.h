#pragma once

#include <filesystem>
#include <glm/vec2.hpp>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "viewer/sim/ticks.h"

namespace kerf::sim {

/// What a player can do.
enum class InputKind : std::uint8_t
{
    press,    ///< position
    move,     ///< position
    release,  ///< position
    command,  ///< text: a command of the simulation or the scene ("throw", "repeat", "backend halfedge", ...)
};

/// One thing that a player did, and when.
struct InputEvent
{
    Microseconds time = 0;  ///< simulation time
    InputKind kind = InputKind::move;
    glm::dvec2 position{0.0};  ///< on the stage (the plane z = 0), metres
    std::string text;

    friend bool operator==(const InputEvent&, const InputEvent&) = default;
};

/// A recorded run: what it was started with and everything that the player did. A text file, one statement a line:
///
///     kerf-script 1
///     scene report
///     backend halfedge
///     proxy bounded_hull
///     seed 42
///     250000 press -1.5 0.25
///     258333 move -1.25 0.25
///     400000 release 1.5 0.25
///     900000 command repeat
///
/// Times in microseconds of simulation time, which never decrease; places in metres on the stage. Numbers are written
/// so that they read back bit for bit. Lines that start with # and empty lines are skipped. Header lines may be left
/// out.
struct Script
{
    std::string scene, backend, proxy;  ///< empty: not said
    std::optional<std::uint64_t> seed;
    std::vector<InputEvent> events;

    friend bool operator==(const Script&, const Script&) = default;
};

/// No script has more events than this within kAtOnce: three times what the fastest mouse sends. Each may meet every
/// body, so that more would hold the program up.
inline constexpr std::size_t kMostEventsAtOnce = 5000;
inline constexpr Microseconds kAtOnce = 250'000;

/// @param name  how messages call the source
/// @throws core::io::FileError  "NAME:LINE: ..." for the first line that is wrong, "NAME: ..." when there is none
Script read_script(std::istream& in, const std::string& name);
/// From a regular file.
Script read_script(const std::filesystem::path& path);

void write_script(std::ostream& out, const Script& script);
/// Complete or not at all.
/// @throws core::io::FileError
void write_script(const std::filesystem::path& path, const Script& script);

}  // namespace kerf::sim
