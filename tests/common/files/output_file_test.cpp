#include "common/files/output_file.h"

#include <sys/resource.h>

#include <csignal>
#include <optional>
#include <thread>
#include <utility>

#include "common/files/unfinished_files.h"
#include "common/io/test_files.h"

namespace kerf::core::io {
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

/// The one sentence of a FileError; "" without one.
template <typename Call>
std::string refusal_of(Call call)
{
    try {
        call();
    } catch (const FileError& error) {
        return error.what();
    }
    return {};
}

void expect_too_late(OutputFile& out)
{
    for (const std::string& error : {refusal_of([&] { out.write("more"); }), refusal_of([&] { out.finish(); })})
        EXPECT_TRUE(contains(error, ": nothing can be written to it any more")) << error;
}

TEST_F(OutputFileTest, RefusesWhatComesTooLate)
{
    OutputFile out(file("a.txt"));
    out.write("hello");
    out.finish();
    expect_too_late(out);
    out.commit();
    expect_too_late(out);
    EXPECT_TRUE(contains(refusal_of([&] { out.commit(); }), "nothing can be written to it any more"));
    EXPECT_EQ(read_text(file("a.txt")), "hello");
    out.withdraw();
    expect_too_late(out);
    EXPECT_THROW(out.commit(), FileError);
    EXPECT_EQ(names_in_folder(), std::vector<std::string>{});
}

TEST_F(OutputFileTest, GetsNoNameBeforeItIsFinished)
{
    {
        OutputFile out(file("a.txt"));
        out.write("hel");
        EXPECT_TRUE(contains(refusal_of([&] { out.commit(); }), "before it is finished"));
        out.write("lo");
        out.finish();
        out.commit();
    }
    EXPECT_EQ(read_text(file("a.txt")), "hello");
}

TEST_F(OutputFileTest, RefusesEverythingAfterItWasMovedAway)
{
    write("a.txt", "old");
    {
        OutputFile from(file("a.txt"));
        from.write("hel");
        OutputFile to(std::move(from));
        expect_too_late(from);  // NOLINT(bugprone-use-after-move): that is the test
        EXPECT_TRUE(contains(refusal_of([&] { from.commit(); }), "moved away"));
        EXPECT_EQ(from.path(), "");
        EXPECT_EQ(from.place(), "");
        from.withdraw();
        EXPECT_EQ(read_text(file("a.txt")), "old");
        to.write("lo");
        to.finish();
        to.commit();
        OutputFile last(std::move(to));
        to.withdraw();  // NOLINT(bugprone-use-after-move): that is the test
        EXPECT_EQ(read_text(file("a.txt")), "hello");
        last.withdraw();
        EXPECT_EQ(read_text(file("a.txt")), "old");
    }
    EXPECT_EQ(names_in_folder(), std::vector<std::string>{"a.txt"});
}

TEST_F(OutputFileTest, LeavesTheTemporaryFileToWhereItWasMoved)
{
    std::optional<OutputFile> from(file("a.txt"));
    OutputFile to(std::move(*from));
    from.reset();
    EXPECT_EQ(names_in_folder().size(), 1u);
    to.finish();
    to.commit();
    EXPECT_EQ(names_in_folder(), std::vector<std::string>{"a.txt"});
}

TEST_F(OutputFileTest, WithdrawsOnlyWhatItHasNamed)
{
    write("a.txt", "old");
    OutputFile out(file("a.txt"));
    out.withdraw();
    out.write("new");
    out.withdraw();
    out.finish();
    out.withdraw();
    EXPECT_EQ(read_text(file("a.txt")), "old");
    out.commit();
    EXPECT_EQ(read_text(file("a.txt")), "new");
    out.withdraw();
    EXPECT_EQ(read_text(file("a.txt")), "old");
    EXPECT_EQ(names_in_folder(), std::vector<std::string>{"a.txt"});
    write("a.txt", "another's");
    out.withdraw();
    EXPECT_EQ(read_text(file("a.txt")), "another's");
    OutputFile first(file("b.txt"));
    first.finish();
    first.commit();
    first.withdraw();
    EXPECT_EQ(names_in_folder(), std::vector<std::string>{"a.txt"});
}

TEST_F(OutputFileTest, RefusesNamesThatTheSystemWouldCutOff)
{
    const std::filesystem::path name = file(std::string("a\0.txt", 6));
    EXPECT_THROW(OutputFile{name}, FileError);
    write("a.obj", "v 0 0 0\n");
    EXPECT_TRUE(contains(refusal_of([&] { read_soup(file(std::string("a.obj\0.obj", 10))); }), "no such file"));
    EXPECT_EQ(names_in_folder(), std::vector<std::string>{"a.obj"});
}

TEST_F(OutputFileTest, KeepsWhatItReplacesOnlyUntilItEnds)
{
    write("a.txt", "old");
    {
        OutputFile out(file("a.txt"));
        out.write("new");
        out.finish();
        out.commit();
        EXPECT_EQ(names_in_folder().size(), 2u);
        OutputFile moved(std::move(out));
    }
    EXPECT_EQ(names_in_folder(), std::vector<std::string>{"a.txt"});
    EXPECT_EQ(read_text(file("a.txt")), "new");
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

TEST_F(OutputFileTest, IsFoundByASignalHandlerHoweverManyAreUnfinished)
{
    std::vector<OutputFile> files;
    for (int i = 0; i < 1000; ++i) {
        files.emplace_back(file(std::to_string(i)));
        files.back().finish();
    }
    EXPECT_EQ(names_in_folder().size(), files.size());
    remove_unfinished_files();
    EXPECT_EQ(names_in_folder(), std::vector<std::string>{});
}

TEST_F(OutputFileTest, MayBeAbandonedByManyThreadsWhileASignalHandlerLooks)
{
    std::vector<std::thread> writers;
    for (int i = 0; i < 4; ++i)
        writers.emplace_back([this, i] {
            for (int round = 0; round < 50; ++round) {
                OutputFile(file(std::to_string(i))).finish();
                OutputFile one(file(std::to_string(i))), other(file(std::to_string(i) + "b"));
            }
        });
    for (int i = 0; i < 50; ++i) remove_unfinished_files();
    for (std::thread& writer : writers) writer.join();
    EXPECT_EQ(names_in_folder(), std::vector<std::string>{});
}

volatile std::sig_atomic_t signals_seen = 0;

TEST_F(OutputFileTest, SignalsWaitWhileASetTakesItsNames)
{
    const auto before = std::signal(SIGHUP, [](int) { signals_seen = signals_seen + 1; });
    {
        const SignalsWait signals_wait;
        std::raise(SIGHUP);
        EXPECT_EQ(signals_seen, 0);
    }
    EXPECT_EQ(signals_seen, 1);
    std::signal(SIGHUP, before);
}

TEST_F(OutputFileTest, HasRoomInEveryNameThatTheFileSystemAllows)
{
    const std::string longest(255, 'n');
    for (const std::size_t length : {100u, 232u, 255u}) {
        OutputFile out(file(longest.substr(0, length)));
        out.finish();
        out.commit();
        EXPECT_TRUE(std::filesystem::exists(out.path())) << length;
    }
    EXPECT_EQ(names_in_folder().size(), 3u);
    EXPECT_THROW(OutputFile(file(longest + "n")), FileError);
    EXPECT_EQ(names_in_folder().size(), 3u);
}

TEST_F(OutputFileTest, PassesOverWhatAKilledProcessLeftBehind)
{
    OutputFile probe(file("a"));
    const std::string name = names_in_folder().at(0);  // .kerf-PROCESS-SERIAL.tmp
    const std::size_t dash = name.rfind('-') + 1, dot = name.rfind('.');
    const int serial = std::stoi(name.substr(dash, dot - dash));
    std::vector<std::string> left;
    for (int i = 1; i <= 3; ++i) {
        left.push_back(name.substr(0, dash) + std::to_string(serial + i) + name.substr(dot));
        write(left.back(), "left");
    }
    OutputFile(file("b")).finish();
    for (const std::string& one : left) EXPECT_EQ(read_text(file(one)), "left");
}

TEST_F(OutputFileTest, WritesWhereALinkLeadsAndLeavesTheLink)
{
    namespace fs = std::filesystem;
    fs::create_directory(file("folder"));
    write("folder/old.txt", "old");
    fs::create_symlink("folder/old.txt", file("to_a_file"));
    fs::create_symlink(file("folder/new.txt"), file("to_nothing"));
    fs::create_symlink("to_a_file", file("to_a_link"));
    for (const char* name : {"to_a_file", "to_nothing", "to_a_link"}) {
        OutputFile out(file(name));
        out.write(name);
        out.finish();
        out.commit();
        EXPECT_TRUE(fs::is_symlink(file(name)));
        EXPECT_EQ(read_text(file(name)), name);
    }
    EXPECT_EQ(read_text(file("folder/old.txt")), "to_a_link");
    EXPECT_EQ(read_text(file("folder/new.txt")), "to_nothing");
}

TEST_F(OutputFileTest, RefusesLinksThatLeadInACircleOrIntoNoFolder)
{
    namespace fs = std::filesystem;
    fs::create_symlink("b", file("a"));
    fs::create_symlink("a", file("b"));
    fs::create_symlink("gone/c", file("c"));
    for (const char* name : {"a", "b", "c"}) EXPECT_THROW(OutputFile{file(name)}, FileError);
    try {
        OutputFile{file("c")};
    } catch (const FileError& error) {
        EXPECT_TRUE(contains(error.what(), "the link of this name leads into a folder that does not exist"))
            << error.what();
    }
    EXPECT_EQ(names_in_folder(), (std::vector<std::string>{"a", "b", "c"}));
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

TEST_F(OutputFileTest, GetsNoNameWhenBytesAreMissing)
{
    OutputFile while_writing(file("a.txt")), synchronising(file("b.txt")), at_the_end(file("c.txt"));
    for (OutputFile* out : {&synchronising, &at_the_end}) out->write(std::string(1000, 'b'));
    {
        const FileSizeLimit limit(100);
        EXPECT_THROW(while_writing.write(std::string(2 << 20, 'a')), FileError);
        EXPECT_THROW(synchronising.synchronise(), FileError);
        EXPECT_THROW(at_the_end.finish(), FileError);
    }
    for (OutputFile* out : {&while_writing, &synchronising, &at_the_end}) {
        expect_too_late(*out);
        EXPECT_TRUE(contains(refusal_of([&] { out->commit(); }), "writing it failed"));
        EXPECT_FALSE(std::filesystem::exists(out->path()));
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
        write("a.obj", "old");
        MeshFileSet files;
        files.add(file("a.obj"), mesh);
        files.add(file("b.ply"), mesh);
        // Something takes the second name in the meantime.
        std::filesystem::create_directories(file("b.ply/inside"));
        EXPECT_THROW(files.commit(), FileError);
    }
    EXPECT_EQ(names_in_folder(), (std::vector<std::string>{"a.obj", "b.ply"}));
    EXPECT_EQ(read_text(file("a.obj")), "old");
}

/// A tetrahedron. As OBJ it has a material file.
IndexedMesh coloured_mesh()
{
    IndexedMesh mesh = sample_mesh();
    const glm::vec3 corners[] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) mesh.vertices[v].position = corners[mesh.points[v]];
    return mesh;
}

IndexedMesh plain_mesh()
{
    IndexedMesh mesh = coloured_mesh();
    for (Material& material : mesh.materials) material = {};
    return mesh;
}

TEST_F(OutputFileTest, NeverReplacesAnInputOfTheSetByWhateverName)
{
    namespace fs = std::filesystem;
    write_mesh(file("model.obj"), coloured_mesh());
    const std::string obj = read_text(file("model.obj")), mtl = read_text(file("model.mtl"));
    fs::create_directory(file("folder"));
    fs::create_symlink("../model.obj", file("folder/link.obj"));
    fs::create_hard_link(file("model.obj"), file("folder/hard.ply"));
    fs::create_symlink("../model.mtl", file("folder/stuff.mtl"));
    const std::vector<fs::path> inputs = read_mesh(file("model.obj")).files;
    EXPECT_EQ(inputs.size(), 2u);
    for (const char* name : {"model.obj", "./model.obj", "folder/../model.obj", "folder/link.obj", "folder/hard.ply",
                             "folder/stuff.obj"}) {
        MeshFileSet files(inputs);
        EXPECT_THROW(files.add(folder_ / name, coloured_mesh()), FileError) << name;
        EXPECT_NO_THROW(files.add(file("other.obj"), coloured_mesh()));
        EXPECT_NO_THROW(files.commit());
        EXPECT_EQ(read_text(file("model.obj")), obj) << name;
        EXPECT_EQ(read_text(file("model.mtl")), mtl) << name;
    }
    EXPECT_EQ(names_in_folder(),
              (std::vector<std::string>{"folder", "model.mtl", "model.obj", "other.mtl", "other.obj"}));
}

TEST_F(OutputFileTest, NeverWritesTwoFilesOfASetToOnePlace)
{
    namespace fs = std::filesystem;
    fs::create_symlink("b.ply", file("a.ply"));
    MeshFileSet files;
    files.add(file("a.ply"), sample_mesh());
    EXPECT_THROW(files.add(file("b.ply"), sample_mesh()), FileError);
    EXPECT_THROW(files.add(file("./a.ply"), sample_mesh()), FileError);
    files.add(file("c.ply"), sample_mesh());
    files.commit();
    EXPECT_EQ(names_in_folder(), (std::vector<std::string>{"a.ply", "b.ply", "c.ply"}));
}

TEST_F(OutputFileTest, KeepsWhatWasAddedWhenAnotherFileCannotBe)
{
    const IndexedMesh mesh = plain_mesh();
    MeshFileSet files;
    files.add(file("a.obj"), mesh);
    {
        const FileSizeLimit limit(100);
        EXPECT_THROW(files.add(file("b.obj"), mesh), FileError);
    }
    files.commit();
    EXPECT_EQ(names_in_folder(), std::vector<std::string>{"a.obj"});
}

TEST_F(OutputFileTest, RefusesNamesThatALineOfObjCannotHold)
{
    for (const char* name : {"a\nb.obj", "a\rb.obj", "a\tb.obj", " a.obj"}) {
        EXPECT_THROW(write_mesh(file(name), coloured_mesh()), FileError) << name;
        // Without a material file, and in other formats, nothing names it.
        const std::string other = std::string(name).substr(0, std::strlen(name) - 3) + "ply";
        EXPECT_NO_THROW(write_mesh(file(name), plain_mesh()));
        EXPECT_NO_THROW(write_mesh(file(other), coloured_mesh()));
        EXPECT_TRUE(std::filesystem::remove(file(name)) && std::filesystem::remove(file(other)));
    }
    for (const char* name : {"a b.obj", "a#b.obj", "a  b .obj", "\xC3\xA4.obj"}) {
        write_mesh(file(name), coloured_mesh());
        EXPECT_EQ(read_soup(file(name)).materials.front().colour, coloured_mesh().materials.front().colour) << name;
    }
}

TEST_F(OutputFileTest, RefusesExtensionsThatItCannotWrite)
{
    for (const char* name : {"a.gltf", "a", "a.xyz"}) EXPECT_THROW(write_mesh(file(name), sample_mesh()), FileError);
    EXPECT_TRUE(names_in_folder().empty());
}

}  // namespace
}  // namespace kerf::core::io
