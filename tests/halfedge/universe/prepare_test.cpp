// Preparing keeps the mesh and stays within its budget of memory.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <random>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "common/shapes/shapes.h"
#include "halfedge/fragment.h"
#include "halfedge/halfedge.h"
#include "support/fixtures.h"
#include "support/referee.h"

namespace kerf::core::halfedge {
namespace {

TEST(Prepare, KeepsEveryTriangleWithItsAttributes)
{
    for (const auto* shapes : {&test::closed_shapes(), &test::open_shapes()})
        for (const auto& shape : *shapes) {
            const auto object = std::move(make_back_end()->prepare(shape.mesh).object);
            const IndexedMesh copy = object->to_indexed_mesh();
            EXPECT_EQ(check(copy), "");
            EXPECT_EQ(referee::canonical_surface(copy), referee::canonical_surface(shape.mesh)) << shape.name;
            EXPECT_EQ(copy.point_count, shape.mesh.point_count) << shape.name;
            EXPECT_EQ(referee::open_edges(copy), referee::open_edges(shape.mesh)) << shape.name;
        }
}

TEST(Prepare, HoldsAtMostTheStatedMemory)
{
    for (const auto& [triangles, bytes_per_triangle] : {std::pair{10'000u, 200.0}, {100'000u, 150.0}}) {
        const auto object = std::move(make_back_end()->prepare(test::repaired(shapes::asteroid(triangles, 1))).object);
        const auto& fragment = dynamic_cast<const Fragment&>(*object);
        EXPECT_LE(double(fragment.universe().bytes_reserved()), bytes_per_triangle * double(object->triangle_count()));
    }
}

/// Connectivity, positions and what else a universe holds of a mesh, number by number.
std::vector<std::uint64_t> contents(const Cuttable& object)
{
    const Universe& u = dynamic_cast<const Fragment&>(object).universe();
    std::vector<std::uint64_t> all;
    const auto add_floats = [&](const auto& values) {
        for (const float value : values) all.push_back(std::bit_cast<std::uint32_t>(value));
    };
    for (const Vertex& v : u.vertices)
        add_floats(
            std::array{v.position.x, v.position.y, v.position.z, v.normal.x, v.normal.y, v.normal.z, v.uv.x, v.uv.y});
    for (const Stream& stream : u.streams) add_floats(stream.values);
    for (const Triangle& t : u.slots) all.insert(all.end(), t.begin(), t.end());
    for (const FaceId f : u.face_of_slot) all.push_back(number_of(f));
    all.insert(all.end(), u.source_of_face.begin(), u.source_of_face.end());
    for (Index f = 0; f < u.mesh.faces(); ++f) all.push_back(number_of(u.mesh.halfedge_of(FaceId(int(f)))));
    for (Index i = 0; i < 2 * u.mesh.edges(); ++i) {
        const HalfedgeId h{int(i)};
        for (const Index number :
             {number_of(u.mesh.next(h)), number_of(u.mesh.prev(h)), number_of(u.mesh.to(h)), number_of(u.mesh.face(h))})
            all.push_back(number);
    }
    for (Index i = 0; i < u.mesh.points(); ++i) {
        const glm::vec3 p = u.mesh.position(PointId(int(i)));
        add_floats(std::array{p.x, p.y, p.z});
        all.push_back(number_of(u.mesh.halfedge_of(PointId(int(i)))));
    }
    for (const Node& node : u.tree.nodes) {
        add_floats(
            std::array{node.box.lo.x, node.box.lo.y, node.box.lo.z, node.box.hi.x, node.box.hi.y, node.box.hi.z});
        for (const Index number :
             {node.left.number(), node.right.number(), node.first.number(), Index(node.count), node.group.number()})
            all.push_back(number);
    }
    return all;
}

/// Large enough for a second thread: closed, open, of several shells and materials, with streams.
std::vector<std::pair<std::string, IndexedMesh>> large_meshes()
{
    using namespace shapes;
    TriangleSoup bowl = icosphere(1.0f, 60);
    std::erase_if(bowl.triangles, [&](const Triangle& t) { return bowl.vertices[t[0]].position.z > 0.3f; });
    // An odd number of triangles, in any order: halves of them lie all over the same cells.
    TriangleSoup shuffled = asteroid(40'000, 1);
    shuffled.triangles.pop_back();
    std::mt19937 random(20);
    std::shuffle(shuffled.triangles.begin(), shuffled.triangles.end(), random);
    return {{"asteroid", test::repaired(asteroid(40'000, 1))},
            {"shuffled", test::repaired(shuffled)},
            {"bowl", test::repaired(bowl)},
            {"sphere with colours", test::repaired(test::with_colours(uv_sphere(1.0f, 300, 100)))},
            {"two shells, two materials",
             test::repaired(test::with_two_materials(test::joined(asteroid(20'000, 1), torus(9.0f, 1.0f, 200, 80))))},
            {"just enough", test::repaired(torus(1.0f, 0.4f, 100, 100))}};
}

TEST(Prepare, GivesTheSameObjectWhateverTheNumberOfThreads)
{
    for (const auto& [name, mesh] : large_meshes()) {
        SCOPED_TRACE(name);
        ASSERT_GE(mesh.triangles.size(), 20'000u);
        const ProvenMesh proven = std::move(prove(mesh).mesh);
        PrepareOptions options;
        const std::vector<std::uint64_t> alone = contents(*make_back_end()->prepare(proven, options).object);
        for (const unsigned threads : {2u, 7u}) {
            options.threads = threads;
            EXPECT_TRUE(contents(*make_back_end()->prepare(proven, options).object) == alone) << threads;
        }
    }
}

TEST(Prepare, CanBeStoppedAtAnyTimeWithTwoThreads)
{
    struct Call
    {
        int told = 0, stop_at = 0;
        std::thread::id caller = std::this_thread::get_id();
    };
    const ProvenMesh proven = std::move(prove(test::repaired(shapes::asteroid(60'000, 1))).mesh);
    const auto prepare = [&](Call& call) {
        PrepareOptions options;
        options.threads = 2;
        options.progress.user = &call;
        options.progress.tell = [](void* user, double) {
            Call& c = *static_cast<Call*>(user);
            EXPECT_EQ(std::this_thread::get_id(), c.caller);
            return ++c.told != c.stop_at;
        };
        return make_back_end()->prepare(proven, options);
    };
    Call whole;
    EXPECT_EQ(prepare(whole).status, Status::done);
    ASSERT_GE(whole.told, 5);
    for (int i = 1; i <= whole.told; ++i) {
        Call stopped;
        stopped.stop_at = i;
        const PrepareResult result = prepare(stopped);
        EXPECT_EQ(result.status, Status::cancelled) << i;
        EXPECT_EQ(result.object, nullptr) << i;
        EXPECT_EQ(stopped.told, i);
    }
}

TEST(Prepare, TheOrderOfTheInputMattersLittleToTheCut)
{
    const TriangleSoup soup = shapes::asteroid(20'000, 1);
    const auto coherent = std::move(make_back_end()->prepare(test::repaired(soup)).object);
    const auto shuffled = std::move(make_back_end()->prepare(test::repaired(shapes::shuffled(soup, 5))).object);
    const Plane plane = *Plane::through({0.1, 0, 0}, {1, 1, 1});
    const CutResult a = cut(coherent->clone(), plane), b = cut(shuffled->clone(), plane);
    EXPECT_EQ(a.statistics.crossing_triangles, b.statistics.crossing_triangles);
    EXPECT_NEAR(double(a.statistics.nodes_visited), double(b.statistics.nodes_visited),
                0.1 * double(a.statistics.nodes_visited));
}

}  // namespace
}  // namespace kerf::core::halfedge
