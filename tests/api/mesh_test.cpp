#include <kerf/kerf.h>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <set>
#include <tuple>

#include "api/objects.h"

namespace kerf {
namespace {

using test::Arrays;

TEST(Mesh, OfArraysHasTheirTrianglesAndPlaces)
{
    const Arrays cube = test::cube_arrays();
    MeshReport report;
    const Result<Mesh> mesh = Mesh::make(cube.input(), &report);
    ASSERT_TRUE(mesh) << mesh.reason();
    EXPECT_EQ(mesh->triangle_count(), 12u);
    EXPECT_TRUE(mesh->is_closed());
    EXPECT_EQ(mesh->arrays().point_count, 8u);
    EXPECT_EQ(mesh->bounds().lo, Vec3f(-1, -1, -1));
    EXPECT_EQ(mesh->bounds().hi, Vec3f(1, 1, 1));
    EXPECT_EQ(report.facts.triangles, 12u);
    EXPECT_EQ(report.facts.vertices, 8u);
    EXPECT_DOUBLE_EQ(report.facts.volume, 8.0);
    EXPECT_DOUBLE_EQ(report.facts.area, 24.0);
    EXPECT_EQ(report.repairs, Repairs());
    EXPECT_TRUE(describe(report.repairs).is_empty());
}

TEST(Mesh, CloneHasTheSameArraysAndSharesNothing)
{
    const Mesh mesh = test::shape("torus");
    const Result<Mesh> copy = mesh.clone();
    ASSERT_TRUE(copy) << copy.reason();
    EXPECT_EQ(test::bytes_of(*copy), test::bytes_of(mesh));
    EXPECT_NE(copy->arrays().positions.data(), mesh.arrays().positions.data());
    EXPECT_EQ(Mesh(mesh).arrays().positions.data(), mesh.arrays().positions.data()) << "copies share";
    EXPECT_EQ(Mesh().clone().status(), Status::invalid_mesh);
}

TEST(Mesh, MadeNormalsKeepEdgesSharpThatTurnByMoreThanIsSaid)
{
    const Arrays cube = test::cube_arrays();  // without normals
    const auto vertices = [&](float crease) {
        MeshInput input = cube.input();
        input.crease_degrees = crease;
        return Mesh::make(input)->vertex_count();
    };
    EXPECT_EQ(vertices(40.0f), 24u);
    EXPECT_EQ(vertices(89.0f), 24u);
    EXPECT_EQ(vertices(91.0f), 8u);
    EXPECT_EQ(vertices(180.0f), 8u);
    for (const float wrong : {-1.0f, 181.0f, std::numeric_limits<float>::quiet_NaN()}) {
        MeshInput input = cube.input();
        input.crease_degrees = wrong;
        const Result<Mesh> mesh = Mesh::make(input);
        EXPECT_EQ(mesh.status(), Status::invalid_mesh);
        EXPECT_NE(std::string(mesh.reason()).find("creases"), std::string::npos);
    }
}

TEST(Mesh, StreamsHaveNoValueThatIsNotFinite)
{
    const Arrays cube = test::cube_arrays();
    std::vector<float> heat(8, 2.0f);
    heat[3] = std::numeric_limits<float>::quiet_NaN();
    const StreamInput stream{"heat", heat.data(), 1, 0};
    MeshInput input = cube.input();
    input.streams = {&stream, 1};
    const Mesh mesh = *Mesh::make(input);
    std::size_t zeros = 0;
    for (const float value : mesh.stream(0).values) {
        EXPECT_TRUE(value == 2.0f || value == 0.0f);
        zeros += value == 0.0f ? 1 : 0;
    }
    EXPECT_EQ(zeros, 3u) << "the corner has a vertex in each of three faces";
}

TEST(Mesh, ReadsAnyStride)
{
    struct GameVertex
    {
        float colour[4];
        float position[3];
        unsigned char bone;
        float uv[2];
    };
    const Arrays cube = test::cube_arrays();
    std::vector<GameVertex> vertices;
    for (std::size_t i = 0; i < cube.positions.size(); ++i) {
        const std::array<float, 3>& p = cube.positions[i];
        vertices.push_back({{1, 0, 0, float(i)}, {p[0], p[1], p[2]}, 7, {p[0], p[1]}});
    }
    MeshInput input = cube.input();
    input.positions = vertices[0].position;
    input.uvs = vertices[0].uv;
    input.position_stride = input.uv_stride = sizeof(GameVertex);
    const StreamInput colour{"colour", vertices[0].colour, 4, sizeof(GameVertex)};
    input.streams = {&colour, 1};
    const Result<Mesh> mesh = Mesh::make(input);
    ASSERT_TRUE(mesh) << mesh.reason();
    const MeshArrays arrays = mesh->arrays();
    ASSERT_EQ(mesh->stream_count(), 1u);
    EXPECT_STREQ(mesh->stream(0).name, "colour");
    std::vector<VertexOrigin> origins(arrays.positions.size());
    ASSERT_EQ(vertex_origins(*mesh, input, origins), Status::done);
    for (std::size_t v = 0; v < arrays.positions.size(); ++v) {
        EXPECT_EQ(arrays.uvs[v].x, arrays.positions[v].x);
        EXPECT_EQ(arrays.uvs[v].y, arrays.positions[v].y);
        const float* values = &mesh->stream(0).values[4 * v];
        EXPECT_EQ(values[0], 1.0f);
        const auto heaviest = std::max_element(origins[v].weights, origins[v].weights + 3) - origins[v].weights;
        EXPECT_EQ(origins[v].weights[heaviest], 1.0f);
        EXPECT_EQ(values[3], float(origins[v].vertices[heaviest])) << "each vertex keeps its own numbers";
    }
}

TEST(Mesh, WithoutIndicesHasATriangleForEachThreeVertices)
{
    const Arrays cube = test::cube_arrays();
    Arrays soup;
    for (const std::uint32_t index : cube.indices) soup.positions.push_back(cube.positions[index]);
    MeshInput input = soup.input();
    input.triangle_count = 12;
    const Result<Mesh> mesh = Mesh::make(input);
    ASSERT_TRUE(mesh) << mesh.reason();
    EXPECT_EQ(mesh->arrays().point_count, 8u) << "vertices of one place are one point";
    EXPECT_TRUE(mesh->is_closed());
    input.triangle_count = 11;
    EXPECT_EQ(Mesh::make(input).status(), Status::invalid_mesh);
}

/// Expects a refusal with a sentence.
void expect_refused(const MeshInput& input, Status status = Status::invalid_mesh)
{
    const Result<Mesh> mesh = Mesh::make(input);
    EXPECT_EQ(mesh.status(), status);
    EXPECT_STRNE(mesh.reason(), "");
    EXPECT_TRUE(mesh->is_empty());
}

TEST(Mesh, OfArraysThatAreNoMeshIsRefusedWithASentence)
{
    expect_refused(MeshInput());
    const Arrays cube = test::cube_arrays();
    MeshInput input = cube.input();
    input.triangle_count = 0;
    expect_refused(input);

    Arrays wrong = cube;
    wrong.indices[5] = 8;
    expect_refused(wrong.input());
    for (const float bad : {std::numeric_limits<float>::infinity(), std::numeric_limits<float>::quiet_NaN()}) {
        wrong = cube;
        wrong.positions[3][1] = bad;
        expect_refused(wrong.input());
    }
    const StreamInput no_values{"colour", nullptr, 4};
    input = cube.input();
    input.streams = {&no_values, 1};
    expect_refused(input);
    const std::vector<float> values(std::size_t{17} * 8);
    for (const std::uint32_t width : {0u, 17u}) {
        const StreamInput stream{"colour", values.data(), width};
        input.streams = {&stream, 1};
        expect_refused(input);
    }
}

TEST(Mesh, SaysWhatItRepaired)
{
    Arrays cube = test::cube_arrays();
    std::swap(cube.indices[0], cube.indices[1]);
    cube.indices.insert(cube.indices.end(), {0, 0, 1});
    MeshReport report;
    const Result<Mesh> mesh = Mesh::make(cube.input(), &report);
    ASSERT_TRUE(mesh) << mesh.reason();
    EXPECT_EQ(report.repairs.degenerate_triangles, 1u);
    EXPECT_EQ(report.repairs.flipped_triangles, 1u);
    EXPECT_STRNE(describe(report.repairs).c_str(), "");
    EXPECT_TRUE(mesh->is_closed());
}

TEST(Mesh, MakesSmoothNormalsIfThereAreNone)
{
    const MeshArrays arrays = test::mesh_of(test::cube_arrays()).arrays();
    static_cast<void>(arrays);
    const Mesh cube = test::mesh_of(test::cube_arrays());
    for (const Vec3f& n : cube.arrays().normals) EXPECT_FLOAT_EQ(n.x * n.x + n.y * n.y + n.z * n.z, 1.0f);
    EXPECT_EQ(cube.vertex_count(), 24u) << "edges of a cube stay sharp: three vertices for each corner";
}

TEST(Mesh, CopiesShareWhatTheyHold)
{
    Mesh a = test::mesh_of(test::cube_arrays());
    const Mesh b = a;
    EXPECT_EQ(a.arrays().positions.data(), b.arrays().positions.data());
    const Mesh c = std::move(a);
    EXPECT_EQ(c.triangle_count(), 12u);
    EXPECT_TRUE(a.is_empty());  // NOLINT(bugprone-use-after-move): that is what is tested
    EXPECT_EQ(a.triangle_count(), 0u);
    EXPECT_TRUE(a.arrays().positions.empty());
    a = c;
    EXPECT_EQ(a.triangle_count(), 12u);
}

TEST(Mesh, KeepsMaterialsAndWhichTriangleHasWhich)
{
    Arrays cube = test::cube_arrays();
    for (std::uint32_t t = 0; t < 12; ++t) cube.materials.push_back(t % 2);
    const Material materials[2]{{"skin", {1, 0, 0, 1}, "skin.png"}, {"bone", {0, 0, 1, 1}, ""}};
    MeshInput input = cube.input();
    input.materials = materials;
    const Result<Mesh> mesh = Mesh::make(input);
    ASSERT_TRUE(mesh) << mesh.reason();
    ASSERT_EQ(mesh->material_count(), 2u);
    EXPECT_STREQ(mesh->material(0).name, "skin");
    EXPECT_STREQ(mesh->material(0).base_colour_image, "skin.png");
    EXPECT_EQ(mesh->material(1).base_colour[2], 1.0f);
    const MeshArrays arrays = mesh->arrays();
    for (std::size_t t = 0; t < arrays.sources.size(); ++t)
        EXPECT_EQ(arrays.triangle_materials[t], arrays.sources[t] % 2);
    EXPECT_STREQ(mesh->material(7).name, "");
}

/// The point that an origin names.
Vec3d place_of(const VertexOrigin& origin, const Arrays& arrays)
{
    Vec3d p;
    for (int i = 0; i < 3; ++i) {
        const std::array<float, 3>& corner = arrays.positions[origin.vertices[i]];
        p.x += double(origin.weights[i]) * double(corner[0]);
        p.y += double(origin.weights[i]) * double(corner[1]);
        p.z += double(origin.weights[i]) * double(corner[2]);
    }
    return p;
}

RC_GTEST_PROP(VertexOrigins, NameThePlaceOfEachVertexHoweverOftenItWasCut, (std::uint64_t seed))
{
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> number(-0.4, 0.4);
    const Arrays cube = test::cube_arrays();
    for (const std::string& name : test::back_end_names()) {
        Object object = test::cube(name);
        for (int i = 0; i < 4; ++i) {
            Cut result = cut(std::move(object), test::plane_at(number(random), number(random), number(random),
                                                               number(random), number(random), number(random) + 0.5));
            Object* const piece = result.one(i % 2 == 0 ? Side::negative : Side::positive);
            object = piece != nullptr ? std::move(*piece) : std::move(result.object);
        }
        const Mesh mesh = *object.mesh();
        const MeshArrays arrays = mesh.arrays();
        std::vector<VertexOrigin> origins(arrays.positions.size());
        RC_ASSERT(vertex_origins(mesh, cube.input(), origins) == Status::done);
        std::vector<bool> is_of_cap(origins.size(), true);
        for (std::size_t t = 0; t < arrays.kinds.size(); ++t)
            if (arrays.kinds[t] == TriangleKind::surface)
                for (std::size_t i = 0; i < 3; ++i) is_of_cap[arrays.indices[3 * t + i]] = false;
        for (std::size_t v = 0; v < origins.size(); ++v) {
            RC_ASSERT((origins[v].vertices[0] == kNone) == is_of_cap[v]);
            if (is_of_cap[v]) continue;
            const Vec3d p = place_of(origins[v], cube);
            RC_ASSERT(std::abs(p.x - double(arrays.positions[v].x)) < 1e-5);
            RC_ASSERT(std::abs(p.y - double(arrays.positions[v].y)) < 1e-5);
            RC_ASSERT(std::abs(p.z - double(arrays.positions[v].z)) < 1e-5);
        }
    }
}

TEST(VertexOrigins, OfAnotherInputAreRefused)
{
    const Arrays cube = test::cube_arrays();
    const Mesh mesh = test::mesh_of(cube);
    std::vector<VertexOrigin> origins(mesh.vertex_count());
    MeshInput shorter = cube.input();
    shorter.triangle_count = 11;
    EXPECT_EQ(vertex_origins(mesh, shorter, origins), Status::invalid_argument);
    EXPECT_EQ(vertex_origins(mesh, cube.input(), std::span(origins).first(3)), Status::invalid_argument);
    EXPECT_EQ(vertex_origins(mesh, MeshInput(), origins), Status::invalid_argument);
    for (const std::size_t stride : {std::size_t{0}, std::size_t{11}, SIZE_MAX / 2}) {
        MeshInput strided = cube.input();
        strided.position_stride = stride;
        EXPECT_EQ(vertex_origins(mesh, strided, origins), Status::invalid_argument) << stride;
    }
}

TEST(MeshOfAPiece, CanBePreparedThoughSurfacesLieOnOneAnother)
{
    // A leaf: two triangles back to back. And a box with such a leaf beside it.
    test::Arrays leaf;
    leaf.positions = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}};
    leaf.indices = {0, 1, 2, 0, 2, 1};
    test::Arrays both = test::cube_arrays();
    const auto first = static_cast<std::uint32_t>(both.positions.size());
    for (const auto& p : leaf.positions) both.positions.push_back({p[0] + 3, p[1], p[2]});
    for (const std::uint32_t corner : leaf.indices) both.indices.push_back(first + corner);
    for (const test::Arrays& arrays : {leaf, both})
        for (const std::string& name : test::back_end_names())
            for (const double x : {0.5, 3.5}) {
                Cut cut = kerf::cut(test::object_of(test::mesh_of(arrays), name), *Plane::x(x));
                for (const Side side : {Side::positive, Side::negative}) {
                    const Object* const piece = cut.one(side);
                    if (piece == nullptr) continue;
                    const Mesh mesh = *piece->mesh();
                    PrepareOptions options;
                    options.back_end_name = name.c_str();
                    const Result<Object> again = prepare(mesh, options);
                    ASSERT_TRUE(again) << name << ' ' << x << ": " << again.reason();
                    EXPECT_EQ(again->triangle_count(), piece->triangle_count());
                    EXPECT_NEAR(again->mass_properties().volume, piece->mass_properties().volume, 1e-12);
                    // What each triangle is, and of which it was, in no order.
                    const auto facts = [](const MeshArrays& a) {
                        std::multiset<std::tuple<TriangleKind, std::uint32_t, std::uint32_t>> all;
                        for (std::size_t t = 0; t < a.kinds.size(); ++t)
                            all.emplace(a.kinds[t], a.sources[t], a.triangle_materials[t]);
                        return all;
                    };
                    const Mesh mesh_again = *again->mesh();
                    EXPECT_EQ(facts(mesh_again.arrays()), facts(mesh.arrays())) << name << ' ' << x;
                }
            }
}

