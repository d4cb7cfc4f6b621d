#include <gtest/gtest.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <sstream>
#include <tuple>

#include "data/obj_reader.h"
#include "maker/models.h"
#include "maker/obj.h"

namespace kerf::core::test {
namespace {

struct Expected
{
    const char* name;
    std::size_t faces;
    double vertices;   ///< distinct position, normal and uv, as Table 1 of the report has them
    double tolerance;  ///< as a share of `vertices`
};

void PrintTo(const Expected& e, std::ostream* out)
{
    *out << e.name;
}

// Table 1 of the report. Its King and Queen have odd face counts, which no closed triangle mesh has (3 faces = 2
// edges): the next even number stands here. Its Cube row has its two numbers swapped.
const Expected kTable[] = {
    {"car", 2836, 6184, 0.1},  {"cube", 12, 24, 0.0},       {"rook", 926, 1790, 0.1},    {"pedestal", 44, 88, 0.0},
    {"horse", 446, 882, 0.1},  {"icosphere", 80, 240, 0.0}, {"bishop", 1216, 2354, 0.1}, {"cylinder", 124, 192, 0.0},
    {"pawn", 898, 1800, 0.1},  {"cone", 62, 128, 0.0},      {"barrel", 706, 1263, 0.1},  {"king", 966, 1895, 0.1},
    {"sphere", 760, 445, 0.1}, {"queen", 1060, 2137, 0.1},  {"monkey", 968, 1966, 0.1},
};

std::string path_of(const std::string& name)
{
    return KERF_DATA_DIR "/models/" + name + ".obj";
}

Vec3 minus(const Vec3& a, const Vec3& b)
{
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
double dot(const Vec3& a, const Vec3& b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Vec3 cross(const Vec3& a, const Vec3& b)
{
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

class ModelFile : public testing::TestWithParam<Expected>
{
protected:
    const ObjFile file_ = read_obj(path_of(GetParam().name));

    std::array<Vec3, 3> corners(std::size_t t) const
    {
        std::array<Vec3, 3> p;
        for (std::size_t k = 0; k < 3; ++k) p[k] = file_.positions[std::size_t(file_.triangles[t][k].position)];
        return p;
    }
};

TEST_P(ModelFile, HasTheReportsNumberOfFaces)
{
    EXPECT_EQ(file_.triangles.size(), GetParam().faces);
}

TEST_P(ModelFile, HasTheReportsNumberOfVerticesAsTheGpuSeesThem)
{
    std::set<std::tuple<Vec3, Vec3, Vec2>> vertices;
    for (const auto& triangle : file_.triangles)
        for (const auto& c : triangle)
            vertices.insert({file_.positions[std::size_t(c.position)], file_.normals[std::size_t(c.normal)],
                             file_.uvs[std::size_t(c.uv)]});
    EXPECT_NEAR(double(vertices.size()), GetParam().vertices, GetParam().tolerance * GetParam().vertices);
}

TEST_P(ModelFile, IsClosedManifoldAndConsistentlyOriented)
{
    std::map<std::pair<int, int>, int> directed;
    std::map<int, std::map<int, int>> next_around;  // for each point: from one neighbour to the next round the fan
    for (const auto& triangle : file_.triangles)
        for (std::size_t k = 0; k < 3; ++k) {
            const int a = triangle[k].position, b = triangle[(k + 1) % 3].position, c = triangle[(k + 2) % 3].position;
            ++directed[{a, b}];
            next_around[a][b] = c;
        }
    for (const auto& [edge, count] : directed) {
        EXPECT_EQ(count, 1) << edge.first << '-' << edge.second;
        EXPECT_EQ(directed.count({edge.second, edge.first}), 1u) << edge.first << '-' << edge.second;
    }
    // A manifold point has one fan: a walk round it meets all its neighbours.
    for (const auto& [point, next] : next_around) {
        std::size_t steps = 0;
        int at = next.begin()->first;
        do {
            const auto found = next.find(at);
            ASSERT_NE(found, next.end());
            at = found->second;
            ++steps;
        } while (at != next.begin()->first && steps <= next.size());
        EXPECT_EQ(steps, next.size()) << "point " << point;
    }
    EXPECT_EQ(next_around.size(), file_.positions.size()) << "no point without a face";
    const std::set<Vec3> places(file_.positions.begin(), file_.positions.end());
    EXPECT_EQ(places.size(), file_.positions.size()) << "no two points in one place";
}

TEST_P(ModelFile, IsOneShellOfPositiveVolume)
{
    std::vector<int> parent(file_.positions.size());
    std::iota(parent.begin(), parent.end(), 0);
    const auto root = [&](int i) {
        while (parent[std::size_t(i)] != i) i = parent[std::size_t(i)];
        return i;
    };
    double volume = 0;
    for (std::size_t t = 0; t < file_.triangles.size(); ++t) {
        const auto [a, b, c] = corners(t);
        volume += dot(a, cross(b, c)) / 6;
        for (const auto& corner : file_.triangles[t])
            parent[std::size_t(root(corner.position))] = root(file_.triangles[t][0].position);
    }
    EXPECT_GT(volume, 0.05);
    for (std::size_t i = 1; i < parent.size(); ++i) ASSERT_EQ(root(int(i)), root(0));
}

TEST_P(ModelFile, HasNoDegenerateTriangle)
{
    for (std::size_t t = 0; t < file_.triangles.size(); ++t) {
        const auto [a, b, c] = corners(t);
        const Vec3 area = cross(minus(b, a), minus(c, a));
        const double longest =
            std::max({dot(minus(b, a), minus(b, a)), dot(minus(c, b), minus(c, b)), dot(minus(a, c), minus(a, c))});
        // Height over the longest side, as a share of it. The rims of round caps are the slimmest.
        EXPECT_GT(std::sqrt(dot(area, area)) / longest, 0.005) << "triangle " << t;
    }
}

TEST_P(ModelFile, DoesNotIntersectItself)
{
    using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
    CGAL::Surface_mesh<Kernel::Point_3> mesh;
    std::vector<CGAL::SM_Vertex_index> points;
    for (const Vec3& p : file_.positions) points.push_back(mesh.add_vertex({p[0], p[1], p[2]}));
    for (const auto& t : file_.triangles) {
        const auto face = mesh.add_face(points[std::size_t(t[0].position)], points[std::size_t(t[1].position)],
                                        points[std::size_t(t[2].position)]);
        ASSERT_NE(face, mesh.null_face());
    }
    std::vector<std::pair<CGAL::SM_Face_index, CGAL::SM_Face_index>> pairs;
    CGAL::Polygon_mesh_processing::self_intersections(mesh, std::back_inserter(pairs));
    for (const auto& [f, g] : pairs) {
        const auto p = corners(std::size_t(f))[0];
        ADD_FAILURE() << "triangles " << f << " and " << g << " near " << p[0] << ' ' << p[1] << ' ' << p[2];
    }
}

TEST_P(ModelFile, HasUnitNormalsOnTheOutside)
{
    for (std::size_t t = 0; t < file_.triangles.size(); ++t) {
        const auto [a, b, c] = corners(t);
        const Vec3 outwards = cross(minus(b, a), minus(c, a));
        for (const auto& corner : file_.triangles[t]) {
            const Vec3& n = file_.normals[std::size_t(corner.normal)];
            EXPECT_NEAR(dot(n, n), 1.0, 1e-4) << "triangle " << t;
            EXPECT_GT(dot(n, outwards), 0.0) << "triangle " << t;
        }
    }
}

TEST_P(ModelFile, HasFiniteTextureCoordinatesThatSpanEachTriangle)
{
    for (const auto& triangle : file_.triangles) {
        std::array<Vec2, 3> uv;
        for (std::size_t k = 0; k < 3; ++k) {
            uv[k] = file_.uvs[std::size_t(triangle[k].uv)];
            ASSERT_TRUE(std::isfinite(uv[k][0]) && std::isfinite(uv[k][1]));
        }
        EXPECT_NE((uv[1][0] - uv[0][0]) * (uv[2][1] - uv[0][1]) - (uv[2][0] - uv[0][0]) * (uv[1][1] - uv[0][1]), 0.0);
    }
}

TEST_P(ModelFile, NamesOnlyMaterialsOfItsLibrary)
{
    std::istringstream text(read_bytes(KERF_DATA_DIR "/models/" + file_.library));
    std::set<std::string> known;
    for (std::string keyword, name; text >> keyword;)
        if (keyword == "newmtl" && text >> name) known.insert(name);
    EXPECT_FALSE(file_.materials.empty());
    for (const std::string& material : file_.materials) EXPECT_EQ(known.count(material), 1u) << material;
}

INSTANTIATE_TEST_SUITE_P(All, ModelFile, testing::ValuesIn(kTable),
                         [](const auto& row) { return std::string(row.param.name); });

TEST(MakeModels, KnowsEveryModelOfTheTable)
{
    std::set<std::string> made, wanted;
    for (const auto& model : maker::kModels) made.insert(std::string(model.name));
    for (const Expected& row : kTable) wanted.insert(row.name);
    EXPECT_EQ(made, wanted);
}

TEST(MakeModels, WritesTheKeptFilesAgainByteForByte)
{
    for (const auto& model : maker::kModels) {
        const std::string name(model.name);
        // Not EXPECT_EQ, which would print both files.
        EXPECT_TRUE(maker::obj_text(model.make(), name) == read_bytes(path_of(name)))
            << name << ".obj differs: run make_models data/models";
    }
}

}  // namespace
}  // namespace kerf::core::test
