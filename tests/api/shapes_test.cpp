#include <kerf/kerf.h>
#include <kerf/shapes.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "api/objects.h"

namespace kerf {
namespace {

TEST(ShapesOfPrograms, HaveNamesAndAreClosed)
{
    std::set<std::string> names;
    for (std::size_t i = 0; shape_name(i) != nullptr; ++i) {
        SCOPED_TRACE(shape_name(i));
        const Result<Mesh> shape = make_shape(shape_name(i), 500);
        ASSERT_TRUE(shape) << shape.reason();
        EXPECT_TRUE(shape->is_closed());
        names.insert(shape_name(i));
    }
    EXPECT_GT(names.size(), 10u);
    EXPECT_EQ(make_shape("no such shape", 500).status(), Status::invalid_argument);
    EXPECT_EQ(make_shape(nullptr, 500).status(), Status::invalid_argument);
}

TEST(ShapesOfPrograms, GiveTheAsteroidOfASeed)
{
    ShapeOptions other;
    other.seed = 2;
    EXPECT_EQ(test::bytes_of(*make_shape("asteroid", 500)), test::bytes_of(*make_shape("asteroid", 500)));
    EXPECT_NE(test::bytes_of(*make_shape("asteroid", 500)), test::bytes_of(*make_shape("asteroid", 500, other)));
}

TEST(ShapesOfPrograms, HaveOneMaterialIfItIsGiven)
{
    const Material rock{"rock", {0.1f, 0.2f, 0.3f, 1.0f}};
    ShapeOptions options;
    options.material = &rock;
    for (std::size_t i = 0; shape_name(i) != nullptr; ++i) {
        const Mesh shape = *make_shape(shape_name(i), 500, options);
        ASSERT_EQ(shape.material_count(), 1u) << shape_name(i);
        EXPECT_STREQ(shape.material(0).name, "rock");
        EXPECT_EQ(shape.material(0).base_colour[1], 0.2f);
    }
}

TEST(ShapesOfPrograms, SayHowFarTheyAreAndStopIfTheyAreToldTo)
{
    std::vector<double> shares;
    ShapeOptions options;
    options.user = &shares;
    options.progress = [](void* user, double share) {
        static_cast<std::vector<double>*>(user)->push_back(share);
        return true;
    };
    ASSERT_TRUE(make_shape("torus", 500, options));
    ASSERT_GE(shares.size(), 3u);
    EXPECT_EQ(shares.front(), 0.0);
    EXPECT_EQ(shares.back(), 1.0);
    EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
    for (double limit : {0.0, 0.3, 0.9}) {
        options.user = &limit;
        options.progress = [](void* user, double share) { return share <= *static_cast<double*>(user) && share > 0.0; };
        const Result<Mesh> stopped = make_shape("torus", 500, options);
        EXPECT_EQ(stopped.status(), Status::cancelled);
        EXPECT_TRUE(stopped->is_empty());
        EXPECT_STRNE(stopped.reason(), "");
    }
}

TEST(HardSections, AreCutThroughByTheirPlane)
{
    std::size_t names = 0;
    for (std::size_t i = 0; hard_section_name(i) != nullptr; ++i, ++names) {
        SCOPED_TRACE(hard_section_name(i));
        const Result<HardSection> hard = make_hard_section(hard_section_name(i), 40);
        ASSERT_TRUE(hard) << hard.reason();
        const Result<Mesh> mesh = Mesh::make(hard->input());
        ASSERT_TRUE(mesh) << mesh.reason();
        EXPECT_TRUE(mesh->is_closed());
        const Cut result = cut(test::object_of(*mesh, "linear"), hard->plane());
        EXPECT_EQ(result.status, Status::done);
    }
    EXPECT_GT(names, 5u);
    EXPECT_EQ(make_hard_section("easy", 40).status(), Status::invalid_argument);
    EXPECT_EQ(HardSection().plane(), Plane::z(0.0).value());
    EXPECT_FALSE(Mesh::make(HardSection().input()));
}

TEST(HardSections, OfAnySizeAreMade)
{
    for (std::size_t i = 0; hard_section_name(i) != nullptr; ++i)
        for (const std::uint32_t size : {0u, 1u, 2u, 7u}) {
            const Result<HardSection> hard = make_hard_section(hard_section_name(i), size);
            ASSERT_TRUE(hard) << hard_section_name(i) << " " << size << ": " << hard.reason();
            EXPECT_TRUE(Mesh::make(hard->input())) << hard_section_name(i) << " " << size;
        }
}

}  // namespace
}  // namespace kerf
