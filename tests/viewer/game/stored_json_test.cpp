#include "viewer/game/stored_json.h"

#include <signal.h>
#include <sys/wait.h>

#include "common/support/random.h"
#include "support/brief.h"
#include "support/temporary_folder.h"

namespace kerf::game {
namespace {

using Json = nlohmann::json;
namespace fs = std::filesystem;

std::string anything(const Json&)
{
    return {};
}

class StoredJsonTest : public test::FolderTest
{
protected:
    /// What a program that was killed left beside the file.
    int remove_unfinished() const
    {
        int count = 0;
        for (const fs::directory_entry& entry : fs::directory_iterator(folder_))
            if (entry.path() != file_) count += fs::remove(entry.path()) ? 1 : 0;
        return count;
    }

    fs::path file_ = folder_ / "some.json";
};

}  // namespace

TEST_F(StoredJsonTest, ReadsBackWhatWasWritten)
{
    const Json value{{"a", 1}, {"b", {1, 2, 3}}, {"c", "\u00e4"}};
    EXPECT_EQ(save_json(file_, value), "");
    const StoredJson stored = load_json(file_, anything);
    EXPECT_EQ(stored.value, value);
    EXPECT_EQ(stored.message, "");
}

TEST_F(StoredJsonTest, CreatesItsFolder)
{
    EXPECT_EQ(save_json(folder_ / "a/b/some.json", Json(7)), "");
    EXPECT_EQ(load_json(folder_ / "a/b/some.json", anything).value, 7);
}

TEST_F(StoredJsonTest, FollowsALinkAndLeavesIt)
{
    fs::create_directory(folder_ / "elsewhere");
    fs::create_symlink("elsewhere/real.json", file_);
    EXPECT_EQ(save_json(file_, Json(7)), "");
    EXPECT_TRUE(fs::is_symlink(file_));
    EXPECT_EQ(load_json(folder_ / "elsewhere/real.json", anything).value, 7);
    fs::remove(file_);
    fs::create_symlink("some.json", file_);
    EXPECT_NE(save_json(file_, Json(7)), "");
}

TEST_F(StoredJsonTest, IsNothingWhereThereIsNoFile)
{
    const StoredJson stored = load_json(folder_ / "none/some.json", anything);
    EXPECT_TRUE(stored.value.is_null());
    EXPECT_EQ(stored.message, "");
    EXPECT_TRUE(stored.is_free);
}

TEST_F(StoredJsonTest, SetsADamagedFileAside)
{
    write("some.json", "{\"scores\": [1, ");
    const StoredJson stored = load_json(file_, anything);
    EXPECT_TRUE(stored.value.is_null());
    EXPECT_TRUE(stored.is_free);
    EXPECT_NE(stored.message.find("some.json.damaged"), std::string::npos) << stored.message;
    EXPECT_EQ(text_of("some.json.damaged"), "{\"scores\": [1, ");
    EXPECT_FALSE(exists("some.json"));
}

TEST_F(StoredJsonTest, LeavesADamagedFileWhereOneWasSetAsideBefore)
{
    write("some.json.damaged", "first");
    write("some.json", "second");
    const StoredJson stored = load_json(file_, anything);
    EXPECT_TRUE(stored.value.is_null());
    EXPECT_FALSE(stored.is_free) << "nothing may be written over it";
    EXPECT_NE(stored.message.find("some.json.damaged"), std::string::npos) << stored.message;
    EXPECT_EQ(text_of("some.json.damaged"), "first");
    EXPECT_EQ(text_of("some.json"), "second");
}

TEST_F(StoredJsonTest, SetsAsideWhatItsReaderObjectsTo)
{
    write("some.json", "[1, 2]");
    const StoredJson stored = load_json(file_, [](const Json&) { return std::string("it is a list"); });
    EXPECT_NE(stored.message.find("it is a list"), std::string::npos) << stored.message;
    EXPECT_EQ(text_of("some.json.damaged"), "[1, 2]");
}

TEST_F(StoredJsonTest, ReadsNoHugeFile)
{
    write("some.json", "1");
    fs::resize_file(file_, kMostStoredBytes + 1);
    EXPECT_TRUE(load_json(file_, anything).value.is_null());
    EXPECT_TRUE(exists("some.json.damaged"));
}

TEST_F(StoredJsonTest, StandsDeepNesting)
{
    write("some.json", std::string(test::kBrief ? 200'000 : 1'000'000, '['));
    EXPECT_TRUE(load_json(file_, anything).value.is_null());
    EXPECT_TRUE(exists("some.json.damaged"));
}

TEST_F(StoredJsonTest, LeavesAFolderOfThatNameAlone)
{
    fs::create_directory(file_);
    const StoredJson stored = load_json(file_, anything);
    EXPECT_NE(stored.message, "");
    EXPECT_FALSE(stored.is_free);
    EXPECT_NE(save_json(file_, Json(1)), "");
    EXPECT_TRUE(fs::is_directory(file_));
}

TEST_F(StoredJsonTest, SaysThatItCannotWrite)
{
    write("file", "");
    const std::string message = save_json(folder_ / "file" / "some.json", Json(1));
    EXPECT_NE(message.find("cannot be written"), std::string::npos) << message;
}

TEST_F(StoredJsonTest, WritesTextThatIsNoUtf8)
{
    EXPECT_EQ(save_json(file_, Json("\xff")), "");
    EXPECT_TRUE(load_json(file_, anything).value.is_string());
}

// A child writes large files without a break and is killed in the middle, again and again: what is there afterwards is
// always one whole value, never older than the last one that the child had finished.
TEST_F(StoredJsonTest, SurvivesKillsInTheMiddleOfWriting)
{
    constexpr int kKills = test::kBrief ? 8 : 60;  // under a sanitizer a child takes a second
    constexpr std::size_t kNumbers = 50'000;
    const auto value = [](int n) { return Json(std::vector<int>(kNumbers, n)); };
    ASSERT_EQ(save_json(file_, value(0)), "");
    core::Random random(5);
    int last = 0, caught_writing = 0;
    for (int kill = 0; kill < kKills; ++kill) {
        int finished[2];
        ASSERT_EQ(::pipe(finished), 0);
        const pid_t child = ::fork();
        ASSERT_GE(child, 0);
        if (child == 0) {
            for (int n = last + 1;; ++n) {
                if (!save_json(file_, value(n)).empty()) ::_exit(1);
                if (::write(finished[1], &n, sizeof n) != sizeof n) ::_exit(1);
            }
        }
        ::close(finished[1]);
        int reported = last;
        // Not before the child has begun: let it finish one at least, then wait a random time.
        ASSERT_EQ(::read(finished[0], &reported, sizeof reported), ssize_t(sizeof reported));
        ::usleep(useconds_t(random.below(30'000)));
        ::kill(child, SIGKILL);
        ASSERT_EQ(::waitpid(child, nullptr, 0), child);
        while (::read(finished[0], &reported, sizeof reported) == ssize_t(sizeof reported)) {
        }
        ::close(finished[0]);
        caught_writing += remove_unfinished();

        const StoredJson stored = load_json(file_, anything);
        ASSERT_EQ(stored.message, "");
        ASSERT_EQ(stored.value.size(), kNumbers);
        const int found = stored.value.front();
        ASSERT_EQ(stored.value.back(), found);
        ASSERT_GE(found, reported);
        last = found;
    }
    EXPECT_GT(caught_writing, 0) << "no kill met the child while it was writing: the test has proved nothing";
}

}  // namespace kerf::game
