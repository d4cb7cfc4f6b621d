// Without CGAL: caps of sections without holes are right, however they wind; those of sections with holes may cover too
// much, and the result says so. For the back ends with right caps, over all generated shapes.

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "common/caps/constrained_triangulator.h"
#include "common/cutting/cut.h"
#include "common/shapes/shapes.h"
#include "support/backends.h"
#include "support/fixtures.h"
#include "support/referee.h"

namespace kerf::core {
namespace {

/// This program never has CGAL's ways.
class WithoutCgal : public testing::TestWithParam<test::NamedBackend>
{
protected:
    WithoutCgal() { use_constrained_ways(nullptr); }
    const std::unique_ptr<Backend> backend_ = GetParam().make();
};

/// Twice the signed area of a loop, along the normal.
double twice_area(const SectionLoop& loop, const glm::dvec3& normal)
{
    glm::dvec3 sum(0.0);
    const glm::dvec3 origin(loop.points.front());
    for (std::size_t i = 0; i < loop.points.size(); ++i)
        sum += glm::cross(glm::dvec3(loop.points[i]) - origin,
                          glm::dvec3(loop.points[(i + 1) % loop.points.size()]) - origin);
    return glm::dot(sum, normal);
}

bool has_holes(std::span<const SectionLoop> loops, const glm::dvec3& normal)
{
    double outer = 0.0, holes = 0.0;
    for (const SectionLoop& loop : loops) {
        const double area = twice_area(loop, normal);
        (area > 0.0 ? outer : holes) += std::abs(area);
    }
    return holes > 1e-9 * outer;
}

std::vector<test::NamedBackend> with_right_caps()
{
    std::vector<test::NamedBackend> chosen;
    for (const test::NamedBackend& backend : test::backends())
        if (!backend.name.starts_with("baseline")) chosen.push_back(backend);
    return chosen;
}

TEST_P(WithoutCgal, CapsOfSectionsWithoutHolesAreRight)
{
    std::size_t with_holes = 0, exceed = 0;
    test::Random random(5);
    for (const std::string& shape : shapes::names()) {
        const auto object = backend_->prepare(test::repaired(*shapes::make(shape, 4000, 1))).object;
        ASSERT_NE(object, nullptr) << shape;
        for (int i = 0; i < 12; ++i) {
            const Box box = object->bounds();
            const glm::dvec3 centre = 0.5 * (glm::dvec3(box.lo) + glm::dvec3(box.hi)),
                             size = glm::dvec3(box.hi) - glm::dvec3(box.lo);
            // Along the axes, too: there shapes wind most.
            const glm::dvec3 normal = i < 3 ? glm::dvec3(i == 0, i == 1, i == 2) : random.direction();
            const Plane plane = *Plane::through(
                centre + (0.6 * random.uniform() - 0.3) * std::abs(glm::dot(size, normal)) * normal, normal);
            const CutResult result = cut(object->clone(), plane);
            if (result.status != Status::done) continue;
            const Cuttable& piece = *result.positive.front();
            const IndexedMesh mesh = piece.to_indexed_mesh();
            const double covered = referee::cap_area_in_plane(mesh, plane.normal);
            const bool fits = std::abs(covered - result.section_area) <= 1e-6 * result.section_area;
            if (has_holes(piece.section_loops(), plane.normal)) {
                ++with_holes;
                exceed += result.caps_exceed_section;
                EXPECT_TRUE(fits || result.caps_exceed_section) << shape << ' ' << i << " says nothing";
            } else {
                EXPECT_TRUE(fits) << shape << ' ' << i << " covers " << covered << " of " << result.section_area;
                EXPECT_FALSE(result.caps_exceed_section) << shape << ' ' << i;
            }
        }
    }
    EXPECT_GT(with_holes, 20u);
    EXPECT_GT(exceed, 0u) << "CGAL is in use";
}

INSTANTIATE_TEST_SUITE_P(All, WithoutCgal, testing::ValuesIn(with_right_caps()),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace kerf::core
