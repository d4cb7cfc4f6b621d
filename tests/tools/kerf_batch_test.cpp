#include <map>
#include <sstream>

#include "support/brief.h"
#include "tools/program.h"

namespace kerf::tools {
namespace {

class KerfBatch : public ProgramTest
{
protected:
    void SetUp() override
    {
        ProgramTest::SetUp();
        ASSERT_EQ(kerf("shape asteroid -n 2000 -o rock.ply").status, 0);
    }

    /// So many planes across z, the last of which misses.
    void write_planes(std::size_t count) const
    {
        std::string jobs;
        for (std::size_t i = 0; i + 1 < count; ++i)
            jobs += R"({"plane": "z=)" + std::to_string(-0.8 + 1.6 * double(i) / double(count)) + "\"}\n";
        write("jobs.jsonl", jobs + "{\"plane\": \"z=9\"}\n");
    }

    static std::vector<Json> lines_of(const std::string& text)
    {
        std::vector<Json> lines;
        std::istringstream stream(text);
        for (std::string line; std::getline(stream, line);) lines.push_back(Json::parse(line));
        return lines;
    }

    static std::vector<std::string> names_of(const std::map<std::string, std::string>& files)
    {
        std::vector<std::string> names;
        for (const auto& [name, content] : files) names.push_back(name);
        return names;
    }

