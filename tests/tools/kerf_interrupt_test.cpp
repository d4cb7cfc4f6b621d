#include <algorithm>
#include <csignal>
#include <random>

#include "common/support/stopwatch.h"
#include "tools/program.h"

namespace kerf::tools {
namespace {

class KerfInterrupt : public ProgramTest
{
protected:
    void expect_all_or_nothing_whenever_interrupted(const std::string& command, std::size_t interruptions);
};

void KerfInterrupt::expect_all_or_nothing_whenever_interrupted(const std::string& command, std::size_t interruptions)
{
    const std::vector<std::string> before = names_in_folder();
    core::Stopwatch watch;
    ASSERT_EQ(kerf(command).status, 0);
    double ms = watch.lap();
    const std::vector<std::string> all = names_in_folder();
    ASSERT_GT(all.size(), 300u);

    const std::vector<std::pair<std::string, int>> signals{{"INT", SIGINT},   {"TERM", SIGTERM},  {"HUP", SIGHUP},
                                                           {"QUIT", SIGQUIT}, {"PIPE", SIGPIPE},  {"ALRM", SIGALRM},
                                                           {"XCPU", SIGXCPU}, {"ABRT", SIGABRT},  {"USR1", SIGUSR1},
                                                           {"PROF", SIGPROF}, {"RTMIN", SIGRTMIN}};
    // As many as it takes: where a cut came to its end before its signal, the next signals come earlier.
    constexpr std::size_t kMostRounds = 1000;
    std::size_t interrupted = 0;
    std::mt19937 random(20261122);
    for (std::size_t round = 0; interrupted < interruptions; ++round) {
        ASSERT_LT(round, kMostRounds) << "only " << interrupted << " signals had an effect";
        for (const std::string& name : all)
            if (std::ranges::find(before, name) == before.end()) std::filesystem::remove(folder_ / name);
        const double seconds = 0.001 * std::uniform_real_distribution(0.0, 1.1 * ms)(random);
        const auto& [name, number] = signals[round % signals.size()];
        const Outcome outcome =
            kerf(command, "ulimit -c 0; timeout --preserve-status -s " + name + " " + std::to_string(seconds));
        const std::vector<std::string> names = names_in_folder();
        if (outcome.status == 0) {
            EXPECT_EQ(names, all);
            ms *= 0.9;  // it was faster than thought
            continue;
        }
        ++interrupted;
        EXPECT_EQ(outcome.status, 128 + number) << name;
        EXPECT_TRUE(names == before || names == all)
            << names.size() << " files after " << name << " at " << seconds << " s";
    }
}

TEST_F(KerfInterrupt, ACutIntoHundredsOfFilesLeavesAllOrNothingWheneverItIsInterrupted)
{
    ASSERT_EQ(kerf("shape comb -n 9600 -o comb.ply").status, 0);
    expect_all_or_nothing_whenever_interrupted(
        "cut comb.ply --backend baseline --normal 0,1,0 --point 0,0.2,0 --components --format stl --out q", 44);
}

TEST_F(KerfInterrupt, AStackOfHundredsOfLayersLeavesAllOrNothingWheneverItIsInterrupted)
{
    ASSERT_EQ(kerf("shape asteroid -n 5000 -o rock.ply").status, 0);
    expect_all_or_nothing_whenever_interrupted("section rock.ply --count 400 --each -o layer.svg", 22);
}

TEST_F(KerfInterrupt, ASignalThatIsIgnoredByNohupStaysIgnored)
{
    const Outcome outcome =
        kerf("shape asteroid -n 100000 -o rock.stl & sleep 0.02; kill -HUP $!; wait $!", "trap '' HUP;");
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(names_in_folder(), std::vector<std::string>{"rock.stl"});
}

TEST_F(KerfInterrupt, AFileBeyondTheLimitOfItsSizeIsASentenceAndLeavesNothing)
{
    for (const char* format : {"obj", "ply", "stl", "glb"})
        expect_unusable(kerf("shape asteroid -n 10000 -o rock." + std::string(format), "ulimit -f 20;"),
                        "cannot be written");
    EXPECT_EQ(names_in_folder(), std::vector<std::string>{});
}

}  // namespace
}  // namespace kerf::tools
