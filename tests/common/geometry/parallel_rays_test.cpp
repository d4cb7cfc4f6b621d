#include "common/geometry/parallel_rays.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <map>

namespace kerf::core {
namespace {

/// A point of a small lattice: rays meet corners, edges and planes of triangles.
glm::vec3 place()
{
    const auto number = [] { return float(*rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, 6))); };
    return {number(), number(), number()};
}

RC_GTEST_PROP(ParallelRays, MeetWhatEachOfThemMeets, ())
{
    const int axis = *rc::gen::inRange(0, 3);
    const bool ascending = *rc::gen::arbitrary<bool>();
    std::vector<AxisRay> rays;
    for (int i = *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, 40)); i > 0; --i)
        rays.push_back({place(), axis, ascending});
    const ParallelRays bundle(rays);
    for (int i = 0; i < 20; ++i) {
        const glm::vec3 a = place(), b = place(), c = place();
        std::map<std::uint32_t, int> expected, found;
        for (std::uint32_t ray = 0; ray < rays.size(); ++ray)
            if (const int term = ray_crossing(rays[ray], a, b, c); term != 0) expected[ray] = term;
        bundle.for_each_crossing(a, b, c, [&](std::uint32_t ray, int term) { found[ray] += term; });
        RC_ASSERT(found == expected);
        Box box;
        for (const glm::vec3& p : {a, b, c}) box.add(p);
        RC_ASSERT(expected.empty() || bundle.may_meet(box));
    }
}

TEST(ParallelRays, MissABoxThatAllOfThemPass)
{
    const std::vector<AxisRay> rays{{{0, 0, 0}, 2, true}, {{5, 5, 5}, 2, true}};
    const ParallelRays bundle(rays);
    EXPECT_TRUE(bundle.may_meet({{-1, -1, 1}, {1, 1, 2}}));
    EXPECT_FALSE(bundle.may_meet({{-1, -1, -2}, {1, 1, -1}}));
    EXPECT_FALSE(bundle.may_meet({{2, 2, 1}, {4, 4, 9}}));
    EXPECT_FALSE(ParallelRays({}).may_meet({{-1, -1, -2}, {1, 1, -1}}));
}

}  // namespace
}  // namespace kerf::core
