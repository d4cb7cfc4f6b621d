#include <kerf/dice.h>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <random>

#include "api/objects.h"

namespace kerf {
namespace {

class DiceTest : public testing::TestWithParam<std::string>
{
};
INSTANTIATE_TEST_SUITE_P(All, DiceTest, testing::ValuesIn(test::back_end_names()),
                         [](const auto& param) { return param.param; });

/// Planes across all axes at the same heights.
struct Grid
{
    explicit Grid(std::vector<double> at)
        : heights(std::move(at)),
          planes{{Normal(1, 0, 0), heights}, {Normal(0, 1, 0), heights}, {Normal(0, 0, 1), heights}}
    {
    }
    std::vector<double> heights;
    std::vector<DicePlanes> planes;
};

double volume_of(const Object& object)
{
    return object.mass_properties().volume;
}

TEST_P(DiceTest, ACubeFallsIntoCells)
{
    const Grid grid({0.5, -0.25});  // in any order
    Dice dice = kerf::dice(test::cube(GetParam()), grid.planes);
    EXPECT_EQ(dice.status(), Status::done);
    EXPECT_STREQ(dice.reason(), "");
    ASSERT_EQ(dice.count(), 27u);
    EXPECT_EQ(dice.empty_cells(), 0u);
    const std::vector<double> borders{-1.0, -0.25, 0.5, 1.0};
    for (std::uint32_t i = 0; i < 27; ++i) {
        const auto cell = dice.cell(i);
        ASSERT_EQ(cell.size(), 3u);
        EXPECT_EQ(9 * cell[0] + 3 * cell[1] + cell[2], i) << "in the order of their cells";
        const Object& piece = *dice.piece(i);
        const Box box = piece.bounds();
        EXPECT_EQ(box.lo, Vec3f(float(borders[cell[0]]), float(borders[cell[1]]), float(borders[cell[2]])));
        EXPECT_EQ(box.hi, Vec3f(float(borders[cell[0] + 1]), float(borders[cell[1] + 1]), float(borders[cell[2] + 1])));
        EXPECT_TRUE(piece.mass_properties().is_of_solid);
    }
    EXPECT_EQ(dice.piece(27), nullptr);
    EXPECT_TRUE(dice.cell(27).empty());
    EXPECT_EQ(dice.statistics().triangles, 12u);
    EXPECT_GT(dice.statistics().crossing_triangles, 0u);
}

TEST_P(DiceTest, VolumesSumUpWithAndWithoutAGap)
{
    for (const char* name : {"asteroid", "menger_sponge", "torus", "sphere_in_sphere", "two_legs"}) {
        SCOPED_TRACE(name);
        const Object whole = test::object_of(test::shape(name, 2000), GetParam());
        const Box box = whole.bounds();
        std::vector<double> heights[3];
        for (int i = 1; i < 4; ++i) {
            heights[0].push_back(box.lo.x + (box.hi.x - box.lo.x) * float(i) / 4.0f + 0.003f);
            heights[1].push_back(box.lo.y + (box.hi.y - box.lo.y) * float(i) / 4.0f + 0.003f);
            heights[2].push_back(box.lo.z + (box.hi.z - box.lo.z) * float(i) / 4.0f + 0.003f);
        }
        const std::vector<DicePlanes> planes{
            {Normal(1, 0, 0), heights[0]}, {Normal(0, 1, 0), heights[1]}, {Normal(0, 0, 1), heights[2]}};
        DiceOptions options;
        double volumes[2] = {0.0, 0.0};
        for (const bool with_gap : {false, true}) {
            options.cut.gap = with_gap ? 0.02 : 0.0;
            Dice dice = kerf::dice(*whole.clone(), planes, options);
            ASSERT_EQ(dice.status(), Status::done);
            for (std::size_t i = 0; i < dice.count(); ++i) {
                EXPECT_TRUE(dice.piece(i)->mass_properties().is_of_solid);
                volumes[with_gap] += volume_of(*dice.piece(i));
            }
            EXPECT_EQ(dice.count() + dice.empty_cells(), 64u) << "a piece for each cell";
        }
        EXPECT_NEAR(volumes[0], volume_of(whole), 1e-6 * volume_of(whole));
        // What the blades take are the odd layers of cuts along both sides of each.
        std::vector<double> sides[3];
        for (int axis = 0; axis < 3; ++axis)
            for (const double height : heights[axis])
                for (const double side : {-0.01, 0.01}) sides[axis].push_back(height + side);
        Dice fine = kerf::dice(
            *whole.clone(), std::vector<DicePlanes>{
                                {Normal(1, 0, 0), sides[0]}, {Normal(0, 1, 0), sides[1]}, {Normal(0, 0, 1), sides[2]}});
        double taken = 0.0;
        for (std::size_t i = 0; i < fine.count(); ++i)
            if (std::ranges::any_of(fine.cell(i), [](std::uint32_t layer) { return layer % 2 == 1; }))
                taken += volume_of(*fine.piece(i));
        EXPECT_GT(taken, 0.0);
        EXPECT_NEAR(volumes[1] + taken, volume_of(whole), 1e-6 * volume_of(whole));
    }
}

TEST_P(DiceTest, PiecesAreThoseOfCutsOneAfterTheOther)
{
    const Mesh mesh = test::shape("torus", 1500);
    const std::vector<double> heights{-0.3, 0.0, 0.31};
    const std::vector<DicePlanes> planes{{Normal(1, 2, 3), heights}};
    Dice dice = kerf::dice(test::object_of(mesh, GetParam()), planes);
    std::map<std::uint32_t, double> volumes;
    Object rest = test::object_of(mesh, GetParam());
    for (std::uint32_t layer = 0; layer < 3; ++layer) {
        Cut result = cut(std::move(rest), *Plane::at(Point(0, 0, 0), Normal(1, 2, 3))->moved(heights[layer]));
        ASSERT_EQ(result.status, Status::done);
        volumes[layer] = volume_of(*result.one(Side::negative));
        rest = std::move(*result.one(Side::positive));
    }
    volumes[3] = volume_of(rest);
    ASSERT_EQ(dice.count(), 4u);
    for (std::uint32_t i = 0; i < 4; ++i) {
        EXPECT_EQ(dice.cell(i)[0], i);
        EXPECT_NEAR(volume_of(*dice.piece(i)), volumes[i], 1e-6 * volumes[i]);
    }
}

TEST_P(DiceTest, CellsWithNothingInThemAreLeftOutAndCounted)
{
    const Grid grid({-5.0, 0.0, 5.0});
    Dice dice = kerf::dice(test::cube(GetParam()), grid.planes);
    EXPECT_EQ(dice.count(), 8u);
    EXPECT_EQ(dice.empty_cells(), 64u - 8u);
    for (std::size_t i = 0; i < dice.count(); ++i)
        for (const std::uint32_t layer : dice.cell(i)) EXPECT_TRUE(layer == 1 || layer == 2);
    // A blade that is wider than the cube takes all of it.
    DiceOptions options;
    options.cut.gap = 50.0;
    Dice nothing = kerf::dice(test::cube(GetParam()), grid.planes, options);
    EXPECT_EQ(nothing.status(), Status::done);
    EXPECT_EQ(nothing.count(), 0u);
    EXPECT_EQ(nothing.empty_cells(), 64u);
    // Without planes the object is the one piece.
    Dice whole = kerf::dice(test::cube(GetParam()), {});
    ASSERT_EQ(whole.count(), 1u);
    EXPECT_EQ(whole.piece(0)->triangle_count(), 12u);
}

TEST_P(DiceTest, ComponentsArePiecesOfOneCell)
{
    DiceOptions options;
    options.cut.components = true;
    Object legs = test::object_of(test::shape("two_legs", 500), GetParam());
    const Box box = legs.bounds();
    const std::vector<double> through_legs{box.lo.z + 0.2 * (box.hi.z - box.lo.z)};
    Dice dice = kerf::dice(std::move(legs), std::vector<DicePlanes>{{Normal(0, 0, 1), through_legs}}, options);
    ASSERT_EQ(dice.count(), 3u);
    EXPECT_EQ(dice.cell(0)[0], 0u);
    EXPECT_EQ(dice.cell(1)[0], 0u);
    EXPECT_EQ(dice.cell(2)[0], 1u);
    EXPECT_EQ(dice.empty_cells(), 0u);
}

TEST_P(DiceTest, SaysHowFarItIsAndStopsIfItIsTold)
{
    struct Told
    {
        std::vector<double> shares;
        std::size_t most = 1000;
    } told;
    DiceOptions options;
    options.user = &told;
    options.progress = [](void* user, double share) {
        Told& to = *static_cast<Told*>(user);
        to.shares.push_back(share);
        return to.shares.size() < to.most;
    };
    const Grid grid({-0.2, 0.3});
    EXPECT_EQ(kerf::dice(test::cube(GetParam()), grid.planes, options).status(), Status::done);
    EXPECT_EQ(told.shares.front(), 0.0);
    EXPECT_EQ(told.shares.back(), 1.0);
    EXPECT_TRUE(std::ranges::is_sorted(told.shares));
    for (const std::size_t most : {1u, 2u, 7u}) {
        told = {{}, most};
        Dice dice = kerf::dice(test::cube(GetParam()), grid.planes, options);
        EXPECT_EQ(dice.status(), Status::cancelled);
        EXPECT_STRNE(dice.reason(), "");
        EXPECT_EQ(dice.count(), 0u);
        EXPECT_EQ(told.shares.size(), most);
    }
}

TEST_P(DiceTest, WhatMeansNothingLeavesTheObjectAsItWas)
{
    const std::vector<double> wrong{std::numeric_limits<double>::infinity()}, right{0.0};
    DiceOptions negative_gap;
    negative_gap.cut.gap = -1.0;
    const auto refuse = [&](const DicePlanes& planes, const DiceOptions& options) {
        Object cube = test::cube(GetParam());
        const Dice dice = kerf::dice(std::move(cube), {&planes, 1}, options);
        EXPECT_EQ(dice.status(), Status::invalid_argument);
        EXPECT_STRNE(dice.reason(), "");
        EXPECT_EQ(cube.triangle_count(), 12u);  // NOLINT(bugprone-use-after-move): that is what is tested
    };
    refuse({Normal(1, 0, 0), wrong}, {});
    refuse({Normal(0, 0, 0), right}, {});
    refuse({Normal(1, 0, 0), right}, negative_gap);
    EXPECT_EQ(kerf::dice(Object(), {}).status(), Status::invalid_argument);
}

TEST(Dice, ExpectsTheLogarithmOfItsLayersOfCuts)
{
    const std::vector<double> three{1, 2, 3}, one{1};
    EXPECT_EQ(cuts_expected({}), 0u);
    EXPECT_EQ(cuts_expected(std::vector<DicePlanes>{{Normal(1, 0, 0), three}, {Normal(0, 1, 0), one}}), 3u);
}

}  // namespace
}  // namespace kerf
