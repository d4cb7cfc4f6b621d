#include "viewer/inside/study.h"

#include <kerf/shapes.h>

#include <gtest/gtest.h>

#include <cmath>

namespace kerf::inside {
namespace {

Study of_a_sphere()
{
    Result<Object> object = prepare(*make_shape("icosphere", 20'000));
    EXPECT_TRUE(object) << object.reason();
    return Study("sphere", *std::move(object));
}

}  // namespace

TEST(Study, AsksOnceForEachPlane)
{
    Study study = of_a_sphere();
    EXPECT_TRUE(study.update());
    EXPECT_FALSE(study.update());
    EXPECT_NEAR(study.section().area, M_PI, 0.01);
    EXPECT_FALSE(study.section().triangles().empty());
    EXPECT_EQ(study.object().triangle_count(), study.section().statistics().triangles);
    // Half of the radius from the middle, as far as the bounds' half diagonal says.
    study.plane().set_place(0.5 / study.plane().half_diagonal());
    EXPECT_TRUE(study.update());
    EXPECT_NEAR(study.section().area, 0.75 * M_PI, 0.01);
    study.plane().set_place(1.0);
    EXPECT_TRUE(study.update());
    EXPECT_EQ(study.section().status, Status::missed);
    EXPECT_TRUE(study.section().triangles().empty());
}

TEST(Study, ContoursLieBehindThePlane)
{
    Study study = of_a_sphere();
    study.update();
    EXPECT_TRUE(study.contours().empty());
    study.show_contours(true);
    EXPECT_TRUE(study.update());
    EXPECT_GT(study.contours().size(), 10u);
    std::size_t met = 0;
    for (const Section& contour : study.contours()) {
        EXPECT_LT(contour.frame.height, study.section().frame.height);
        if (contour.status != Status::done) continue;
        ++met;
        EXPECT_LT(contour.area, study.section().area + 1e-3);
    }
    EXPECT_GT(met, 5u);
    study.show_contours(false);
    study.update();
    EXPECT_TRUE(study.contours().empty());
}

}  // namespace kerf::inside
