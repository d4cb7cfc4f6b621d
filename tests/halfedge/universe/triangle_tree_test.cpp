// What the tree says about a subtree is what a loop over its triangles says.

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "common/proxy/collision_proxy.h"
#include "common/shapes/shapes.h"
#include "halfedge/fragment.h"
#include "halfedge/halfedge.h"
#include "support/fixtures.h"

namespace kerf::core::halfedge {
namespace {

TEST(Support, HasABoxWithoutMinusZero)
{
    Support support = Support::none();
    for (const float zero : {0.0f, -0.0f}) support.add(glm::vec3(zero));
    const Box box = support.box();
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_FALSE(std::signbit(box.lo[axis])) << axis;
        EXPECT_FALSE(std::signbit(box.hi[axis])) << axis;
    }
}

TEST(TriangleTree, BoundsMassAndProxyAreThoseOfTheMesh)
{
    for (const auto& shape : test::closed_shapes()) {
        const auto object = std::move(make_back_end()->prepare(shape.mesh).object);
        for (const auto& plane : test::planes_for(shape.mesh, 2, 5)) {
            const CutResult result = cut(object->clone(), plane.plane);
            for (const auto* side : {&result.positive, &result.negative})
                for (const auto& fragment : *side) {
                    SCOPED_TRACE(shape.name + ", plane " + plane.name);
                    const IndexedMesh mesh = fragment->to_indexed_mesh();
                    const Box box = mesh.bounds(), have = fragment->bounds();
                    EXPECT_EQ(have.lo, box.lo);
                    EXPECT_EQ(have.hi, box.hi);
                    EXPECT_EQ(fragment->triangle_count(), mesh.triangles.size());
                    const MassProperties expected = mass_properties(mesh), mass = fragment->mass_properties();
                    EXPECT_NEAR(mass.volume, expected.volume, 1e-12 + 1e-9 * std::abs(expected.volume));
                    const CollisionProxy proxy = collision_proxy(*fragment, ProxyKind::bounded_hull),
                                         loop = collision_proxy(ProxyKind::bounded_hull, mesh.vertices);
                    EXPECT_EQ(proxy.points, loop.points);
                }
        }
    }
}

const Universe& universe_of(const Cuttable& object)
{
    return dynamic_cast<const Fragment&>(object).universe();
}

/// Whether the moments of all leaves that a cut made are known.
bool knows_new_moments(const Cuttable& piece, std::size_t nodes_before)
{
    const TriangleTree& tree = universe_of(piece).tree;
    for (NodeId n{static_cast<Index>(nodes_before)}; n.number() < tree.nodes.size(); ++n)
        if (!tree.moments[n].are_known()) return false;
    return true;
}

TEST(TriangleTree, SumsNoMassForFewTriangles)
{
    for (const std::uint32_t triangles : {2'000u, 20'000u}) {
        auto object = std::move(make_back_end()->prepare(test::repaired(shapes::asteroid(triangles, 1))).object);
        const std::size_t nodes = universe_of(*object).tree.nodes.size();
        EXPECT_EQ(knows_new_moments(*object, 0), object->triangle_count() > kFewForMass);
        const CutResult result = cut(std::move(object), *Plane::through({0, 0, 0}, {1, 2, 3}));
        ASSERT_EQ(result.status, Status::done);
        EXPECT_EQ(knows_new_moments(*result.negative[0], nodes), triangles > kFewForMass);
    }
}

TEST(TriangleTree, MassIsRightWhereCapsMakeManyTrianglesOfFew)
{
    // Slices of the top of a sphere leave more triangles than they take.
    auto object = std::move(make_back_end()->prepare(test::repaired(shapes::uv_sphere(1.0f, 64, 33))).object);
    ASSERT_LE(object->triangle_count(), kFewForMass);
    const std::array directions{glm::dvec3(0, 0, 1), glm::dvec3(0, 1, 0), glm::dvec3(1, 0, 0)};
    for (const glm::dvec3& d : directions) {
        CutResult result = cut(std::move(object), *Plane::through(0.98 * d, d));
        ASSERT_EQ(result.status, Status::done);
        object = std::move(result.negative[0]);
        const MassProperties mass = object->mass_properties(), expected = mass_properties(object->to_indexed_mesh());
        EXPECT_NEAR(mass.volume, expected.volume, 1e-12);
        EXPECT_NEAR(mass.inertia[0][0], expected.inertia[0][0], 1e-12);
    }
    EXPECT_GT(object->triangle_count(), kFewForMass);
}

}  // namespace
}  // namespace kerf::core::halfedge
