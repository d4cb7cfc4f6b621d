// Pieces are what a flood fill finds, however the search found them.

#include <gtest/gtest.h>

#include "common/shapes/shapes.h"
#include "halfedge/fragment.h"
#include "halfedge/halfedge.h"
#include "support/check_universe.h"
#include "support/fixtures.h"
#include "support/referee.h"

namespace kerf::core::halfedge {
namespace {

std::size_t components(const std::vector<std::unique_ptr<Cuttable>>& side)
{
    std::size_t count = 0;
    for (const auto& fragment : side) count += referee::edge_components(fragment->to_indexed_mesh());
    return count;
}

TEST(Components, AreThoseOfAFloodFill)
{
    CutOptions apart;
    apart.split_components = true;
    for (const auto& shape : test::closed_shapes()) {
        const auto object = std::move(make_back_end()->prepare(shape.mesh).object);
        for (const auto& plane : test::planes_for(shape.mesh, 5, 13)) {
            SCOPED_TRACE(shape.name + ", plane " + plane.name);
            const CutResult whole = cut(object->clone(), plane.plane),
                            pieces = cut(object->clone(), plane.plane, apart);
            ASSERT_EQ(whole.status, pieces.status);
            EXPECT_EQ(components(whole.positive), components(pieces.positive));
            EXPECT_EQ(components(whole.negative), components(pieces.negative));
            for (const auto* side : {&pieces.positive, &pieces.negative})
                for (const auto& piece : *side) {
                    const auto& fragment = dynamic_cast<const Fragment&>(*piece);
                    EXPECT_EQ(check_universe(fragment.universe(), fragment.shells()), "");
                    // What is said to be connected is.
                    EXPECT_EQ(referee::edge_components(piece->to_indexed_mesh()), fragment.shells().size());
                }
        }
    }
}

TEST(Components, OfAShellInAnUnknownStateAreFoundByALaterCut)
{
    // The comb's teeth come off but stay one fragment; a cut along them takes that apart.
    const IndexedMesh& mesh = test::closed_shape("comb");
    const double y = double(mesh.bounds().hi.y) - 0.1 * double(mesh.bounds().hi.y - mesh.bounds().lo.y);
    CutResult tips = cut(std::move(make_back_end()->prepare(mesh).object), *Plane::through({0, y, 0}, {0, 1, 0}));
    ASSERT_EQ(tips.status, Status::done);
    ASSERT_EQ(tips.positive.size(), 1u);
    const std::size_t teeth = components(tips.positive);
    ASSERT_GT(teeth, 2u);
    CutOptions apart;
    apart.split_components = true;
    const Box box = tips.positive[0]->bounds();
    const CutResult result = cut(std::move(tips.positive[0]), *Plane::through(box.centre(), {0, 0, 1}), apart);
    ASSERT_EQ(result.status, Status::done);
    EXPECT_EQ(result.positive.size(), teeth);
    EXPECT_EQ(result.negative.size(), teeth);
}

TEST(Components, CostWhatTheSmallerPartsCost)
{
    // A ring cut off at its top: two loops, and small parts on one side.
    const IndexedMesh mesh = test::repaired(shapes::torus(1.0f, 0.3f, 600, 200));
    const auto object = std::move(make_back_end()->prepare(mesh).object);
    CutOptions apart;
    apart.split_components = true;
    const CutResult result = cut(object->clone(), *Plane::through({0, 0.999, 0.0}, {0.001, 1, 0.0}), apart);
    ASSERT_EQ(result.status, Status::done);
    const CutStatistics& s = result.statistics;
    EXPECT_LE(s.triangles_touched, s.triangles / 4);
}

}  // namespace
}  // namespace kerf::core::halfedge
