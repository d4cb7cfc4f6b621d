#include <string>
#include <utility>
#include <vector>

#include "common/io/bytes.h"
#include "common/io/test_files.h"

namespace kerf::core::io {
namespace {

using StlTest = MeshFileTest;

std::string facet(const std::string& a, const std::string& b, const std::string& c)
{
    return " facet normal 0 nan 1\n  outer loop\n   vertex " + a + "\n   vertex " + b + "\n   vertex " + c +
           "\n  endloop\n endfacet\n";
}

TEST_F(StlTest, ReadsTextWithSeveralSolids)
{
    const TriangleSoup soup = soup_of(
        "a.STL", "solid one facet\n" + facet("0 0 0", "1 0 0", "0 1 -0.0") + "endsolid one facet\n\nSOLID\n" +
                     facet("1.361967e-003 7.946887e-003 2.423772e-002", "1 0 0", "0 1 0") +
                     " FACET NORMAL 0 0 1 OUTER LOOP VERTEX 0 0 0 VERTEX 1 0 0 VERTEX 1 1 0 VERTEX 0 1 0 ENDLOOP "
                     "ENDFACET\nENDSOLID");
    EXPECT_EQ(soup.triangles.size(), 4u);
    EXPECT_EQ(soup.vertices.size(), 10u);
    EXPECT_EQ(soup.vertices[3].position, glm::vec3(1.361967e-003f, 7.946887e-003f, 2.423772e-002f));
    EXPECT_FALSE(soup.has_normals);
}

std::string binary(std::uint32_t claimed, std::uint32_t real, const std::string& title)
{
    std::string bytes = title;
    bytes.resize(80, ' ');
    store_little(bytes, claimed);
    for (std::uint32_t i = 0; i < real; ++i) {
        for (int k = 0; k < 12; ++k) store_little(bytes, k < 3 ? 0.0f : float(k * k % 7) + float(i));
        store_little(bytes, std::uint16_t{0x7FFF});
    }
    return bytes;
}

TEST_F(StlTest, ReadsBinaryEvenIfItsTitleBeginsLikeText)
{
    for (const char* title : {"solid block", "", "binary"}) {
        const TriangleSoup soup = soup_of("a.stl", binary(2, 2, title));
        EXPECT_EQ(soup.triangles.size(), 2u);
        EXPECT_EQ(soup.vertices.size(), 6u);
        EXPECT_EQ(soup.vertices[0].position, glm::vec3(2, 2, 4));
    }
}

TEST_F(StlTest, TakesWhatFillsUpABlock)
{
    EXPECT_EQ(soup_of("a.stl", binary(2, 2, "x") + std::string(49, 'x')).triangles.size(), 2u);
    EXPECT_EQ(soup_of("a.stl", binary(2, 2, "x") + std::string(512, '\0')).triangles.size(), 2u);
}

TEST_F(StlTest, ReadsTextAsOtherProgramsWriteItAndNotesWhatIsUnusual)
{
    const std::string one = facet("0 0 0", "1 0 0", "0 1 0"), two = facet("0 0 0", "0 1 0", "0 0 1");
    const std::string unended = " solids without an end read as far as they go";
    const std::string unknown = " lines of no known kind passed over";
    const std::string divided = " keywords in two words read";
    const std::string joined = " 'outerloop' in one word read";
    const std::string unended_facets = " facets without 'endloop' or 'endfacet' read";
    const auto without = [](std::string text, const std::string& word) {
        return text.replace(text.find(word), word.size(), word == " loop" ? "loop" : "");
    };
    const std::string line = "facet normal 0 0 1 outer loop vertex 0 0 0 vertex 1 0 0 vertex 0 1 0 endloop endfacet ";
    const std::string spaced =
        "FACET NORMAL 0 0 1\nOUTER LOOP\nVERTEX 0 0 0\nVERTEX 1 0 0\nVERTEX 0 1 0\nEND LOOP\nEND FACET\n";
    const std::vector<std::pair<std::string, std::string>> files{
        {"solid x\n" + one + two + "endsolid x\n", ""},
        {"solid x\n" + one + two, "1" + unended},
        {"solid x\n" + one + "solid y\n" + two + "endsolid y\n", "1" + unended},
        {"solid x\n" + one + two + "end solid x\n", "1" + divided},
        {"solid x\n" + spaced + two + "end\tsolid", "3" + divided},
        {"solid x\ncolor 0.5 0.5 0.5\n" + one + "color 1 0 0\n" + two + "endsolid x\n", "2" + unknown},
        {"solid x\n" + one + two + "endsolid x\nmaterial 3\n", "1" + unknown},
        {"; made by hand\nsolid x ; a part\n" + one + "; next\n" + two + "endsolid x\n", ""},
        {"# made by hand\n// and so\nsolid x\n" + one + two + "endsolid x\n", "2" + unknown},
        {one + two, "2 facets outside of solids read"},
        {"solid x\n" + one + "endsolid x\n" + two, "1 facets outside of solids read"},
        {"solid x\n" + without(one, "endloop") + without(two, "endfacet") + "endsolid x\n", "2" + unended_facets},
        {"solid x\n" + without(without(one, "endloop"), "endfacet") + without(two, "endloop") + "endsolid\n",
         "2" + unended_facets},
        {"solid x\n" + one + without(two, "endfacet") + "endsolid x\n", "1" + unended_facets},
        {"solid x\n" + without(one, " loop") + "endsolid x\nsolid y\n" + without(two, " loop") + "endsolid y\n",
         "2" + joined},
        {"solidx\n" + one + two + "endsolid x\n", ""},
        {"Solid x\n" + one + two + "EndSolid x\n", ""},
        {"solid a part " + line + line + "endsolid a part", ""},
        {"solid a " + line + "endsolid a solid b " + line + "endsolid b", ""},
        {"\xEF\xBB\xBFsolid x\n" + one + two + "endsolid x\n", ""},
        {"\r\n  solid \xE9t\xE9\r\n" + one + two + "endsolid\r\n", ""},
        {"solid x\nfacet\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n" + two +
             "endsolid\n",
         ""},
        {"solid x\nfacet normal 0 0 1\ncolor 1 0 0\nouter loop\nvertex 0 0 0\nvertex 0 1 0\nendloop\nendfacet\n" + one +
             two + "endsolid\n",
         "1" + unknown + ", 1 faces of fewer than three corners passed over"},
    };
    for (const auto& [text, notes] : files) {
        const Read found = read("a.stl", text);
        EXPECT_EQ(found.notes, notes) << text;
        ASSERT_EQ(found.soup.triangles.size(), 2u) << text;
        const Triangle& first = found.soup.triangles[0];
        EXPECT_EQ(found.soup.vertices[first[1]].position, glm::vec3(1, 0, 0)) << text;
    }
}

TEST_F(StlTest, ReadsTextWithControlCharactersInItsNames)
{
    const std::string facets = facet("0 0 0", "1 0 0", "0 1 0") + facet("0 0 0", "0 1 0", "0 0 1");
    for (const char c : {'\0', '\x01', '\x07', '\x0E', '\x1B', '\x7F'})
        for (const std::string& name : {std::string(1, c) + "x", "x" + std::string(90, c)}) {
            const Read found = read("a.stl", "solid " + name + "\n" + facets + "endsolid\n");
            EXPECT_EQ(found.soup.triangles.size(), 2u) << int{c};
            EXPECT_EQ(found.notes, std::to_string(std::count(name.begin(), name.end(), c)) +
                                       " control characters in the text passed over")
                << int{c};
        }
    // Without facets nobody knows what it was to be.
    EXPECT_TRUE(contains(error_of("a.stl", "solid \x01x\n" + std::string(100, 'x')),
                         "it begins like text, but no facet follows, and as a binary file it is truncated"));
}

TEST_F(StlTest, ReadsTextWithControlCharactersWhateverStandsBeforeItsFirstWord)
{
    const std::string facets = facet("0 0 0", "1 0 0", "0 1 0") + facet("0 0 0", "0 1 0", "0 0 1");
    const std::string mark = "\xEF\xBB\xBF";
    for (const std::string& before : {mark, mark + " \r\n\t", std::string("# made\x01\n// by\x01 hand\n"),
                                      std::string("; made by\x01 hand\n"), mark + "\v\f\n; made\n#\x01\n"})
        for (const std::string solid : {"solid \x01x\n", "solidx\x01\n", "SOLID\t\x01\n"}) {
            const std::string text = before + solid + facets + "endsolid\n";
            const Read found = read("a.stl", text);
            EXPECT_EQ(found.soup.triangles.size(), 2u) << text;
            EXPECT_TRUE(contains(found.notes, "control characters in the text passed over")) << text;
        }
    // So is what stands between the words that tell it from a binary file.
    std::string spaced = "solid \x01\n" + facets;
    for (std::size_t at = 0; (at = spaced.find("outer loop", at)) != std::string::npos; at += 10)
        spaced.replace(at, 10, "OUTER ; a remark\n" + std::string(100, ' ') + "\vLOOP");
    EXPECT_EQ(soup_of("a.stl", spaced).triangles.size(), 2u);
    // A binary file may begin with any of it.
    for (const std::string& title : {mark + "solid x", std::string("# made\nsolid x"), std::string("; x\nfacet")})
        EXPECT_EQ(soup_of("a.stl", binary(2, 2, title) + "behind").triangles.size(), 2u) << title;
}

TEST_F(StlTest, NotesWhatStandsBehindItsTriangles)
{
    const std::string behind = " bytes behind the end passed over";
    EXPECT_EQ(read("a.stl", binary(2, 2, "x")).notes, "");
    EXPECT_EQ(read("a.stl", binary(2, 2, "x") + std::string(49, 'x')).notes, "49" + behind);
    EXPECT_EQ(read("a.stl", binary(2, 2, "x") + std::string(512, '\0')).notes, "512" + behind);
}

TEST_F(StlTest, TellsNumbersTooManyFromLinesOfNoKnownKind)
{
    const std::string longer = " lines with more numbers than they need read without them";
    const std::string good = facet("0 0 0", "1 0 0", "0 1 0");
    EXPECT_EQ(read("a.stl", "solid\n" + facet("0 0 0 1", "1 0 0", "0 1 0 1") + "endsolid\n").notes, "2" + longer);
    for (const char* normal : {"0 0 1 7", "0 0 1 7 7"}) {
        std::string text = good;
        text.replace(text.find("normal"), text.find('\n') - text.find("normal"), std::string("normal ") + normal);
        EXPECT_EQ(read("a.stl", "solid\n" + text + "endsolid\n").notes, "1" + longer) << normal;
    }
}

TEST_F(StlTest, SaysWhatIsWrong)
{
    EXPECT_TRUE(contains(error_of("a.stl", binary(4000000000u, 1, "x")), "truncated"));
    EXPECT_TRUE(contains(error_of("a.stl", binary(0, 0, "x")), "no triangles"));
    EXPECT_TRUE(contains(error_of("a.stl", binary(2, 5, "x")), "promises 2 triangles, but there are bytes for 5"));
    EXPECT_TRUE(contains(error_of("a.stl", "hello"), "neither a text nor a binary"));
    EXPECT_TRUE(contains(error_of("a.stl", "solid\n" + facet("0 0 0", "1 0 0", "0 x 0") + "endsolid\n"),
                         "line 6: a coordinate is 'x'"));
    EXPECT_TRUE(
        contains(error_of("a.stl", "solid\n" + facet("0 0 0", "1 0 0", "0 inf 0") + "endsolid\n"), "not finite"));
    EXPECT_TRUE(contains(error_of("a.stl", "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n"), "inside a facet"));
    EXPECT_TRUE(contains(error_of("a.stl", "solid\nfacet normal 0 0\n"), "ends inside a facet"));
    EXPECT_TRUE(
        contains(error_of("a.stl", "solid\nfacet normal 0 0 1\nvertex 0 0 0\n"), "'vertex' stands where 'outer'"));
    const std::string facet_head = "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n";
    EXPECT_TRUE(contains(error_of("a.stl", facet_head + "endfacet\n"), "'endfacet' stands where 'vertex'"));
    EXPECT_TRUE(contains(error_of("a.stl", facet_head + "vertex 0 1 0\n"), "ends inside a facet"));
    EXPECT_TRUE(contains(error_of("a.stl", facet_head + "vertex 0 1 0\nendloop\n"), "ends inside a facet"));
    EXPECT_TRUE(
        contains(error_of("a.stl", facet_head + "vertex 0 1 0\nouter loop\n"), "'outer' stands where 'endloop'"));
    EXPECT_TRUE(contains(error_of("a.stl", "solid a\nendsolid a\n"), "no triangles"));
    EXPECT_TRUE(contains(error_of("a.stl", "solid a\nvertex 0 0 0\n"), "'vertex' stands where a facet should begin"));
    // Text that is no STL is not called a truncated binary file, however long it is.
    const std::string page = "<html><head><title>404</title></head><body>" + std::string(200, ' ') + "</body></html>";
    EXPECT_TRUE(contains(error_of("a.stl", page), "it begins with '<html><head><title>404</title></head><bo..."));
    EXPECT_TRUE(contains(error_of("a.stl", "v 0 0 0\n" + std::string(2000, 'x')), "neither a text nor a binary STL"));
    EXPECT_TRUE(contains(error_of("a.stl", " \n"), "neither a text nor a binary"));
    std::string cut = binary(4, 4, "solid cut off");
    cut.resize(cut.size() - 60);
    EXPECT_TRUE(contains(error_of("a.stl", cut), "it is truncated: its header promises 4 triangles"));
    std::string with_nan = binary(1, 1, "x");
    with_nan.replace(96, 4, "\xFF\xFF\xFF\xFF");
    EXPECT_TRUE(contains(error_of("a.stl", with_nan), "not finite or too large for single precision; give it another"));
}

TEST_F(StlTest, WritesBinaryThatKeepsPositionsAndOrder)
{
    IndexedMesh mesh = sample_mesh();
    write_mesh(file("a.stl"), mesh);
    const TriangleSoup soup = read_soup(file("a.stl"));
    ASSERT_EQ(soup.triangles.size(), mesh.triangles.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k)
            EXPECT_EQ(soup.vertices[soup.triangles[t][k]].position, mesh.vertices[mesh.triangles[t][k]].position);
    EXPECT_EQ(std::filesystem::file_size(file("a.stl")), 84 + 50 * mesh.triangles.size());
}

}  // namespace
}  // namespace kerf::core::io
