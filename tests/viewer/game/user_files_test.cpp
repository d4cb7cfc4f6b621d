#include "viewer/game/user_files.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include "viewer/game/folder_test.h"

namespace kerf::game {
namespace {

HighScore high_score(std::int64_t points)
{
    return {points, "2026-11-21T15:08:00Z", "halfedge", 1, points / 2, 3};
}

class UserFilesTest : public test::FolderTest
{
protected:
    /// As another program that writes does.
    int hold(const std::string& name) const
    {
        const int descriptor = ::open((folder_ / name).c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0644);
        EXPECT_EQ(::flock(descriptor, LOCK_EX | LOCK_NB), 0);
        return descriptor;
    }
};

}  // namespace

TEST_F(UserFilesTest, AreThereInTheNextProgram)
{
    {
        UserFiles files(folder_);
        EXPECT_EQ(files.add(GameMode::zen, high_score(40)), 0u);
        EXPECT_EQ(files.best(GameMode::zen), 40) << "known at once";
        StoredSettings settings;
        for (int i = 0; i <= 10; ++i) {
            settings.volume = 0.1 * i;
            files.store(settings);
        }
    }
    EXPECT_EQ(HighScores(folder_).best(GameMode::zen), 40);
    EXPECT_EQ(load_settings(folder_).settings.volume, 1.0) << "the last";
}

TEST_F(UserFilesTest, NeverWaitForAnotherProgramAndWriteWhenItIsDone)
{
    {
        const int scores = hold("scores.json.lock"), settings = hold("settings.json.lock");
        UserFiles files(folder_);
        StoredSettings quiet;
        quiet.mute = true;
        // If these waited, they would wait forever: nobody else lets the locks go.
        EXPECT_EQ(files.add(GameMode::zen, high_score(40)), 0u);
        files.store(quiet);
        EXPECT_FALSE(exists("scores.json"));
        ::close(scores);
        ::close(settings);
    }
    EXPECT_EQ(HighScores(folder_).best(GameMode::zen), 40);
    EXPECT_TRUE(load_settings(folder_).settings.mute);
}

TEST_F(UserFilesTest, EndThoughAnotherProgramNeverLetsGo)
{
    const int scores = hold("scores.json.lock");
    {
        UserFiles files(folder_);
        files.add(GameMode::zen, high_score(40));
    }
    EXPECT_FALSE(exists("scores.json"));
    ::close(scores);
}

TEST_F(UserFilesTest, AddToWhatAnotherProgramStoredMeanwhile)
{
    {
        UserFiles files(folder_);
        HighScores(folder_).add(GameMode::zen, high_score(50));
        EXPECT_EQ(files.add(GameMode::zen, high_score(40)), 0u);
    }
    EXPECT_EQ(HighScores(folder_).of(GameMode::zen).size(), 2u);
}

TEST_F(UserFilesTest, SayWhatWentWrong)
{
    write("file", "");
    UserFiles files(folder_ / "file");
    std::string message = files.take_message();
    files.store({});
    for (int i = 0; i < 10'000 && message.empty(); ++i) {
        ::usleep(1000);
        message = files.take_message();
    }
    EXPECT_NE(message, "");
}

TEST_F(UserFilesTest, WorkWithoutAFolder)
{
    UserFiles files({});
    EXPECT_EQ(files.add(GameMode::zen, high_score(10)), 0u);
    files.store({});
    EXPECT_EQ(files.best(GameMode::zen), 10);
    EXPECT_EQ(files.take_message(), "");
}

}  // namespace kerf::game
