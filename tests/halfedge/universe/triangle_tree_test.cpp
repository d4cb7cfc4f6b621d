// What the tree says about a subtree is what a loop over its triangles says.

#include <gtest/gtest.h>

#include <cmath>

#include "common/proxy/collision_proxy.h"
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

}  // namespace
}  // namespace kerf::core::halfedge
