#pragma once

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "support/temporary_folder.h"

// Runs the built program as a user would, in a folder of its own.

namespace kerf::tools {

using Json = nlohmann::json;

struct Outcome
{
    int status = -1;  ///< exit status; 128 + n when signal n ended it
    std::string out, err;

    /// Lines of standard error.
    std::ptrdiff_t error_lines() const { return std::count(err.begin(), err.end(), '\n'); }
};

class ProgramTest : public test::FolderTest
{
protected:
    /// Runs `kerf ARGUMENTS` in a shell, with the folder as working directory. `before` is shell, too.
    Outcome kerf(const std::string& arguments, const std::string& before = "") const
    {
        const std::string streams = folder_.string() + ".streams";
        const std::string command = "cd '" + folder_.string() + "' && { " + before + " '" KERF_PROGRAM "' " +
                                    arguments + "; } >'" + streams + ".out' 2>'" + streams + ".err'";
        const int status = std::system(command.c_str());
        Outcome outcome;
        outcome.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
        outcome.out = read_text(streams + ".out");
        outcome.err = read_text(streams + ".err");
        std::filesystem::remove(streams + ".out");
        std::filesystem::remove(streams + ".err");
        return outcome;
    }

    /// What `kerf ARGUMENTS --json` prints; fails the test when it does not succeed.
    Json kerf_json(const std::string& arguments) const
    {
        const Outcome outcome = kerf(arguments + " --json");
        EXPECT_EQ(outcome.status, 0) << arguments << ": " << outcome.err;
        EXPECT_EQ(outcome.err, "");
        Json json = Json::parse(outcome.out, nullptr, false);
        EXPECT_FALSE(json.is_discarded()) << outcome.out;
        return json;
    }
};

/// A file or mesh that cannot be used: exit 1, one line on standard error that says `reason`, nothing on standard
/// output.
inline void expect_unusable(const Outcome& outcome, const std::string& reason)
{
    EXPECT_EQ(outcome.status, 1) << outcome.err;
    EXPECT_EQ(outcome.error_lines(), 1) << outcome.err;
    EXPECT_NE(outcome.err.find(reason), std::string::npos) << outcome.err;
    EXPECT_EQ(outcome.out, "");
}

}  // namespace kerf::tools
