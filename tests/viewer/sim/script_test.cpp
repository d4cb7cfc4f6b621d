#include "viewer/sim/script.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <sys/stat.h>

#include <bit>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <sstream>

#include "common/files/file_error.h"
#include "common/support/random.h"
#include "support/temporary_folder.h"

namespace kerf::sim {
namespace {

Script parse(const std::string& text)
{
    std::istringstream in(text);
    return read_script(in, "test.script");
}

std::string complaint(const std::string& text)
{
    try {
        parse(text);
    } catch (const core::io::FileError& error) {
        return error.what();
    }
    return "";
}

TEST(Script, ReadsWhatItsDocumentationShows)
{
    const Script script = parse(
        "# a comment\n\nkerf-script 1\nscene report\nbackend baseline/hash\nproxy box\nseed 42\n"
        "250000 press -1.5 0.25\n258333 move -1.25 0.25\r\n400000 release 1.5 0.25\n900000 command backend halfedge\n");
    EXPECT_EQ(script.scene, "report");
    EXPECT_EQ(script.backend, "baseline/hash");
    EXPECT_EQ(script.proxy, "box");
    EXPECT_EQ(script.seed, 42u);
    ASSERT_EQ(script.events.size(), 4u);
    EXPECT_EQ(script.events[0], (InputEvent{250'000, InputKind::press, {-1.5, 0.25}, ""}));
    EXPECT_EQ(script.events[2].kind, InputKind::release);
    EXPECT_EQ(script.events[3], (InputEvent{900'000, InputKind::command, {}, "backend halfedge"}));
}

RC_GTEST_PROP(Script, WhatIsWrittenReadsBackBitForBit, ())
{
    core::Random random(*rc::gen::resize(rc::kNominalSize, rc::gen::arbitrary<std::uint64_t>()));
    Script script;
    script.scene = "report";
    script.seed = random.next();
    Microseconds time = 0;
    for (std::uint32_t i = random.below(40); i > 0; --i) {
        InputEvent event;
        event.time = time += random.below(100'000);
        event.kind = InputKind(random.below(4));
        if (event.kind == InputKind::command) {
            event.text = "throw rook";
        } else {
            event.position = {20 * random.unit() - 10, (random.unit() - 0.5) * 1e-12};
        }
        script.events.push_back(event);
    }
    std::stringstream text;
    write_script(text, script);
    RC_ASSERT(read_script(text, "test") == script);
}

TEST(Script, EveryMistakeIsNamedWithFileAndLine)
{
    const struct
    {
        const char* text;
        const char* expected;
    } cases[] = {
        {"", "test.script: this is no script"},
        {"hello\n", "test.script:1: this is no script"},
        {"kerf-script\n", "test.script:1: this is no script"},
        {"kerf-script 1 2\n", "test.script:1: this is no script"},
        {"kerf-script 2\n", "test.script:1: script version 2 is not known"},
        {"kerf-script 1\nspeed 3\n", "test.script:2: 'speed' is not known"},
        {"kerf-script 1\nseed\n", "test.script:2: 'seed' needs a value"},
        {"kerf-script 1\nseed -3\n", "test.script:2: '-3' is no seed"},
        {"kerf-script 1\nseed 99999999999999999999999\n", "is no seed"},
        {"kerf-script 1\n10 press 1 2\nseed 3\n", "test.script:3: 'seed' must come before the first event"},
        {"kerf-script 1\n10 jump 1 2\n", "test.script:2: 'jump' is not known"},
        {"kerf-script 1\n10\n", "test.script:2: '' is not known"},
        {"kerf-script 1\n10 press 1\n", "test.script:2: '' is no place"},
        {"kerf-script 1\n10 press 1 nan\n", "test.script:2: 'nan' is no place"},
        {"kerf-script 1\n10 press 1 inf\n", "test.script:2: 'inf' is no place"},
        {"kerf-script 1\n10 press 1 2 3\n", "test.script:2: 'press' takes two numbers"},
        {"kerf-script 1\n1.5 press 1 2\n", "test.script:2: '1.5' is no time"},
        {"kerf-script 1\n99999999999999999999 press 1 2\n", "is no time"},
        {"kerf-script 1\n\n# x\n20 press 1 2\n10 move 1 2\n", "test.script:5: time goes backwards"},
        {"kerf-script 1\n10 command\n", "test.script:2: 'command' needs a text"},
    };
    for (const auto& [text, expected] : cases) {
        const std::string said = complaint(text);
        EXPECT_NE(said.find(expected), std::string::npos) << "for\n" << text << "it says: " << said;
    }
}

TEST(Script, AFileThatIsNoneIsSaidToBe)
{
    EXPECT_THROW(read_script(std::filesystem::path("/nowhere/at/all.script")), core::io::FileError);
    EXPECT_THROW(read_script(std::filesystem::temp_directory_path()), core::io::FileError);
    EXPECT_THROW(write_script(std::filesystem::path("/nowhere/at/all.script"), Script{}), core::io::FileError);
}

TEST(Script, WhatIsNoRegularFileIsRefusedBeforeItIsOpened)
{
    // A pipe that nobody writes to would never open, and a device might never end.
    const test::TemporaryFolder folder;
    const std::filesystem::path pipe = folder.file("pipe.script");
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    EXPECT_THROW(read_script(pipe), core::io::FileError);
    EXPECT_THROW(read_script(std::filesystem::path("/dev/zero")), core::io::FileError);
}

/// A script of moves at these times.
std::string script_of_moves(std::size_t count, const std::function<Microseconds(std::size_t)>& time)
{
    std::string text = "kerf-script 1\n";
    for (std::size_t i = 0; i < count; ++i) text += std::to_string(time(i)) + " move 1 2\n";
    return text;
}

TEST(Script, HasNoMoreEventsAtOnceThanAProgramCanTake)
{
    const auto in_one_moment = [](std::size_t) { return Microseconds{7}; };
    EXPECT_EQ(complaint(script_of_moves(kMostEventsAtOnce, in_one_moment)), "");
    EXPECT_NE(complaint(script_of_moves(kMostEventsAtOnce + 1, in_one_moment))
                  .find("test.script:5002: more than 5000 events within a quarter of a second"),
              std::string::npos);
    // The same number in every quarter of a second, for as long as one likes.
    const auto evenly = [](Microseconds step) { return [step](std::size_t i) { return Microseconds(i) * step; }; };
    constexpr Microseconds kStep = kAtOnce / Microseconds(kMostEventsAtOnce);
    EXPECT_EQ(complaint(script_of_moves(10 * kMostEventsAtOnce, evenly(kStep))), "");
    EXPECT_NE(complaint(script_of_moves(10 * kMostEventsAtOnce, evenly(kStep - 1))), "");
}

TEST(Script, AFileReadsBack)
{
    const test::TemporaryFolder folder;
    const std::filesystem::path path = folder.file("test.script");
    Script script;
    script.scene = "report";
    script.events.push_back({5, InputKind::press, {0.1, -0.2}, ""});
    write_script(path, script);
    EXPECT_EQ(read_script(path), script);
}

}  // namespace
}  // namespace kerf::sim