TEST(VertexOrigins, OfPointsOnAnEdgeHaveTwoWeights)
{
    const Mesh torus = test::shape("torus", 400);
    const MeshArrays given = torus.arrays();
    MeshInput input;
    input.positions = &given.positions[0].x;
    input.vertex_count = given.positions.size();
    input.indices = given.indices.data();
    input.triangle_count = given.indices.size() / 3;
    const Mesh mesh = *Mesh::make(input);
    for (const std::string& name : test::back_end_names()) {
        Cut halves = cut(test::object_of(mesh, name), test::plane_at(0.01, 0.02, 0.03, 1, 2, 3));
        const Mesh half = *halves.one(Side::positive)->mesh();
        std::vector<VertexOrigin> origins(half.vertex_count());
        ASSERT_EQ(vertex_origins(half, input, origins), Status::done);
        std::size_t cut_points = 0;
        for (const VertexOrigin& origin : origins) {
            if (origin.vertices[0] == kNone) continue;
            const auto weights = std::count_if(std::begin(origin.weights), std::end(origin.weights),
                                               [](float weight) { return weight != 0.0f; });
            EXPECT_GE(weights, 1);
            EXPECT_LE(weights, 2);
            cut_points += weights == 2 ? 1 : 0;
        }
        EXPECT_GT(cut_points, 20u) << name;
    }
}

}  // namespace
}  // namespace kerf
