#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "common/io/mesh_file.h"
#include "support/temporary_folder.h"

// The program that the README shows, run where its paths are right.

namespace kerf::core {
namespace {

namespace fs = std::filesystem;

class Readme : public test::FolderTest
{
protected:
    Readme() { fs::create_directory_symlink(KERF_DATA_DIR, file("data")); }

    /// Exit status; 128 + n when signal n ended it.
    int run_slicer(const std::string& arguments) const
    {
        const std::string command =
            "cd '" + folder_.string() + "' && '" KERF_README_SLICER "' " + arguments + " >out 2>err";
        const int status = std::system(command.c_str());
        return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    }
};

TEST_F(Readme, TheListingWritesAClosedHalf)
{
    ASSERT_EQ(run_slicer(""), 0) << text_of("err");
    const io::LoadedMesh half = io::read_mesh(folder_ / "positive.obj"),
                         whole = io::read_mesh(folder_ / "data/models/rook.obj");
    EXPECT_TRUE(half.facts.closed());
    EXPECT_GT(half.facts.volume, 0.1 * whole.facts.volume);
    EXPECT_LT(half.facts.volume, 0.9 * whole.facts.volume);
}

TEST_F(Readme, TheListingSaysThatThePlaneMisses)
{
    std::ofstream(folder_ / "far.obj") << "v 9 9 9\nv 10 9 9\nv 9 10 9\nv 9 9 10\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    EXPECT_EQ(run_slicer("far.obj"), 1);
    EXPECT_EQ(text_of("err"), "not cut: missed\n");
    EXPECT_FALSE(fs::exists(folder_ / "positive.obj"));
}

TEST_F(Readme, TheListingSaysThatAFileIsMissing)
{
    EXPECT_EQ(run_slicer("none.obj"), 1);
    EXPECT_NE(text_of("err").find("none.obj: there is no such file"), std::string::npos) << text_of("err");
}

TEST_F(Readme, TheListingDoesNotWriteOverWhatItReads)
{
    fs::copy_file(KERF_DATA_DIR "/models/rook.obj", folder_ / "positive.obj");
    const std::string before = text_of("positive.obj");
    fs::create_symlink("positive.obj", folder_ / "link.obj");
    for (const char* name : {"positive.obj", "link.obj"}) {
        EXPECT_EQ(run_slicer(name), 1);
        EXPECT_NE(text_of("err").find("positive.obj: it would replace what is read"), std::string::npos)
            << text_of("err");
        EXPECT_EQ(text_of("positive.obj"), before);
    }
}

TEST_F(Readme, TheListingSaysThatItCannotWrite)
{
    fs::create_directory(folder_ / "positive.obj");
    EXPECT_EQ(run_slicer(""), 1);
    EXPECT_NE(text_of("err").find("positive.obj: "), std::string::npos) << text_of("err");
}

}  // namespace
}  // namespace kerf::core
