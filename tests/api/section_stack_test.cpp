#include <kerf/drawing.h>
#include <kerf/section.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "api/objects.h"

namespace kerf {
namespace {

class SectionStackTest : public testing::TestWithParam<std::string>
{
protected:
    Object object() const { return test::object_of(test::shape("menger_sponge", 3000), GetParam()); }
};
INSTANTIATE_TEST_SUITE_P(All, SectionStackTest, testing::ValuesIn(test::back_end_names()),
                         [](const auto& param) { return param.param; });

const std::vector<double> kHeights{0.3, -0.2, 0.0, 9.0, 0.1, 0.25, -0.41, 0.2, 0.21, 0.22, 0.3};

void expect_equal(const Section& found, const Section& expected)
{
    EXPECT_EQ(found.status, expected.status);
    EXPECT_EQ(found.side_of_object, expected.side_of_object);
    EXPECT_EQ(found.area, expected.area);
    EXPECT_EQ(found.length, expected.length);
    ASSERT_EQ(found.path_count(), expected.path_count());
    for (std::size_t i = 0; i < found.path_count(); ++i) {
        EXPECT_TRUE(std::ranges::equal(found.path(i).points, expected.path(i).points));
        EXPECT_EQ(found.path(i).parent, expected.path(i).parent);
    }
    EXPECT_TRUE(std::ranges::equal(found.triangles(), expected.triangles()));
}

TEST_P(SectionStackTest, HasTheSectionOfEachHeightInTheirOrder)
{
    const Object sponge = object();
    StackOptions options;
    options.section.fill = true;
    const Normal normal(1, 2, 3);
    const Plane level = *Plane::at(Point(0, 0, 0), normal);
    for (const std::uint32_t threads : {1u, 2u, 0u, 50u}) {
        options.threads = threads;
        const SectionStack stack = sections(sponge, normal, kHeights, options);
        EXPECT_EQ(stack.status(), Status::done);
        EXPECT_STREQ(stack.reason(), "");
        ASSERT_EQ(stack.all().size(), kHeights.size());
        for (std::size_t i = 0; i < kHeights.size(); ++i) {
            EXPECT_EQ(stack.all()[i].frame.height, kHeights[i]);
            expect_equal(stack.all()[i], section(sponge, *level.moved(kHeights[i]), options.section));
        }
    }
}

TEST_P(SectionStackTest, OfNoHeightsHasNone)
{
    const SectionStack none = sections(object(), Normal(0, 0, 1), {}), fresh;
    EXPECT_EQ(none.status(), Status::done);
    EXPECT_TRUE(none.all().empty());
    EXPECT_TRUE(fresh.all().empty());
}

TEST_P(SectionStackTest, ThatWasUsedBeforeHoldsNothingOfIt)
{
    SectionStack stack = sections(object(), Normal(0, 0, 1), kHeights);
    const std::vector<double> two{0.1, 0.2};
    EXPECT_EQ(sections(test::cube(GetParam()), Normal(0, 0, 1), two, stack), Status::done);
    ASSERT_EQ(stack.all().size(), 2u);
    EXPECT_NEAR(stack.all()[0].area, 4.0, 1e-9);
    SectionStack taken = std::move(stack);
    EXPECT_EQ(taken.all().size(), 2u);
    EXPECT_TRUE(stack.all().empty());  // NOLINT(bugprone-use-after-move): that is what is tested
}

TEST_P(SectionStackTest, SaysHowFarItIsAndStopsIfItIsTold)
{
    struct Told
    {
        std::vector<double> shares;
        std::size_t most = 1000;
    } told;
    StackOptions options;
    options.user = &told;
    options.progress = [](void* user, double share) {
        Told& to = *static_cast<Told*>(user);
        to.shares.push_back(share);
        return to.shares.size() < to.most;
    };
    SectionStack stack = sections(object(), Normal(0, 0, 1), kHeights, options);
    EXPECT_EQ(stack.status(), Status::done);
    EXPECT_EQ(told.shares.front(), 0.0);
    EXPECT_EQ(told.shares.back(), 1.0);
    EXPECT_TRUE(std::ranges::is_sorted(told.shares));
    for (const std::uint32_t threads : {1u, 2u})
        for (const std::size_t most : {1u, 2u, 5u}) {
            if (threads > 1 && most > 2) continue;  // the other thread may have done all before it is asked so often
            told = {{}, most};
            options.threads = threads;
            EXPECT_EQ(sections(object(), Normal(0, 0, 1), kHeights, stack, options), Status::cancelled);
            EXPECT_STRNE(stack.reason(), "");
            EXPECT_TRUE(stack.all().empty());
            EXPECT_EQ(told.shares.size(), most) << "it goes on after it was told to stop";
        }
}

TEST_P(SectionStackTest, OfWhatMeansNothingSaysSo)
{
    const double infinity = std::numeric_limits<double>::infinity();
    const std::vector<double> wrong{0.0, infinity};
    EXPECT_EQ(sections(object(), Normal(0, 0, 1), wrong).status(), Status::invalid_argument);
    EXPECT_EQ(sections(object(), Normal(0, 0, 0), kHeights).status(), Status::invalid_argument);
    const SectionStack stack = sections(Object(), Normal(0, 0, 1), kHeights);
    EXPECT_EQ(stack.status(), Status::invalid_argument);
    EXPECT_STRNE(stack.reason(), "");
    EXPECT_TRUE(stack.all().empty());
}

TEST(QuickerForSections, PreparesIfThePlanesCrossMoreTrianglesThanThereAre)
{
    if (std::string(find_back_end("halfedge").name).empty()) GTEST_SKIP() << "this build has one back end";
    const Mesh mesh = test::shape("asteroid", 10'000);
    const auto choice = [&](std::size_t count, double first, Normal normal = Normal(1, 2, 3)) {
        std::vector<double> heights;
        for (std::size_t i = 0; i < count; ++i) heights.push_back(first - double(i) / double(count));
        return quicker_for_sections(mesh, normal, heights);
    };
    EXPECT_EQ(choice(1, 0.5), BackEnd::linear);
    EXPECT_EQ(choice(10, 0.5), BackEnd::linear);
    EXPECT_EQ(choice(1000, 0.5), BackEnd::halfedge);
    EXPECT_EQ(choice(1000, 0.5, Normal(-1, -2, -3)), BackEnd::halfedge) << "in any order and direction";
    EXPECT_EQ(choice(1000, 100.0), BackEnd::linear) << "planes that miss cost nothing";
}

TEST(QuickerForSections, SaysLinearToWhatMeansNothing)
{
    const Mesh mesh = test::shape("asteroid", 1000);
    const std::vector<double> many(1000, 0.0), wrong(1000, std::numeric_limits<double>::quiet_NaN());
    EXPECT_EQ(quicker_for_sections(mesh, Normal(0, 0, 0), many), BackEnd::linear);
    EXPECT_EQ(quicker_for_sections(mesh, Normal(0, 0, 1), wrong), BackEnd::linear);
    EXPECT_EQ(quicker_for_sections(mesh, Normal(0, 0, 1), {}), BackEnd::linear);
    EXPECT_EQ(quicker_for_sections(Mesh(), Normal(0, 0, 1), many), BackEnd::linear);
}

TEST_P(SectionStackTest, IsDrawnWithALayerForEach)
{
    const SectionStack stack = sections(object(), Normal(0, 0, 1), kHeights);
    const Result<FileBytes> svg = drawing_bytes(stack.all(), "svg");
    ASSERT_TRUE(svg) << svg.reason();
    const std::string_view text(reinterpret_cast<const char*>(svg->bytes().data()), svg->bytes().size());
    EXPECT_NE(text.find("id=\"layer-11\""), std::string_view::npos);
    EXPECT_NE(text.find("data-height=\"-0.41\""), std::string_view::npos);
}

TEST(Drawing, OfNothingOrInNoFormatIsRefused)
{
    const Object cube = test::cube("linear");
    const Section missed = section(cube, Plane::x(9.0).value()), square = section(cube, Plane::x(0.0).value());
    EXPECT_EQ(drawing_bytes({&missed, 1}, "svg").status(), Status::invalid_argument);
    EXPECT_EQ(drawing_bytes({}, "svg").status(), Status::invalid_argument);
    EXPECT_EQ(drawing_bytes({&square, 1}, nullptr).status(), Status::invalid_argument);
    EXPECT_EQ(drawing_bytes({&square, 1}, "png").status(), Status::unusable_file);
    EXPECT_EQ(write_drawing({&square, 1}, nullptr).status(), Status::invalid_argument);
    EXPECT_EQ(write_drawing({&square, 1}, "/no/such/folder/a.svg").status(), Status::unusable_file);
    EXPECT_TRUE(drawing_bytes({&square, 1}, "DXF"));
}

TEST(Drawing, HasUnits)
{
    EXPECT_STREQ(text(LengthUnit::inch), "in");
    EXPECT_EQ(millimetres(LengthUnit::inch), 25.4);
    EXPECT_STREQ(text(static_cast<LengthUnit>(99)), "mm");
    EXPECT_EQ(millimetres(static_cast<LengthUnit>(99)), 1.0);
}

}  // namespace
}  // namespace kerf
