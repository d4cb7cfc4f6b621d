#include <kerf/object.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <string>
#include <thread>
#include <vector>

#include "api/objects.h"

namespace kerf {
namespace {

TEST(Prepare, KnowsTheBackEndsOfTheBuildByName)
{
    const std::vector<std::string> names = test::back_end_names();
    ASSERT_FALSE(names.empty());
    EXPECT_NE(std::find(names.begin(), names.end(), "linear"), names.end());
    for (const std::string& name : names) {
        EXPECT_EQ(test::cube(name).back_end_name(), name);
        EXPECT_EQ(find_back_end(name.c_str()).name, name);
    }
    EXPECT_STREQ(find_back_end("axe").name, "");
    EXPECT_STREQ(find_back_end(nullptr).name, "");
    EXPECT_STREQ(back_end(back_end_count()).name, "");
}

TEST(Prepare, ChoosesByHowManyCutsAreExpected)
{
    if (std::string(find_back_end("halfedge").name).empty()) GTEST_SKIP() << "this build has one back end";
    const Mesh large = test::shape("asteroid", 300'000), small = test::mesh_of(test::cube_arrays());
    PrepareOptions options;
    options.cuts_expected = 1;
    EXPECT_STREQ(prepare(large, options)->back_end_name(), "linear");
    options.cuts_expected = 1000;
    EXPECT_STREQ(prepare(large, options)->back_end_name(), "halfedge");
    EXPECT_STREQ(prepare(small, options)->back_end_name(), "halfedge");
}

TEST(Prepare, OfABackEndThatIsNotThereIsRefused)
{
    PrepareOptions options;
    options.back_end_name = "axe";
    const Result<Object> object = prepare(test::mesh_of(test::cube_arrays()), options);
    EXPECT_EQ(object.status(), Status::invalid_argument);
    EXPECT_STRNE(object.reason(), "");
    EXPECT_TRUE(object->is_empty());
}

TEST(Prepare, TellsHowFarItIsAndStops)
{
    if (std::string(find_back_end("halfedge").name).empty()) GTEST_SKIP() << "linear has nothing to tell";
    struct Told
    {
        std::vector<double> shares;
        std::size_t most = std::numeric_limits<std::size_t>::max();
    } told;
    PrepareOptions options;
    options.back_end = BackEnd::halfedge;
    options.user = &told;
    options.progress = [](void* user, double share) {
        Told& t = *static_cast<Told*>(user);
        t.shares.push_back(share);
        return t.shares.size() < t.most;
    };
    const Mesh mesh = test::shape("asteroid", 20'000);
    ASSERT_TRUE(prepare(mesh, options));
    EXPECT_GE(told.shares.size(), 4u);
    EXPECT_TRUE(std::is_sorted(told.shares.begin(), told.shares.end()));
    EXPECT_GE(told.shares.front(), 0.0);
    EXPECT_LE(told.shares.back(), 1.0);
    const std::size_t all = told.shares.size();
    for (std::size_t most = 1; most <= all; ++most) {
        told = {{}, most};
        const Result<Object> object = prepare(mesh, options);
        EXPECT_EQ(object.status(), Status::cancelled);
        EXPECT_EQ(told.shares.size(), most);
        EXPECT_TRUE(object->is_empty());
    }
}

class ObjectTest : public testing::TestWithParam<std::string>
{
};
INSTANTIATE_TEST_SUITE_P(All, ObjectTest, testing::ValuesIn(test::back_end_names()),
                         [](const auto& param) { return param.param; });

TEST_P(ObjectTest, GivesTheMeshThatItWasMadeOf)
{
    const Mesh mesh = test::shape("torus");
    const Object object = test::object_of(mesh, GetParam());
    EXPECT_EQ(object.triangle_count(), mesh.triangle_count());
    EXPECT_EQ(object.bounds().lo, mesh.bounds().lo);
    EXPECT_EQ(object.bounds().hi, mesh.bounds().hi);
    const Result<Mesh> back = object.mesh();
    ASSERT_TRUE(back) << back.reason();
    EXPECT_EQ(back->triangle_count(), mesh.triangle_count());
    EXPECT_EQ(back->is_closed(), mesh.is_closed());
    EXPECT_EQ(object.loop_count(), 0u) << "before any cut";
}

TEST_P(ObjectTest, CloneIsAStrangerWithTheSameBytes)
{
    const Object object = test::object_of(test::shape("torus"), GetParam());
    const Result<Object> copy = object.clone();
    ASSERT_TRUE(copy);
    EXPECT_FALSE(object.shares_buffers_with(*copy));
    EXPECT_TRUE(object.shares_buffers_with(object));
    EXPECT_EQ(test::bytes_of(*object.mesh()), test::bytes_of(*copy->mesh()));
    EXPECT_STREQ(copy->back_end_name(), object.back_end_name());
    EXPECT_EQ(copy->mass_properties().is_of_solid, object.mass_properties().is_of_solid);
}

TEST_P(ObjectTest, DetachMakesAStrangerOfARelative)
{
    Cut result = cut(test::cube(GetParam()), Plane::x(0.25).value());
    ASSERT_EQ(result.status, Status::done);
    Object& above = *result.one(Side::positive);
    const std::string before = test::bytes_of(*above.mesh());
    EXPECT_EQ(above.detach(), Status::done);
    EXPECT_FALSE(above.shares_buffers_with(*result.one(Side::negative)));
    EXPECT_EQ(above.compact(), Status::done);
    EXPECT_FALSE(above.is_scattered());
    EXPECT_EQ(test::bytes_of(*above.mesh()), before);
}

TEST_P(ObjectTest, TakesMaterialsAtAnyTime)
{
    Object object = test::cube(GetParam());
    const std::size_t before = object.material_count();
    const std::uint32_t flesh = object.add_material({"flesh", {1, 0.5f, 0.25f, 1}, "flesh.png"});
    EXPECT_EQ(flesh, before);
    EXPECT_STREQ(object.material(flesh).name, "flesh");
    EXPECT_STREQ(object.material(flesh).base_colour_image, "flesh.png");
    EXPECT_EQ(object.material(flesh).base_colour[1], 0.5f);
    CutOptions options;
    options.cap_material = flesh;
    Cut result = cut(std::move(object), Plane::x(0.25).value(), options);
    for (const Side side : {Side::negative, Side::positive}) {
        Object& piece = *result.one(side);
        const std::uint32_t bone = piece.add_material({"bone"});
        EXPECT_STREQ(piece.material(bone).name, "bone");
        EXPECT_STREQ(piece.material(flesh).name, "flesh");
        const Mesh mesh = *piece.mesh();
        for (std::size_t t = 0; t < mesh.arrays().kinds.size(); ++t)
            if (mesh.arrays().kinds[t] == TriangleKind::cap) {
                EXPECT_EQ(mesh.arrays().triangle_materials[t], flesh);
            }
    }
}

TEST_P(ObjectTest, TextsOfItsMaterialsStayWhileRelativesAddTheirs)
{
    Cut result = cut(test::cube(GetParam()), Plane::x(0.25).value());
    Object &a = *result.one(Side::negative), &b = *result.one(Side::positive);
    const Material cap = a.material(a.material_count() - 1);
    const std::string name = cap.name;
    EXPECT_EQ(name, "cap");
    for (int i = 0; i < 100; ++i) b.add_material({("material number " + std::to_string(i)).c_str()});
    EXPECT_EQ(name, cap.name);
}

TEST(Object, ThatIsEmptyAnswersEveryCall)
{
    Object object;
    EXPECT_TRUE(object.is_empty());
    EXPECT_FALSE(object);
    EXPECT_EQ(object.triangle_count(), 0u);
    EXPECT_TRUE(object.bounds().is_empty());
    EXPECT_EQ(object.mass_properties().volume, 0.0);
    EXPECT_EQ(object.mesh().status(), Status::invalid_argument);
    EXPECT_EQ(object.clone().status(), Status::invalid_argument);
    EXPECT_EQ(object.detach(), Status::invalid_argument);
    EXPECT_EQ(object.compact(), Status::invalid_argument);
    EXPECT_EQ(object.loop_count(), 0u);
    EXPECT_TRUE(object.loop(3).points.empty());
    EXPECT_EQ(object.material_count(), 0u);
    EXPECT_EQ(object.add_material({"skin"}), kNone);
    EXPECT_FALSE(object.shares_buffers_with(object));
    EXPECT_FALSE(object.is_scattered());
    EXPECT_STREQ(object.back_end_name(), "");
    DrawView view;
    EXPECT_EQ(object.draw(view), Status::invalid_argument);
    object.mark_uploaded(view);
    EXPECT_EQ(cut(std::move(object), Plane::x(0.0).value()).status, Status::invalid_argument);
}

TEST(Prepare, ChoosesTheBackEndThatPays)
{
    if (find_back_end("halfedge").name[0] == '\0') GTEST_SKIP() << "this build has one back end";
    const auto chosen = [](std::uint64_t triangles, std::uint32_t cuts) {
        PrepareOptions options;
        options.cuts_expected = cuts;
        return std::string(prepare(test::shape("torus", triangles), options)->back_end_name());
    };
    EXPECT_EQ(chosen(1'000, 1000), "halfedge");
    EXPECT_EQ(chosen(1'000, 2), "linear");
    EXPECT_EQ(chosen(60'000, 1000), "halfedge");
    EXPECT_EQ(chosen(60'000, 5), "linear");
    EXPECT_EQ(chosen(60'000, 1), "linear");
    EXPECT_EQ(chosen(60'000, 0), "linear");
}

TEST(Prepare, SaysHowFarItIsFromNoneToAllWithEveryBackEnd)
{
    for (const std::string& name : test::back_end_names()) {
        SCOPED_TRACE(name);
        std::vector<double> shares;
        PrepareOptions options;
        options.back_end_name = name.c_str();
        options.user = &shares;
        options.progress = [](void* user, double share) {
            static_cast<std::vector<double>*>(user)->push_back(share);
            return true;
        };
        ASSERT_TRUE(prepare(test::shape("torus"), options));
        ASSERT_GE(shares.size(), 2u);
        EXPECT_EQ(shares.front(), 0.0);
        EXPECT_EQ(shares.back(), 1.0);
        EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
        options.progress = [](void*, double) { return false; };
        const Result<Object> stopped = prepare(test::shape("torus"), options);
        EXPECT_EQ(stopped.status(), Status::cancelled);
        EXPECT_TRUE(stopped->is_empty());
    }
}

}  // namespace
}  // namespace kerf
