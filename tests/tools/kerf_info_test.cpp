#include <cctype>
#include <cmath>
#include <map>
#include <sstream>

#include "tools/program.h"

namespace kerf::tools {
namespace {

using KerfInfo = ProgramTest;

constexpr const char* kTetrahedron = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";

TEST_F(KerfInfo, SaysWhatAClosedMeshIsLike)
{
    write("a.obj", kTetrahedron);
    const Json info = kerf_json("info a.obj");
    EXPECT_EQ(info["triangles"], 4);
    EXPECT_EQ(info["vertices"], 4);
    EXPECT_EQ(info["welded_vertices"], 4);
    EXPECT_EQ(info["closed"], true);
    EXPECT_EQ(info["manifold"], true);
    EXPECT_EQ(info["oriented"], true);
    EXPECT_EQ(info["shells"], 1);
    EXPECT_EQ(info["boundary_loops"], 0);
    EXPECT_NEAR(info["volume"].get<double>(), 1.0 / 6.0, 1e-12);
    EXPECT_NEAR(info["area"].get<double>(), 1.5 + std::sqrt(3.0) / 2.0, 1e-7);
    EXPECT_EQ(info["bounds"]["min"], Json({0.0, 0.0, 0.0}));
    EXPECT_EQ(info["bounds"]["max"], Json({1.0, 1.0, 1.0}));
    EXPECT_EQ(info["repairs"]["degenerate_triangles"], 0);
}

TEST_F(KerfInfo, ReportsFactsBeforeRepairAndTheRepairs)
{
    write("a.obj", std::string(kTetrahedron) + "f 1 3 2\nf 1 1 2\n");
    const Json info = kerf_json("info a.obj");
    EXPECT_EQ(info["triangles"], 6);
    EXPECT_EQ(info["degenerate_triangles"], 1);
    EXPECT_EQ(info["duplicate_triangles"], 1);
    EXPECT_EQ(info["repairs"]["degenerate_triangles"], 1);
    EXPECT_EQ(info["repairs"]["duplicate_triangles"], 1);
    EXPECT_EQ(info["repairs"]["replaced_attributes"], 0);
    EXPECT_NE(info["repairs"]["text"], "");
}

TEST_F(KerfInfo, CallsClosedWhatIsClosedOnceItIsRepaired)
{
    // Two tetrahedra on the same base: each needs it.
    write("two.obj", std::string(kTetrahedron) + "v 0 0 2\nf 1 3 2\nf 1 2 5\nf 2 3 5\nf 3 1 5\n");
    const Json two = kerf_json("info two.obj");
    EXPECT_EQ(two["closed"], true);
    EXPECT_EQ(two["unbalanced_edges"], 0);
    EXPECT_EQ(two["duplicate_triangles"], 1);
    EXPECT_EQ(two["repairs"]["duplicate_triangles"], 0);
    EXPECT_EQ(two["repairs"]["coinciding_triangles"], 1);

    // Three triangles at each edge of the base, none at the boundary.
    write("wall.obj", std::string(kTetrahedron) + "v 0.2 0.2 0.2\nf 1 2 5\nf 2 3 5\nf 3 1 5\n");
    const Json wall = kerf_json("info wall.obj");
    EXPECT_EQ(wall["boundary_edges"], 0);
    EXPECT_EQ(wall["closed"], false);
    EXPECT_EQ(wall["open_edges"], 3);
    EXPECT_NE(kerf("info wall.obj").out.find("closed           no (3 triangle sides without a neighbour after repair)"),
              std::string::npos);
}

TEST_F(KerfInfo, PrintsTextForPeople)
{
    write("a.obj", kTetrahedron);
    const Outcome outcome = kerf("info a.obj");
    EXPECT_EQ(outcome.status, 0);
    for (const char* line : {"triangles        4\n", "closed           yes\n", "repairs          none\n"})
        EXPECT_NE(outcome.out.find(line), std::string::npos) << outcome.out;
}

TEST_F(KerfInfo, RefusesFilesThatCannotBeUsedInOneLine)
{
    write("empty.obj", "");
    write("broken.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n");
    write("nan.off", "OFF\n3 1 0\n0 0 nan\n1 0 0\n0 1 0\n3 0 1 2\n");
    write("flat.obj", "v 0 0 0\nf 1 1 1\n");
    write("a.txt", "hello");
    expect_unusable(kerf("info none.obj"), "none.obj: there is no such file");
    expect_unusable(kerf("info empty.obj"), "empty.obj: it is empty");
    expect_unusable(kerf("info broken.obj --json"), "broken.obj: line 4: vertex 4 is out of range");
    expect_unusable(kerf("info nan.off"), "nan.off: line 3");
    expect_unusable(kerf("info flat.obj"), "flat.obj: ");
    expect_unusable(kerf("info a.txt"), "a.txt: the extension");
    expect_unusable(kerf("info ."), "extension");
}

/// Facts of the real meshes, computed by others and written down in INDEX.md.
struct IndexedFacts
{
    std::uint64_t triangles = 0, welded = 0, shells = 0, boundary_edges = 0, boundary_loops = 0, misoriented = 0;
    std::uint64_t nonmanifold_edges = 0, nonmanifold_points = 0;
    bool closed = false, manifold = false, oriented = false;
    double volume = 0.0;
};

std::vector<std::string> cells_of(const std::string& line)
{
    std::vector<std::string> cells;
    std::istringstream in(line.substr(1));
    for (std::string cell; std::getline(in, cell, '|');) {
        const std::size_t first = cell.find_first_not_of(' '), last = cell.find_last_not_of(' ');
        cells.push_back(first == std::string::npos ? "" : cell.substr(first, last + 1 - first));
    }
    return cells;
}

/// The numbers in a text, thousands separators taken out: "no (42 bnd edges, 4 loops)" has 42 and 4.
std::vector<std::uint64_t> numbers_in(std::string text)
{
    std::erase(text, ',');
    for (char& c : text)
        if (std::isdigit(static_cast<unsigned char>(c)) == 0) c = ' ';
    std::istringstream words(text);
    std::vector<std::uint64_t> numbers;
    for (std::uint64_t number = 0; words >> number;) numbers.push_back(number);
    return numbers;
}

std::map<std::string, IndexedFacts> read_index(const std::filesystem::path& path)
{
    std::map<std::string, IndexedFacts> all;
    std::ifstream in(path);
    for (std::string line; std::getline(in, line);) {
        if (!line.starts_with("| ") || line.starts_with("| file")) continue;
        const std::vector<std::string> cells = cells_of(line);
        IndexedFacts& facts = all[cells[0]];
        if (cells.size() < 10) {  // the second table
            facts.volume = std::stod(cells.back());
            continue;
        }
        facts.triangles = numbers_in(cells[1]).at(0);
        facts.welded = numbers_in(cells[2]).at(1);
        facts.closed = cells[3] == "yes";
        if (!facts.closed) {
            facts.boundary_edges = numbers_in(cells[3]).at(0);
            facts.boundary_loops = numbers_in(cells[3]).at(1);
        }
        facts.manifold = cells[4] == "yes";
        if (!facts.manifold) {
            facts.nonmanifold_edges = numbers_in(cells[4]).at(0);
            facts.nonmanifold_points = numbers_in(cells[4]).at(1);
        }
        facts.oriented = cells[5] == "yes";
        if (!facts.oriented) facts.misoriented = numbers_in(cells[5]).at(0);
        facts.shells = numbers_in(cells[6]).at(0);
    }
    return all;
}

TEST_F(KerfInfo, AgreesWithTheIndexOfTheSharedMeshes)
{
    const std::filesystem::path folder = KERF_SHARED_MESHES_DIR;
    if (!std::filesystem::exists(folder)) GTEST_SKIP() << "the shared meshes are not here";
    const auto index = read_index(folder / "INDEX.md");
    ASSERT_GE(index.size(), 18u);
    for (const auto& [name, facts] : index) {
        SCOPED_TRACE(name);
        const Json info = kerf_json("info '" + (folder / name).string() + "'");
        EXPECT_EQ(info["triangles"], facts.triangles);
        EXPECT_EQ(info["welded_vertices"], facts.welded);
        EXPECT_EQ(info["closed"], facts.closed);
        EXPECT_EQ(info["boundary_edges"], facts.boundary_edges);
        EXPECT_EQ(info["boundary_loops"], facts.boundary_loops);
        EXPECT_EQ(info["manifold"], facts.manifold);
        EXPECT_EQ(info["nonmanifold_edges"], facts.nonmanifold_edges);
        EXPECT_EQ(info["nonmanifold_points"], facts.nonmanifold_points);
        EXPECT_EQ(info["oriented"], facts.oriented);
        EXPECT_EQ(info["misoriented_edges"], facts.misoriented);
        EXPECT_EQ(info["shells"], facts.shells);
        // The index gives four digits.
        EXPECT_NEAR(info["volume"].get<double>(), facts.volume, 6e-4 * std::abs(facts.volume));
    }
}

}  // namespace
}  // namespace kerf::tools
