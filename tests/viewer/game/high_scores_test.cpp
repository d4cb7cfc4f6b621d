#include "viewer/game/high_scores.h"

#include <signal.h>
#include <sys/wait.h>

#include <nlohmann/json.hpp>

#include "support/temporary_folder.h"

namespace kerf::game {
namespace {

using Json = nlohmann::json;

HighScore score(std::int64_t points, std::uint64_t seed = 1)
{
    return {points, "2026-11-21T15:08:00Z", "halfedge", seed, points / 2, 3};
}

class HighScoresTest : public test::FolderTest
{
};

}  // namespace

TEST_F(HighScoresTest, AreEmptyAtFirst)
{
    HighScores scores(folder_);
    for (const GameMode mode : kGameModes) {
        EXPECT_TRUE(scores.of(mode).empty());
        EXPECT_EQ(scores.best(mode), 0);
    }
    EXPECT_EQ(scores.take_message(), "");
    EXPECT_FALSE(exists("scores.json")) << "looking writes nothing";
}

TEST_F(HighScoresTest, AreThereInTheNextProgram)
{
    EXPECT_EQ(HighScores(folder_).add(GameMode::zen, score(40, 7)), 0u);
    EXPECT_EQ(HighScores(folder_).add(GameMode::classic, score(12)), 0u);
    const HighScores scores(folder_);
    ASSERT_EQ(scores.of(GameMode::zen).size(), 1u);
    EXPECT_EQ(scores.of(GameMode::zen)[0], score(40, 7));
    EXPECT_EQ(scores.best(GameMode::classic), 12);
    EXPECT_EQ(scores.best(GameMode::arcade), 0);
}

TEST_F(HighScoresTest, KeepTheBestTenInOrder)
{
    HighScores scores(folder_);
    for (const std::int64_t points : {5, 50, 20, 90, 10, 70, 30, 80, 40, 60}) scores.add(GameMode::zen, score(points));
    EXPECT_EQ(scores.add(GameMode::zen, score(55)), 4u);
    EXPECT_FALSE(scores.add(GameMode::zen, score(5)));
    EXPECT_FALSE(scores.add(GameMode::zen, score(10))) << "the earlier game keeps its place";
    std::vector<std::int64_t> points;
    const HighScores stored(folder_);
    for (const HighScore& each : stored.of(GameMode::zen)) points.push_back(each.score);
    EXPECT_EQ(points, (std::vector<std::int64_t>{90, 80, 70, 60, 55, 50, 40, 30, 20, 10}));
}

TEST_F(HighScoresTest, PutAnEqualGameBehindTheEarlierOne)
{
    HighScores scores(folder_);
    scores.add(GameMode::zen, score(10, 1));
    EXPECT_EQ(scores.add(GameMode::zen, score(10, 2)), 1u);
}

TEST_F(HighScoresTest, HaveNoPlaceForNothing)
{
    HighScores scores(folder_);
    EXPECT_FALSE(scores.add(GameMode::zen, score(0)));
    EXPECT_TRUE(scores.of(GameMode::zen).empty());
}

TEST_F(HighScoresTest, LoseNothingBetweenTwoPrograms)
{
    HighScores one(folder_), two(folder_);
    one.add(GameMode::zen, score(10));
    two.add(GameMode::zen, score(20));
    EXPECT_EQ(HighScores(folder_).of(GameMode::zen).size(), 2u);
}

TEST_F(HighScoresTest, WorkWithoutAFolder)
{
    HighScores scores({});
    EXPECT_EQ(scores.add(GameMode::zen, score(10)), 0u);
    EXPECT_EQ(scores.best(GameMode::zen), 10);
    EXPECT_EQ(scores.take_message(), "");
}

TEST_F(HighScoresTest, SetADamagedFileAsideAndGoOn)
{
    const Json good{{"format", "kerf-scores"}, {"version", 1}, {"modes", {{"zen", {{{"score", -1}}}}}}};
    for (const std::string& text :
         {std::string("{\"format\": \"kerf-sco"), std::string("[]"), std::string("{}"), good.dump(),
          Json{{"format", "kerf-scores"}, {"version", 0}, {"modes", Json::object()}}.dump()}) {
        write("scores.json", text);
        HighScores scores(folder_);
        EXPECT_NE(scores.take_message().find("scores.json.damaged"), std::string::npos) << text;
        EXPECT_EQ(scores.take_message(), "") << "it is said once";
        EXPECT_EQ(text_of("scores.json.damaged"), text);
        EXPECT_EQ(scores.add(GameMode::zen, score(10)), 0u);
        EXPECT_EQ(HighScores(folder_).best(GameMode::zen), 10);
        std::filesystem::remove(folder_ / "scores.json.damaged");
    }
}

TEST_F(HighScoresTest, LeaveTheFileOfALaterVersionAlone)
{
    const std::string later = Json{{"format", "kerf-scores"}, {"version", 2}, {"modes", {{"zen", "?"}}}}.dump();
    write("scores.json", later);
    HighScores scores(folder_);
    EXPECT_NE(scores.take_message().find("later version"), std::string::npos);
    EXPECT_EQ(scores.add(GameMode::zen, score(10)), 0u);
    EXPECT_NE(scores.take_message(), "") << "that this score is not stored";
    EXPECT_EQ(scores.best(GameMode::zen), 10) << "until the program ends";
    EXPECT_EQ(text_of("scores.json"), later);
    EXPECT_FALSE(exists("scores.json.damaged"));
}

TEST_F(HighScoresTest, SayThatTheyCannotBeStored)
{
    write("file", "");
    HighScores scores(folder_ / "file");
    scores.take_message();
    EXPECT_EQ(scores.add(GameMode::zen, score(10)), 0u);
    EXPECT_NE(scores.take_message(), "");
    EXPECT_EQ(scores.add(GameMode::zen, score(20)), 0u);
    EXPECT_EQ(scores.of(GameMode::zen).size(), 2u) << "until the program ends";
}

TEST_F(HighScoresTest, HoldWhatAGameOverSays)
{
    GameState state;
    state.score = 123;
    state.counts.fruit_cut = 45;
    state.counts.longest_combo = 6;
    const HighScore made = score_of(state, "baseline", 9);
    EXPECT_EQ(made.score, 123);
    EXPECT_EQ(made.fruit, 45);
    EXPECT_EQ(made.longest_combo, 6);
    EXPECT_EQ(made.seed, 9u);
    ASSERT_EQ(made.date.size(), 20u) << made.date;
    EXPECT_EQ(made.date.back(), 'Z');
}

TEST_F(HighScoresTest, SurviveKills)
{
    std::int64_t last = 0;
    for (int kill = 0; kill < 40; ++kill) {
        int finished[2];
        ASSERT_EQ(::pipe(finished), 0);
        const pid_t child = ::fork();
        ASSERT_GE(child, 0);
        if (child == 0) {
            HighScores scores(folder_);
            for (std::int64_t points = last + 1;; ++points) {
                scores.add(GameMode::classic, score(points));
                if (::write(finished[1], &points, sizeof points) != sizeof points) ::_exit(1);
            }
        }
        ::close(finished[1]);
        std::int64_t reported = last;
        ASSERT_EQ(::read(finished[0], &reported, sizeof reported), ssize_t(sizeof reported));
        ::usleep(useconds_t(100 * kill));
        ::kill(child, SIGKILL);
        ASSERT_EQ(::waitpid(child, nullptr, 0), child);
        while (::read(finished[0], &reported, sizeof reported) == ssize_t(sizeof reported)) {
        }
        ::close(finished[0]);
        HighScores scores(folder_);
        ASSERT_EQ(scores.take_message(), "");
        ASSERT_GE(scores.best(GameMode::classic), reported);
        last = scores.best(GameMode::classic);
    }
}

}  // namespace kerf::game
