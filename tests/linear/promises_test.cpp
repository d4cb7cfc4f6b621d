// What comes out of a cut keeps the promises of IndexedMesh, wherever the plane runs: through vertices, along edges, in
// faces, and through what was cut before.

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "common/repair/proven_mesh.h"
#include "common/shapes/shapes.h"
#include "linear/linear.h"
#include "support/fixtures.h"
#include "support/referee.h"

namespace kerf::core::linear {
namespace {

void expect_promises(const std::vector<std::unique_ptr<Cuttable>>& fragments)
{
    for (const auto& fragment : fragments) EXPECT_EQ(prove(fragment->to_indexed_mesh()).error, "");
}

/// Cuts twice, by all pairs of a few planes.
void expect_promises_kept(const IndexedMesh& mesh, bool in_pieces, bool with_caps)
{
    const auto object = make_back_end()->prepare(mesh).object;
    ASSERT_TRUE(object);
    const CutOptions options{.build_caps = with_caps, .split_components = in_pieces};
    for (const test::NamedPlane& first : test::planes_for(mesh, 2, 31)) {
        CutResult result = cut(object->clone(), first.plane, options);
        expect_promises(result.positive);
        expect_promises(result.negative);
        for (auto* side : {&result.positive, &result.negative})
            for (const auto& fragment : *side)
                for (const test::NamedPlane& second : test::planes_for(fragment->to_indexed_mesh(), 1, 7)) {
                    SCOPED_TRACE(first.name + ", then " + second.name);
                    const CutResult again = cut(fragment->clone(), second.plane, options);
                    expect_promises(again.positive);
                    expect_promises(again.negative);
                }
    }
}

TEST(Promises, AreKeptByCutsOfClosedMeshes)
{
    for (const test::NamedMesh& shape : test::closed_shapes())
        for (const bool in_pieces : {false, true}) {
            SCOPED_TRACE(shape.name + (in_pieces ? ", in pieces" : ""));
            expect_promises_kept(shape.mesh, in_pieces, true);
        }
}

TEST(Promises, AreKeptByCutsOfOpenMeshes)
{
    for (const test::NamedMesh& shape : test::open_shapes())
        for (const bool in_pieces : {false, true}) {
            SCOPED_TRACE(shape.name + (in_pieces ? ", in pieces" : ""));
            expect_promises_kept(shape.mesh, in_pieces, true);
        }
}

TEST(Promises, AreKeptWithoutCaps)
{
    for (const test::NamedMesh& shape : test::closed_shapes()) {
        SCOPED_TRACE(shape.name);
        expect_promises_kept(shape.mesh, false, false);
    }
}

TEST(RightCaps, HaveTheAreaOfTheirSectionOrSayThatTheyExceedIt)
{
    for (const std::string& name : shapes::names()) {
        const IndexedMesh mesh = test::repaired(*shapes::make(name, 600, 1));
        const auto object = make_back_end()->prepare(mesh).object;
        for (const test::NamedPlane& plane : test::planes_for(mesh, 3, 5)) {
            SCOPED_TRACE(name + ", plane " + plane.name);
            const CutResult result = cut(object->clone(), plane.plane);
            if (result.status != Status::done || result.caps_exceed_section) continue;
            for (const auto* side : {&result.positive, &result.negative}) {
                double twice = 0.0;
                for (const auto& fragment : *side) {
                    const IndexedMesh part = fragment->to_indexed_mesh();
                    for (const TriangleGroup& group : part.groups)
                        for (std::uint32_t t = group.first; t < group.first + group.count; ++t) {
                            if (group.kind != TriangleKind::cap) continue;
                            const auto place = [&](std::size_t i) {
                                return glm::dvec3(part.vertices[part.triangles[t][i]].position);
                            };
                            twice += std::abs(
                                glm::dot(plane.plane.normal, glm::cross(place(1) - place(0), place(2) - place(0))));
                        }
                }
                EXPECT_NEAR(0.5 * twice, result.section_area, 2e-6 * (1e-3 + result.section_area));
            }
        }
    }
}

}  // namespace
}  // namespace kerf::core::linear
