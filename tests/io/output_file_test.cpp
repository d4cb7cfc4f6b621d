#include "common/io/output_file.h"

#include <sys/resource.h>

#include <csignal>

#include "common/io/unfinished_files.h"
#include "io/test_files.h"

namespace kerf::io {
namespace {

using OutputFileTest = MeshFileTest;

TEST_F(OutputFileTest, AppearsOnlyWhenCommitted)
{
    {
        OutputFile out(file("a.txt"));
        out.write("hello");
        out.finish();
        EXPECT_FALSE(std::filesystem::exists(file("a.txt")));
        out.commit();
        EXPECT_EQ(read_text(file("a.txt")), "hello");
    }
    EXPECT_EQ(names_in_folder(), std::vector<std::string>{"a.txt"});
}

TEST_F(OutputFileTest, LeavesNothingBehindAndTheOldFileAloneWhenAbandoned)
{
    write("a.txt", "old");
    {
        OutputFile out(file("a.txt"));
        out.write("new");
    }
    EXPECT_EQ(names_in_folder(), std::vector<std::string>{"a.txt"});
    EXPECT_EQ(read_text(file("a.txt")), "old");
}

TEST_F(OutputFileTest, IsFoundByASignalHandlerWhileItIsUnfinished)
{
    OutputFile done(file("done.txt"));
    done.finish();
    done.commit();
    OutputFile first(file("a.txt")), second(file("b.txt"));
    first.write("half");
    EXPECT_EQ(names_in_folder().size(), 3u);
    remove_unfinished_files();
    EXPECT_EQ(names_in_folder(), std::vector<std::string>{"done.txt"});
}

TEST_F(OutputFileTest, RefusesFoldersThatDoNotExistAndPlacesThatAreNotFiles)
{
    EXPECT_THROW(OutputFile(file("gone/a.txt")), FileError);
    std::filesystem::create_directory(file("folder"));
    EXPECT_THROW(OutputFile{file("folder")}, FileError);
    EXPECT_EQ(names_in_folder(), std::vector<std::string>{"folder"});
}

/// No file of this process may grow beyond a size while this lives: writing fails as on a full disk.
class FileSizeLimit
{
public:
    explicit FileSizeLimit(rlim_t bytes)
    {
        ::getrlimit(RLIMIT_FSIZE, &before_);
        handler_ = std::signal(SIGXFSZ, SIG_IGN);
        const rlimit limit{bytes, before_.rlim_max};
        ::setrlimit(RLIMIT_FSIZE, &limit);
    }
    ~FileSizeLimit()
    {
        ::setrlimit(RLIMIT_FSIZE, &before_);
        std::signal(SIGXFSZ, handler_);
    }

private:
    rlimit before_{};
    void (*handler_)(int) = SIG_DFL;
};

TEST_F(OutputFileTest, ReportsAFullDiskAndLeavesNothing)
{
    for (const char* name : {"a.obj", "a.ply", "a.stl", "a.glb"}) {
        std::string error;
        {
            const FileSizeLimit limit(100);
            try {
                write_mesh(file(name), sample_mesh());
            } catch (const FileError& e) {
                error = e.what();
            }
        }
        EXPECT_TRUE(contains(error, "cannot be written")) << error;
        EXPECT_TRUE(names_in_folder().empty()) << name;
    }
}

TEST_F(OutputFileTest, WritesAllFilesOfASetOrNone)
{
    const IndexedMesh mesh = sample_mesh();
    {
        MeshFileSet files;
        files.add(file("a.obj"), mesh);
        EXPECT_THROW(files.add(file("gone/b.obj"), mesh), FileError);
    }
    EXPECT_TRUE(names_in_folder().empty());
    {
        MeshFileSet files;
        files.add(file("a.obj"), mesh);
        files.add(file("b.ply"), mesh);
        // Something takes the second name in the meantime.
        std::filesystem::create_directories(file("b.ply/inside"));
        EXPECT_THROW(files.commit(), FileError);
    }
    EXPECT_EQ(names_in_folder(), std::vector<std::string>{"b.ply"});
}

TEST_F(OutputFileTest, RefusesExtensionsThatItCannotWrite)
{
    for (const char* name : {"a.off", "a.gltf", "a", "a.xyz"})
        EXPECT_THROW(write_mesh(file(name), sample_mesh()), FileError);
    EXPECT_TRUE(names_in_folder().empty());
}

}  // namespace
}  // namespace kerf::io
