#include "common/io/reading_notes.h"

#include "common/io/test_files.h"

namespace kerf::core::io {
namespace {

TEST(ReadingNotes, CountOneKindTogetherInTheOrderOfTheirFirst)
{
    ReadingNotes notes;
    EXPECT_TRUE(notes.none());
    EXPECT_EQ(notes.describe(), "");
    notes.add("apples");
    notes.add("pears", 0);
    notes.add("nuts", 3);
    notes.add("apples", 4);
    ASSERT_EQ(notes.list().size(), 2u);
    EXPECT_EQ(notes.list()[0].what, "apples");
    EXPECT_EQ(notes.list()[0].count, 5u);
    EXPECT_EQ(notes.describe(), "5 apples, 3 nuts");
}

TEST(ReadingNotes, CountAllKindsBeyondABoundAsOne)
{
    ReadingNotes notes;
    for (int i = 0; i < 1000; ++i) notes.add("kind " + std::to_string(i));
    notes.add("kind 1");
    ASSERT_EQ(notes.list().size(), 33u);
    EXPECT_EQ(notes.list()[1].count, 2u);
    EXPECT_EQ(notes.list().back().what, "other things passed over");
    EXPECT_EQ(notes.list().back().count, 968u);
}

using ReadingNotesOfFiles = MeshFileTest;

TEST_F(ReadingNotesOfFiles, AreHandedOnByReadMeshAndAreNoneForAFileAsItShouldBe)
{
    const std::string head = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv nan 0 0\nvn 0 0 1\nf 1//1 2//1 3//1\n";
    EXPECT_EQ(read_mesh(write("a.obj", head)).notes.describe(),
              "1 vertices of no face that are not finite numbers passed over");
    for (const std::string extension : {"obj", "ply", "stl", "glb"}) {
        write_mesh(file("b." + extension), sample_mesh());
        EXPECT_EQ(read_mesh(file("b." + extension)).notes.describe(), "") << extension;
    }
}

}  // namespace
}  // namespace kerf::core::io
