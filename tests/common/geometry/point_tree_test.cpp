#include "common/geometry/point_tree.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <set>

namespace kerf::core {
namespace {

int number(int below)
{
    return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, below));
}

glm::vec3 place(int side)
{
    return {float(number(side)), float(number(side)), float(number(side))};
}

RC_GTEST_PROP(PointTree, FindsWhatALoopFindsWhileWhatWasFoundIsRemoved, ())
{
    const int side = 1 + number(20);  // few places: many equal points
    std::vector<glm::vec3> points;
    for (int i = number(300); i > 0; --i) points.push_back(place(side));
    PointTree tree(points);
    std::set<std::uint32_t> removed;
    for (int search = 0; search < 10; ++search) {
        Box box;
        box.add(place(side));
        box.add(place(side));
        std::set<std::uint32_t> expected, found;
        for (std::uint32_t i = 0; i < points.size(); ++i) {
            const glm::vec3& p = points[i];
            const bool inside = box.lo.x <= p.x && p.x <= box.hi.x && box.lo.y <= p.y && p.y <= box.hi.y &&
                                box.lo.z <= p.z && p.z <= box.hi.z;
            if (inside && !removed.contains(i)) expected.insert(i);
        }
        tree.for_each_in(box, [&](std::uint32_t i) { RC_ASSERT(found.insert(i).second); });
        RC_ASSERT(found == expected);
        RC_ASSERT(tree.any_in(box) == !expected.empty());
        for (const std::uint32_t i : found)
            if (number(3) == 0) {
                tree.remove(i);
                tree.remove(i);  // once more changes nothing
                removed.insert(i);
            }
    }
}

}  // namespace
}  // namespace kerf::core
