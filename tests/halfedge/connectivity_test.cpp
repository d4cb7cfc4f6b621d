// After every cut the half-edge mesh, the tree and the buffers agree with one another.

#include <gtest/gtest.h>

#include <filesystem>

#include "common/io/mesh_file.h"
#include "common/shapes/shapes.h"
#include "halfedge/consistency.h"
#include "halfedge/halfedge.h"
#include "support/brief.h"
#include "support/fixtures.h"
#include "support/referee.h"

namespace kerf::core::halfedge {
namespace {

using Fragments = std::vector<std::unique_ptr<Cuttable>>;

std::unique_ptr<Cuttable> prepared(const IndexedMesh& mesh)
{
    return std::move(make_back_end()->prepare(mesh).object);
}

void expect_consistent(const CutResult& result)
{
    for (const Fragments* side : {&result.negative, &result.positive})
        for (const auto& fragment : *side) EXPECT_EQ(faults(*fragment), "");
}

TEST(Connectivity, IsConsistentAfterPreparingEveryShape)
{
    for (const auto* shapes : {&test::closed_shapes(), &test::open_shapes()})
        for (const auto& shape : *shapes) EXPECT_EQ(faults(*prepared(shape.mesh)), "") << shape.name;
}

TEST(Connectivity, IsConsistentAfterCutsOfEveryShapeByEveryKindOfPlane)
{
    for (const auto* shapes : {&test::closed_shapes(), &test::open_shapes()})
        for (const auto& shape : *shapes) {
            const auto object = prepared(shape.mesh);
            for (const auto& plane : test::planes_for(shape.mesh, 5, 7))
                for (const bool split : {false, true})
                    for (const bool caps : {false, true}) {
                        SCOPED_TRACE(shape.name + ", plane " + plane.name + (split ? ", in pieces" : "") +
                                     (caps ? "" : ", without caps"));
                        CutOptions options;
                        options.split_components = split;
                        options.build_caps = caps;
                        expect_consistent(cut(object->clone(), plane.plane, options));
                    }
        }
}

TEST(Connectivity, AFragmentSurvivesTheCutsOfItsRelatives)
{
    CutResult first = cut(prepared(test::closed_shape("torus")), *Plane::through({0, 0, 0.01}, {0.3, 0.1, 1}));
    ASSERT_EQ(first.status, Status::done);
    const auto before = referee::bytes_of(first.positive[0]->to_indexed_mesh());
    {
        const CutResult second = cut(std::move(first.negative[0]), *Plane::through({0, 0, 0}, {1, 0, 0}));
        ASSERT_EQ(second.status, Status::done);
        EXPECT_EQ(referee::bytes_of(first.positive[0]->to_indexed_mesh()), before);
    }
    EXPECT_EQ(faults(*first.positive[0]), "");
    const CutResult third = cut(std::move(first.positive[0]), *Plane::through({0, 0, 0}, {1, 0, 0}));
    EXPECT_EQ(third.status, Status::done);
    expect_consistent(third);
}

/// Cuts the largest fragment through its centre of mass again and again.
void expect_a_good_chain(const IndexedMesh& mesh, int cuts)
{
    auto object = prepared(mesh);
    const double whole = object->mass_properties().volume;
    Fragments fragments;
    fragments.push_back(std::move(object));
    test::Random random(3);
    for (int i = 0; i < cuts; ++i) {
        SCOPED_TRACE("cut " + std::to_string(i));
        const auto largest = std::max_element(fragments.begin(), fragments.end(), [](const auto& a, const auto& b) {
            return a->triangle_count() < b->triangle_count();
        });
        const Plane plane = *Plane::through((*largest)->mass_properties().centre, random.direction());
        CutOptions options;
        options.split_components = i % 2 == 1;
        CutResult result = cut(std::move(*largest), plane, options);
        fragments.erase(largest);
        if (result.object) {
            fragments.push_back(std::move(result.object));
            continue;
        }
        ASSERT_EQ(result.status, Status::done);
        expect_consistent(result);
        for (Fragments* side : {&result.negative, &result.positive})
            for (auto& fragment : *side) {
                ASSERT_EQ(referee::open_edges(fragment->to_indexed_mesh()), 0u);
                fragments.push_back(std::move(fragment));
            }
        double sum = 0;
        for (const auto& fragment : fragments) sum += fragment->mass_properties().volume;
        ASSERT_NEAR(sum, whole, 1e-6 * whole);
    }
}

// Every cut is followed by checks of everything.
constexpr int kCuts = test::kBrief ? 50 : 1000;

TEST(Connectivity, SurvivesAThousandCutsInAChain)
{
    expect_a_good_chain(test::repaired(shapes::asteroid(100'000, 1)), kCuts);
}

TEST(Connectivity, SurvivesAChainOnAMeshOfManyTunnels)
{
    const std::filesystem::path file = std::filesystem::path(KERF_SHARED_MESHES_DIR) / "cheese.off";
    if (!std::filesystem::exists(file)) GTEST_SKIP() << "no real meshes here";
    expect_a_good_chain(test::repaired(io::read_soup(file)), kCuts / 4);
}

TEST(Connectivity, IsConsistentWhereCapsRunThroughOneAnother)
{
    // The planes turn about nearly one line, along which caps of thin triangles pile up. Rounding to float makes them
    // run through one another, so that the next section has several points in one place, time and again.
    CutResult half = cut(prepared(test::repaired(shapes::asteroid(8000, 1))), *Plane::through({0, 0, 0}, {0, 0, 1}));
    std::unique_ptr<Cuttable> object = std::move(half.negative[0]);
    for (int i = 0; object->triangle_count() < 20'000; ++i) {
        SCOPED_TRACE("cut " + std::to_string(i));
        CutResult result =
            cut(std::move(object), *Plane::through({0.0, 0.0, -0.05 - 0.01 * i}, {0.1 * i, 1.0 - 0.05 * i, -1.0}));
        ASSERT_EQ(result.status, Status::done);
        expect_consistent(result);
        object = std::move(result.negative[0]);
    }
}

TEST(Connectivity, ACloneIsConsistentAndIndependent)
{
    CutResult result = cut(prepared(test::closed_shape("sphere_in_sphere")), *Plane::through({0, 0, 0.1}, {0, 0, 1}));
    ASSERT_EQ(result.status, Status::done);
    const auto copy = result.positive[0]->clone();
    EXPECT_EQ(referee::bytes_of(copy->to_indexed_mesh()), referee::bytes_of(result.positive[0]->to_indexed_mesh()));
    const auto before = referee::bytes_of(copy->to_indexed_mesh());
    expect_consistent(cut(std::move(result.positive[0]), *Plane::through({0, 0, 0}, {1, 0.1, 0})));
    EXPECT_EQ(referee::bytes_of(copy->to_indexed_mesh()), before);
    EXPECT_EQ(faults(*copy), "");
}

}  // namespace
}  // namespace kerf::core::halfedge