    /// What is in the files that a batch has written.
    std::map<std::string, std::string> written(const std::string& folder) const
    {
        std::map<std::string, std::string> contents;
        for (const auto& entry : std::filesystem::directory_iterator(folder_ / folder))
            contents[entry.path().filename().string()] = read_text(entry.path());
        return contents;
    }
};

TEST_F(KerfBatch, WritesWhatSingleCutsWriteInTheOrderOfTheJobs)
{
    write("jobs.jsonl",
          "{\"plane\": \"z=0.1\"}\n\n"
          "{\"normal\": [1, 2, 3], \"point\": [0.1, 0, 0], \"name\": \"slanted\", \"gap\": 0.1}\n"
          "{\"through\": [[0,0,0],[1,0,0],[0,1,1]], \"cap\": false}\n"
          "{\"plane\": \"x=0\", \"components\": true}\n");
    std::filesystem::create_directory(folder_ / "b");
    const Outcome outcome = kerf("cut rock.ply --batch jobs.jsonl --format ply --out b/rock -j 3");
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    const std::vector<Json> lines = lines_of(outcome.out);
    ASSERT_EQ(lines.size(), 4u);
    const std::vector<std::string> names{"0001", "slanted", "0003", "0004"};
    const std::vector<std::string> commands{"--plane z=0.1", "--normal 1,2,3 --point 0.1,0,0 --gap 0.1",
                                            "--through 0,0,0 1,0,0 0,1,1 --no-cap", "--plane x=0 --components"};
    std::filesystem::create_directory(folder_ / "s");
    for (std::size_t i = 0; i < 4; ++i) {
        Json line = lines[i];
        EXPECT_EQ(line["job"], i + 1);
        EXPECT_EQ(line["name"], names[i]);
        const std::string prefix = "s/rock." + names[i];
        Json single = kerf_json("cut rock.ply --format ply --out " + prefix + " " + commands[i]);
        for (const char* key : {"job", "name", "key"}) line.erase(key);
        single.erase("time_ms");
        for (const char* side : {"positive", "negative"}) {
            for (Json& piece : single[side]["pieces"]) piece["file"] = "b" + piece["file"].get<std::string>().substr(1);
            for (Json& piece : line[side]["pieces"]) piece.erase("key");
        }
        EXPECT_EQ(line, single);
    }
    EXPECT_TRUE(written("b") == written("s"));
}

TEST_F(KerfBatch, ReadsTheMeshOnce)
{
    write_planes(50);
    std::filesystem::create_directory(folder_ / "b");
    // A pipe can be read once.
    const Outcome piped = kerf("cut - --from ply --batch jobs.jsonl --format ply --out b/rock", "cat rock.ply |");
    EXPECT_EQ(piped.status, 0) << piped.err;
    EXPECT_EQ(lines_of(piped.out).size(), 50u);
    EXPECT_EQ(written("b").size(), 98u);
}

TEST_F(KerfBatch, GoesOnWhereItWasInterruptedAndTheFilesAreTheSame)
{
    const std::size_t count = test::kBrief ? 60 : 300;
    write_planes(count);
    const auto batch = [](const std::string& folder) {
        return "cut rock.ply --batch jobs.jsonl --format ply -j 2 --out " + folder + "/rock --results " + folder +
               ".jsonl";
    };
    for (const char* folder : {"whole", "parts"}) std::filesystem::create_directory(folder_ / folder);
    ASSERT_EQ(kerf(batch("whole")).status, 0);

    std::size_t interruptions = 0, lines = 0;
    const char* const signals[] = {"INT", "TERM", "KILL"};
    for (int round = 0; round < 100; ++round) {
        // Longer each time: where programs are slow (sanitizers), short ones may not get to the first line.
        const std::string seconds = std::to_string(0.03 * (1 + round));
        const Outcome outcome =
            kerf(batch("parts"), std::string("timeout --preserve-status -s ") + signals[round % 3] + " " + seconds);
        const std::string results = read_text(folder_ / "parts.jsonl");
        const auto now = static_cast<std::size_t>(std::ranges::count(results, '\n'));
        EXPECT_GE(now, lines);
        lines = now;
        if (outcome.status == 0) break;
        ++interruptions;
        // As an interruption in the middle of a line leaves it. (The program may be stopped after its last line, too:
        // there is no part of a line then.)
        if (now < count && (results.empty() || results.back() == '\n'))
            write("parts.jsonl", results + R"({"job":)" + std::to_string(now + 1) + R"(,"na)");
    }
    EXPECT_EQ(lines, count);
    EXPECT_GT(interruptions, 0u);
    // Nothing is left under temporary names, either.
    EXPECT_EQ(names_of(written("parts")), names_of(written("whole")));
    EXPECT_TRUE(written("parts") == written("whole"));
    EXPECT_FALSE(std::filesystem::exists(folder_ / "parts.jsonl.run"));

    // What was taken away, or is not what it was, is made again.
    const auto expect_made_again = [&] {
        const Outcome outcome = kerf(batch("parts"));
        ASSERT_EQ(outcome.status, 0) << outcome.err;
        EXPECT_TRUE(written("parts") == written("whole"));
    };
    std::filesystem::remove(folder_ / "parts/rock.0023.negative.ply");
    expect_made_again();
    write("parts/rock.0050.positive.ply", "");
    expect_made_again();
    EXPECT_EQ(lines_of(read_text(folder_ / "parts.jsonl")).size(), count);
}

TEST_F(KerfBatch, DoesNotMixUpResultsOfOtherJobs)
{
    write_planes(5);
    const std::string batch = "cut rock.ply --batch jobs.jsonl --out r --results r.jsonl";
    ASSERT_EQ(kerf(batch).status, 0);
    const std::string before = read_text(folder_ / "r.jsonl");
    expect_unusable(kerf(batch + " --gap 0.1"), "line 1 is no result of this job");
    expect_unusable(kerf(batch + " --format stl"), "line 1 is no result of this job");
    ASSERT_EQ(kerf("shape asteroid -n 2000 --seed 5 -o rock.ply").status, 0);
    expect_unusable(kerf(batch), "line 1 is no result of this job");
    expect_unusable(kerf("cut rock.ply --batch jobs.jsonl --out r --results rock.ply"), "line 1");
    EXPECT_EQ(read_text(folder_ / "r.jsonl"), before);
}

TEST_F(KerfBatch, NoFileIsLostToResultsOrPieces)
{
    write("one.jsonl", "{\"plane\": \"z=0\"}");
    ASSERT_EQ(kerf("convert rock.ply -o rock.stl").status, 0);
    write("notes", "hello");
    write("torn", "{\"job\":1,\"na");
    for (const char* precious : {"rock.stl", "one.jsonl", "notes"}) {
        const std::string before = read_text(folder_ / precious);
        expect_unusable(kerf("cut rock.stl --batch one.jsonl --out r --results " + std::string(precious)),
                        "line 1 is no result of this job");
        EXPECT_EQ(read_text(folder_ / precious), before);
    }
    EXPECT_EQ(kerf("cut rock.stl --batch one.jsonl --out r --results torn").status, 0);
    std::filesystem::rename(folder_ / "one.jsonl", folder_ / "q.0001.positive.obj");
    expect_unusable(kerf("cut rock.stl --batch q.0001.positive.obj --out q"), "would replace");
    EXPECT_EQ(read_text(folder_ / "q.0001.positive.obj"), "{\"plane\": \"z=0\"}");
}

TEST_F(KerfBatch, TwoBatchesDoNotWriteOneFileOfResults)
{
    const std::size_t count = test::kBrief ? 100 : 400;
    write_planes(count);
    const Outcome outcome =
        kerf("cut rock.ply --batch jobs.jsonl --format ply --out b --results r.jsonl; wait $!; test $? -eq 0",
             "'" KERF_PROGRAM "' cut rock.ply --batch jobs.jsonl --format ply --out a --results r.jsonl & sleep 0.1;");
    EXPECT_EQ(outcome.status, 0);
    EXPECT_EQ(lines_of(read_text(folder_ / "r.jsonl")).size(), count);
}

TEST_F(KerfBatch, SaysWhichLineIsNoJobAndDoesNothing)
{
    const std::pair<const char*, const char*> faults[] = {
        {"{\"plane\": \"z=0\"}\nnonsense\n", "line 2: no JSON object"},
        {"[1]\n", "line 1: no JSON object"},
        {"{}\n", "one of 'plane', 'normal' and 'through'"},
        {"{\"plane\": \"z=0\", \"normal\": [0,0,1]}\n", "one of 'plane', 'normal' and 'through'"},
        {"{\"plane\": \"w=0\"}\n", "is no axis"},
        {"{\"plane\": 3}\n", "'plane' is no text"},
        {"{\"normal\": [0,0,0]}\n", "'normal' has no direction"},
        {"{\"normal\": [0,0]}\n", "'normal' is no list of three numbers"},
        {"{\"normal\": [0,0,\"1\"]}\n", "'normal' is no number"},
        {"{\"plane\": \"z=0\", \"point\": [0,0,0]}\n", "'point' goes with 'normal'"},
        {"{\"through\": [[0,0,0],[1,1,1],[2,2,2]]}\n", "lie on one line"},
        {"{\"plane\": \"z=0\", \"gap\": -1}\n", "'gap' is below 0"},
        {"{\"plane\": \"z=0\", \"cap\": 1}\n", "'cap' is neither true nor false"},
        {"{\"plane\": \"z=0\", \"colour\": 1}\n", "'colour' is none of"},
        {"{\"plane\": \"z=0\", \"name\": \"a/b\"}\n", "'name' has a /"},
        {"{\"plane\": \"z=0\", \"name\": \"\"}\n", "'name' is no text"},
        {"{\"plane\": \"z=0\", \"name\": \"a\"}\n{\"plane\": \"z=1\", \"name\": \"a\"}\n", "another job has the name"},
        {"{\"plane\": \"z=0\", \"name\": \"0002\"}\n{\"plane\": \"z=1\"}\n", "has its number for one"},
        {"\n \n", "no job"},
    };
    const std::vector<std::string> before = names_in_folder();
    for (const auto& [jobs, fault] : faults) {
        write("jobs.jsonl", jobs);
        expect_unusable(kerf("cut rock.ply --batch jobs.jsonl --out r"), fault);
        std::filesystem::remove(folder_ / "jobs.jsonl");
        EXPECT_EQ(names_in_folder(), before);
    }
    expect_unusable(kerf("cut rock.ply --batch nowhere.jsonl --out r"), "nowhere.jsonl");
}

TEST_F(KerfBatch, AJobThatFailsIsALineAndTheRestIsDone)
{
    ASSERT_EQ(kerf("shape torus -n 2000 -o ring.ply").status, 0);
    write("jobs.jsonl", "{\"plane\": \"x=0\", \"only\": [0, 0.7, 0]}\n{\"plane\": \"x=0\"}\n");
    const Outcome outcome = kerf("cut ring.ply --batch jobs.jsonl --out r");
    EXPECT_EQ(outcome.status, 1);
    EXPECT_NE(outcome.err.find("1 of 2 jobs failed"), std::string::npos) << outcome.err;
    const std::vector<Json> lines = lines_of(outcome.out);
    ASSERT_EQ(lines.size(), 2u);
    EXPECT_EQ(lines[0]["status"], "not_separated");
    EXPECT_NE(lines[0]["error"], "");
    EXPECT_TRUE(std::filesystem::exists(folder_ / "r.0002.positive.obj"));
}

TEST_F(KerfBatch, RequireCutIsExitStatus3)
{
    write_planes(5);
    EXPECT_EQ(kerf("cut rock.ply --batch jobs.jsonl --out r").status, 0);
    const Outcome outcome = kerf("cut rock.ply --batch jobs.jsonl --out r --require-cut");
    EXPECT_EQ(outcome.status, 3);
    EXPECT_EQ(lines_of(outcome.out).back()["status"], "missed");
    EXPECT_NE(outcome.err.find("1 of 5 planes did not divide rock.ply"), std::string::npos) << outcome.err;
    EXPECT_EQ(kerf("cut rock.ply --plane z=9 --out r").status, 0);
    EXPECT_EQ(kerf("cut rock.ply --plane z=9 --out r --require-cut").status, 3);
    EXPECT_EQ(kerf("cut rock.ply --plane z=0 --out r --require-cut").status, 0);
}

}  // namespace
}  // namespace kerf::tools
