// No call of the library ends in undefined behaviour, whatever it is given: each test goes through one header. Most of
// what is seen here the address and undefined-behaviour sanitizers see.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include "baseline/baseline.h"
#include "common/cutting/cut.h"
#include "common/io/mesh_file.h"
#include "common/mesh/coordinate_grain.h"
#include "common/mesh/mass_moments.h"
#include "common/mesh/mass_properties.h"
#include "common/mesh/plane_frame.h"
#include "common/mesh/plane_noise.h"
#include "common/mesh/support_points.h"
#include "common/proxy/collision_proxy.h"
#include "common/proxy/convex_hull.h"
#include "common/repair/mesh_facts.h"
#include "common/repair/repair.h"
#include "common/shapes/shapes.h"
#include "support/backends.h"
#include "support/fixtures.h"
#include "support/referee.h"
#include "support/temporary_folder.h"

namespace kerf::core {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN(), kInfinity = std::numeric_limits<float>::infinity();
constexpr std::uint32_t kMost = std::numeric_limits<std::uint32_t>::max();
constexpr double kLargest = std::numeric_limits<double>::max();

class AnyArgument : public testing::TestWithParam<test::NamedBackend>
{
protected:
    std::unique_ptr<Cuttable> object() const
    {
        return std::move(backend_->prepare(test::closed_shape("sphere_in_sphere")).object);
    }
    std::unique_ptr<Backend> backend_ = GetParam().make();
};

INSTANTIATE_TEST_SUITE_P(All, AnyArgument, testing::ValuesIn(test::backends()),
                         [](const auto& back_end) { return back_end.param.name; });

/// Planes that are none, and planes beside everything.
std::vector<Plane> wild_planes()
{
    std::vector<Plane> planes;
    for (const double x : {0.0, -0.0, 1.0, -1.0, 1e-320, kLargest, -kLargest, std::nan(""), double(kInfinity)})
        for (const double y : {0.0, 1.0, kLargest, std::nan("")})
            for (const double offset : {0.0, 1.0, kLargest, -double(kInfinity), std::nan("")})
                planes.push_back({{x, y, 0.0}, offset});
    return planes;
}

TEST_P(AnyArgument, EveryPlaneIsCutByOrRefused)
{
    auto whole = object();
    const auto bytes = referee::bytes_of(whole->to_indexed_mesh());
    for (const Plane& plane : wild_planes()) {
        CutResult result = cut(std::move(whole), plane);
        EXPECT_EQ(result.status == Status::invalid_argument, !plane.valid());
        if (!result.object) {
            EXPECT_EQ(result.status, Status::done);
            whole = object();
            continue;
        }
        whole = std::move(result.object);
        EXPECT_EQ(referee::bytes_of(whole->to_indexed_mesh()), bytes);
    }
}

TEST_P(AnyArgument, NothingToCutIsAStatus)
{
    EXPECT_EQ(cut(nullptr, Plane{}).status, Status::invalid_mesh);
    CutResult result = cut(object(), Plane{});
    ASSERT_EQ(result.status, Status::done);
    const CutResult elsewhere = std::move(result);
    // NOLINTBEGIN(bugprone-use-after-move): that is what is tested
    EXPECT_EQ(cut(std::move(result.object), Plane{}).status, Status::invalid_mesh);
    EXPECT_TRUE(result.positive.empty() && result.negative.empty());
    PrepareResult prepared = backend_->prepare(test::closed_shape("cube"));
    const PrepareResult taken = std::move(prepared);
    EXPECT_EQ(cut(std::move(prepared.object), Plane{}).status, Status::invalid_mesh);
    IndexedMesh mesh = test::closed_shape("cube");
    EXPECT_EQ(backend_->prepare(std::move(mesh)).status, Status::done);
    EXPECT_EQ(backend_->prepare(std::move(mesh)).status, Status::invalid_mesh);
    // NOLINTEND(bugprone-use-after-move)
    EXPECT_EQ(backend_->prepare(IndexedMesh()).status, Status::invalid_mesh);
    EXPECT_EQ(backend_->prepare(ProvenMesh()).status, Status::invalid_mesh);
}

TEST_P(AnyArgument, ACapMaterialThatDoesNotExistIsTheDefaultOne)
{
    std::vector<std::vector<std::uint32_t>> sides;
    for (const std::uint32_t material : {kDefaultCapMaterial, 1u, 77u, kMost - 1}) {
        CutOptions options;
        options.cap_material = material;
        const CutResult result = cut(object(), Plane{}, options);
        ASSERT_EQ(result.status, Status::done);
        const IndexedMesh side = result.negative.front()->to_indexed_mesh();
        EXPECT_EQ(side.materials.back().name, "cap");
        sides.push_back(referee::bytes_of(side));
        EXPECT_EQ(sides.back(), sides.front());
    }
}

TEST_P(AnyArgument, AProxyOfAKindThatIsNotMadeIsEmpty)
{
    for (int kind = 0; kind < 256; ++kind) {
        const CollisionProxy proxy = collision_proxy(*object(), static_cast<ProxyKind>(kind));
        if (kind >= static_cast<int>(ProxyKind::points)) {
            EXPECT_TRUE(proxy.box.empty() && proxy.points.empty() && proxy.faces.empty() && proxy.radius == 0.0f);
        }
    }
}

TEST(AnyEnumerator, HasAName)
{
    for (int i = 0; i < 256; ++i) {
        EXPECT_FALSE(name_of(static_cast<Status>(i)).empty());
        EXPECT_FALSE(name_of(static_cast<Phase>(i)).empty());
        EXPECT_FALSE(name_of(static_cast<ProxyKind>(i)).empty());
        EXPECT_FALSE(baseline::name_of(static_cast<baseline::VertexLookup>(i)).empty());
    }
}

TEST(AnyEnumerator, OfAPhaseThatDoesNotExistIsAnException)
{
    PhaseTimes times;
    EXPECT_THROW(times[static_cast<Phase>(kPhaseCount)] = 1.0, std::out_of_range);
    EXPECT_THROW((void)std::as_const(times)[static_cast<Phase>(255)], std::out_of_range);
    EXPECT_EQ(times.total(), 0.0);
}

TEST(AnyEnumerator, OfALookupThatDoesNotExistIsTheDefaultOne)
{
    for (const int lookup : {4, 77, 255}) {
        const auto backend = baseline::make_back_end(static_cast<baseline::VertexLookup>(lookup));
        EXPECT_EQ(backend->name(), "baseline/hash");
        PrepareResult prepared = backend->prepare(test::closed_shape("cube"));
        EXPECT_EQ(cut(std::move(prepared.object), Plane{}).status, Status::done);
    }
}

TEST(AnyMesh, IsMeasuredOrMeasuresAsNothing)
{
    const IndexedMesh cube = test::closed_shape("cube");
    EXPECT_EQ(measure(cube).triangles, 12u);
    EXPECT_EQ(mass_properties(IndexedMesh()).volume, 0.0);
    EXPECT_EQ(measure(IndexedMesh()).triangles, 0u);

    IndexedMesh wild = cube;
    wild.triangles[3][1] = kMost;
    EXPECT_EQ(mass_properties(wild).volume, 0.0);
    EXPECT_EQ(measure(wild).triangles, 0u);
    wild = cube;
    wild.points[3] = kMost - 1;
    EXPECT_EQ(measure(wild).triangles, 0u);
    wild = cube;
    wild.points.pop_back();
    EXPECT_EQ(measure(wild).triangles, 0u);
    wild = cube;
    wild.point_count = kMost;  // would be 16 GB of counters
    EXPECT_EQ(measure(wild).triangles, 0u);
    wild = cube;
    wild.vertices[0].position.x = kNan;
    EXPECT_EQ(measure(wild).triangles, 12u);
    EXPECT_TRUE(std::isnan(mass_properties(wild).volume));
    const IndexedMesh elsewhere = std::move(wild);
    // NOLINTNEXTLINE(bugprone-use-after-move): that is what is tested
    EXPECT_EQ(measure(wild).triangles, 0u);
}

TEST(AnySoup, IsMeasuredRepairedOrRefused)
{
    TriangleSoup soup = shapes::box({1, 1, 1}, {1, 1, 1});
    soup.triangles[2][0] = kMost;
    EXPECT_EQ(measure(soup).triangles, 0u);
    EXPECT_NE(repair(soup).error, "");
    EXPECT_TRUE(repair(soup).mesh->triangles.empty());
    EXPECT_EQ(shapes::shuffled(soup, 1).triangles, soup.triangles);

    soup = shapes::box({1, 1, 1}, {1, 1, 1});
    soup.streams.push_back({"short", 4, Buffer<float>(3, 1.0f)});
    EXPECT_EQ(shapes::shuffled(soup, 1).triangles, soup.triangles);
    EXPECT_NE(repair(soup).error, "");
    soup.streams[0] = {"wide", kMost, {}};
    EXPECT_NE(repair(soup).error, "");
    soup.streams.clear();
    soup.triangle_materials = {0, 1};
    EXPECT_EQ(shapes::shuffled(soup, 1).triangles, soup.triangles);
    EXPECT_NE(repair(soup).error, "");
    const TriangleSoup elsewhere = std::move(soup);
    // NOLINTNEXTLINE(bugprone-use-after-move): that is what is tested
    EXPECT_NE(repair(soup).error, "");
    EXPECT_EQ(measure(TriangleSoup()).triangles, 0u);
    EXPECT_TRUE(shapes::shuffled(TriangleSoup(), 1).triangles.empty());
}

TEST(AnySoup, LosesNoNumberToNormalsAndUvThatAreNone)
{
    TriangleSoup soup = shapes::box({1, 1, 1}, {1, 1, 1});
    soup.vertices[0].normal = {kNan, 0, 0};
    soup.vertices[1].normal = glm::vec3(kInfinity);
    soup.vertices[2].uv = {0.5f, -kInfinity};
    soup.vertices[3].normal = glm::vec3(0.0f);
    const Repaired repaired = repair(soup);
    EXPECT_EQ(repaired.error, "");
    EXPECT_EQ(repaired.repairs.replaced_attributes, 3u);
    EXPECT_EQ(repaired.repairs.describe(), "3 vertices with a normal or uv that is not finite given another");
    EXPECT_EQ(prove(repaired.mesh).error, "");
    for (const Vertex& v : repaired.mesh->vertices) EXPECT_NEAR(glm::length(v.normal), 1.0f, 1e-6f);
    // Normals that are not asked for are not missed.
    soup.has_normals = false;
    EXPECT_EQ(repair(soup).repairs.replaced_attributes, 1u);
}

TEST(AnyPoints, HaveAHullOfThoseThatAreSomewhere)
{
    std::vector<glm::vec3> points;
    for (int i = 0; i < 8; ++i) {
        points.push_back({float(i & 1), float(i >> 1 & 1), float(i >> 2)});
        points.push_back({i % 2 == 0 ? kNan : kInfinity, float(i), -kInfinity});
    }
    const ConvexHull hull = convex_hull(points);
    EXPECT_EQ(hull.corners.size(), 8u);
    EXPECT_EQ(hull.faces.size(), 12u);
    for (const std::uint32_t corner : hull.corners) EXPECT_EQ(corner % 2, 0u);
    EXPECT_TRUE(convex_hull({}).corners.empty());
    EXPECT_TRUE(convex_hull(std::vector<glm::vec3>(5, glm::vec3(kNan))).corners.empty());
    constexpr float kEnd = std::numeric_limits<float>::max();
    EXPECT_EQ(convex_hull(std::vector<glm::vec3>{{kEnd, 0, 0}, {-kEnd, 0, 0}, {0, kEnd, 0}, {0, 0, kEnd}}).faces.size(),
              4u);
}

TEST(AnyPoints, HaveAProxy)
{
    for (const float number : {kNan, kInfinity, -kInfinity, std::numeric_limits<float>::max(), 1e-45f}) {
        std::vector<Vertex> vertices;
        for (int i = 0; i < 70; ++i)
            vertices.push_back(
                {{i % 3 == 0 ? number : float(i % 5), float(i % 7), i % 4 == 1 ? number : 0.0f}, {0, 0, 1}, {0, 0}});
        support_points(vertices);
        for (int kind = 0; kind < 6; ++kind) {
            const CollisionProxy proxy = collision_proxy(static_cast<ProxyKind>(kind), vertices);
            for (const Triangle& face : proxy.faces)
                for (const std::uint32_t corner : face) EXPECT_LT(corner, proxy.points.size());
            EXPECT_TRUE(collision_proxy(static_cast<ProxyKind>(kind), {}).points.empty());
        }
        std::array<glm::vec3, kSupportDirections> points;
        points.fill(glm::vec3(number));
        Box box;
        box.add(glm::vec3(number));
        EXPECT_LE(bounded_hull(box, points).points.size(), 1u);
        EXPECT_TRUE(bounded_hull(Box(), points).points.empty());
        EXPECT_TRUE(hull_faces(points).empty());
        mass_reference(box);
        coordinate_grain(box);
    }
}

TEST(AnyPoints, HaveEdgesWhereTheyExist)
{
    const std::vector<Vertex> vertices(3, Vertex{});
    EXPECT_EQ(shortest_edge(vertices, std::vector<Triangle>{{0, 1, 2}, {0, 1, 3}, {kMost, 0, 1}}), double(kInfinity));
    EXPECT_EQ(shortest_edge({}, std::vector<Triangle>{{0, 1, 2}}), double(kInfinity));
}

TEST(AnyNumbers, MakeAPlaneOrNone)
{
    for (const double x : {0.0, 1.0, 1e-320, 1e200, kLargest, std::nan(""), double(kInfinity)})
        for (const double y : {0.0, 1e-320, kLargest, std::nan("")}) {
            const auto plane = Plane::through({x, y, 1.0}, {y, x, 0.0});
            if (plane) {
                EXPECT_TRUE(plane->valid());
                EXPECT_TRUE(plane->flipped().valid());
            }
            PlaneFrame::of({x, y, 0.0});
            Box box;
            box.add(glm::vec3(float(y)));
            Plane{{x, y, 0.0}, x}.distance_range(box);
        }
    for (const float number : {0.0f, kNan, kInfinity, std::numeric_limits<float>::max(), -1.0f}) plane_noise(number);
    EXPECT_FALSE((Plane{{0.0, 0.0, 0.0}, 0.0}.valid()));
    EXPECT_TRUE(Plane{}.valid());
}

TEST(AnyNumbers, MakeAShapeOrAnException)
{
    using namespace shapes;
    const std::vector<float> sizes{0.0f, -1.0f, kNan, kInfinity, std::numeric_limits<float>::max()};
    for (const float size : sizes) {
        // What is no mesh repair() says.
        for (const TriangleSoup& soup :
             {icosphere(size, 0), uv_sphere(size, 0, 0), box(glm::vec3(size), {0, 0, 0}), cylinder(size, size, 0, 0),
              cone(size, size, 0), torus(size, size, 0, 0), pipe(size, size, size, 0, 0), bowl(size, size, 0, 0),
              comb(0), l_step(0), two_legs(0), tray(0), menger_sponge(0), nested_spheres({}, 0),
              nested_spheres(sizes, 0), sphere_in_sphere(size, size, 0), overlapping_spheres(size, size, 0)})
            repair(soup);
        EXPECT_GT(spiral_wall(std::min(size, 1.0f), 0).triangles.size(), 0u);
    }
    for (const std::uint32_t many : {kMost, kMost - 1, kMost / 2}) {
        EXPECT_THROW(icosphere(1, many), std::length_error);
        EXPECT_THROW(uv_sphere(1, many, many), std::length_error);
        EXPECT_THROW(uv_sphere(1, 3, many), std::length_error);
        EXPECT_THROW(box({1, 1, 1}, {many, 1, 1}), std::length_error);
        EXPECT_THROW(cylinder(1, 1, many), std::length_error);
        EXPECT_THROW(cylinder(1, 1, 3, many), std::length_error);
        EXPECT_THROW(cone(1, 1, many), std::length_error);
        EXPECT_THROW(torus(1, 1, many, 3), std::length_error);
        EXPECT_THROW(torus(1, 1, 3, many), std::length_error);
        EXPECT_THROW(pipe(1, 1, 1, 3, many), std::length_error);
        EXPECT_THROW(bowl(1, 1, many, 1), std::length_error);
        EXPECT_THROW(bowl(1, 1, 3, many), std::length_error);
        EXPECT_THROW(comb(many), std::length_error);
        EXPECT_THROW(l_step(many), std::length_error);
        EXPECT_THROW(two_legs(many), std::length_error);
        EXPECT_THROW(tray(many), std::length_error);
        EXPECT_THROW(spiral_wall(1, many), std::length_error);
        EXPECT_THROW(nested_spheres(sizes, many), std::length_error);
        EXPECT_THROW(overlapping_spheres(1, 1, many), std::length_error);
    }
    EXPECT_THROW(spiral_wall(kInfinity, 8), std::length_error);
    EXPECT_THROW(spiral_wall(1e30f, 8), std::length_error);
    EXPECT_FALSE(make("no such shape", kMost, 0));
}

TEST(AnyMesh, IsWrittenOrRefused)
{
    const test::TemporaryFolder folder;
    std::vector<IndexedMesh> meshes(1);
    const auto add = [&](auto&& change) {
        meshes.push_back(test::closed_shape("uv_sphere"));
        change(meshes.back());
    };
    add([](IndexedMesh& mesh) { mesh.triangles[0][0] = kMost; });
    add([](IndexedMesh& mesh) { mesh.points[0] = kMost; });
    add([](IndexedMesh& mesh) { mesh.points.clear(); });
    add([](IndexedMesh& mesh) { mesh.groups[0].count += 1; });
    add([](IndexedMesh& mesh) { mesh.groups[0].first = kMost; });
    add([](IndexedMesh& mesh) { mesh.groups[0].material = kMost; });
    add([](IndexedMesh& mesh) { mesh.materials.clear(); });
    add([](IndexedMesh& mesh) { mesh.streams[0].values.pop_back(); });
    add([](IndexedMesh& mesh) { mesh.streams[0].width = kMost; });
    add([](IndexedMesh& mesh) { mesh.streams[0] = {"color", 4, {}}; });
    add([](IndexedMesh& mesh) { mesh.vertices.clear(); });
    for (const std::string& format : io::writable_formats()) {
        for (const IndexedMesh& mesh : meshes)
            EXPECT_THROW(io::write_mesh(folder.file("a." + format), mesh), io::FileError);
        IndexedMesh odd = test::closed_shape("cube");
        odd.materials[0] = {std::string("\0\n", 2), glm::vec4(kNan), "\n"};
        odd.streams.push_back({"color", 3, Buffer<float>(3 * odd.vertices.size(), kNan)});
        EXPECT_NO_THROW(io::write_mesh(folder.file("b." + format), odd));
        EXPECT_TRUE(folder.exists("b." + format));
        EXPECT_FALSE(folder.exists("a." + format));
    }
    for (const char* name : {"", ".", "..", "/", "/nowhere/at/all.obj", "no_extension", "a.OBJ/"})
        EXPECT_THROW(io::write_mesh(name, test::closed_shape("cube")), io::FileError) << name;
    for (const char* name : {"", ".", "/", "nothing.obj", "no_extension"})
        EXPECT_THROW(io::read_mesh(name), io::FileError) << name;
}

}  // namespace
}  // namespace kerf::core
