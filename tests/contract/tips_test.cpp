// Planes that pass a tip within rounding. Around the tip thousands of cut points lie nearer to one another than floats
// tell places apart, so that the section crosses itself there as often as points have neighbours: caps are right but
// for what rounding moves, and cost what their points do.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <memory>
#include <numbers>
#include <string>

#include "common/cutting/cut.h"
#include "common/mesh/plane_noise.h"
#include "support/backends.h"
#include "support/brief.h"
#include "support/fixtures.h"
#include "support/referee.h"

namespace kerf::core {
namespace {

using test::Random;

enum class Ring
{
    smooth,
    uneven_heights,
    uneven_radii,
    teeth,
    raised_teeth,
    every_scale
};

/// A double cone of 2n triangles from the tips (0, 0, 1) and (0, 0, -1) to a ring. Each wedge keeps to its own angle,
/// so that the solid never meets itself.
TriangleSoup double_cone(Ring ring, std::uint32_t n, Random& random)
{
    TriangleSoup soup;
    soup.has_normals = false;
    const auto add = [&](const glm::vec3& p) { soup.vertices.push_back({p, {0, 0, 1}, {0, 0}}); };
    add({0, 0, 1});
    add({0, 0, -1});
    for (std::uint32_t i = 0; i < n; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / n;
        double radius = 1.0, height = 0.0;
        if (ring == Ring::uneven_heights) height = 0.2 * random.uniform();
        if (ring == Ring::uneven_radii) radius = 0.3 + 0.7 * random.uniform();
        if (ring == Ring::teeth || ring == Ring::raised_teeth) radius = i % 2 == 0 ? 1e-3 : 1.0;
        if (ring == Ring::every_scale && i % 2 == 0) radius = std::ldexp(1.0, -int(random.below(60)));
        if (ring == Ring::raised_teeth) height = i % 2 == 0 ? 0.5 : 0.0;
        add({float(radius * std::cos(angle)), float(radius * std::sin(angle)), float(height)});
    }
    for (std::uint32_t i = 0; i < n; ++i) {
        const std::uint32_t a = 2 + i, b = 2 + (i + 1) % n;
        soup.triangles.push_back({0, a, b});
        soup.triangles.push_back({1, b, a});
    }
    return soup;
}

/// A plane that passes the upper tip by so much.
Plane past_the_tip(double miss, Random& random)
{
    const glm::dvec3 tilt(random.uniform() - 0.5, random.uniform() - 0.5, 0.6 * (random.uniform() - 0.5));
    return *Plane::through({0, 0, 1.0 - miss}, tilt);
}

double length_of(std::span<const SectionLoop> loops)
{
    double length = 0.0;
    for (const SectionLoop& loop : loops)
        for (std::size_t i = 0; i < loop.points.size(); ++i)
            length += glm::distance(loop.points[i], loop.points[(i + 1) % loop.points.size()]);
    return length;
}

/// The half-edge back end, none in a build without it: the baseline's fan is right for no such section.
std::unique_ptr<Backend> halfedge()
{
    for (const test::NamedBackend& named : test::backends())
        if (named.name == "halfedge") return named.make();
    return nullptr;
}

class Tips : public testing::TestWithParam<Ring>
{
protected:
    void SetUp() override
    {
        backend_ = halfedge();
        if (backend_ == nullptr) GTEST_SKIP() << "this build has no half-edge back end";
    }

    /// Cuts a double cone; false where the plane misses it.
    bool cut_and_judge(std::uint32_t n, const Plane& plane, Random& random)
    {
        const IndexedMesh mesh = test::repaired(double_cone(GetParam(), n, random));
        const CutResult result = cut(backend_->prepare(mesh).object, plane);
        if (result.status == Status::missed) return false;
        EXPECT_EQ(result.status, Status::done);
        if (result.status != Status::done) return false;
        for (const auto* side : {&result.positive, &result.negative}) {
            const IndexedMesh piece = side->front()->to_indexed_mesh();
            EXPECT_EQ(check(piece), "");
            EXPECT_EQ(referee::open_edges(piece), 0u);
            // Edges move over points that are as near as rounding moves points.
            const double noise = plane_noise(1.0f) * length_of(side->front()->section_loops());
            const double cap = referee::cap_area_in_plane(piece, plane.normal);
            EXPECT_NEAR(cap, result.section_area, 1e-6 * result.section_area + noise);
        }
        return true;
    }

    std::unique_ptr<Backend> backend_;
};

TEST_P(Tips, AreCappedAsFarAsRoundingLetsThem)
{
    Random random(17);
    std::size_t cuts = 0;
    for (const std::uint32_t n : {8, 30, 120, 250, 500, 2500}) {
        if (test::kBrief && n > 120) break;
        for (const double miss : {2.2e-16, 1e-12, 1e-9, 3e-8, 5.96e-8, 1e-6, -1e-12, -5.96e-8})
            for (int tilt = 0; tilt < (n > 500 ? 1 : 4); ++tilt) {
                SCOPED_TRACE(std::to_string(n) + " triangles, missed by " + std::to_string(std::log10(std::abs(miss))));
                const Plane plane = past_the_tip(miss, random);
                cuts += cut_and_judge(n, plane, random) ? 1 : 0;
            }
    }
    EXPECT_GT(cuts, test::kBrief ? 40u : 80u);
}

/// Points lie about as far from one another as rounding moves them there, and edges side by side are too many to look
/// at in pairs: a handful of them cross.
TEST_P(Tips, AreCappedWhereThousandsOfEdgesMeetSomeTenThousandUnitsBelow)
{
    Random random(18);
    for (const double miss : {1e-5, 1e-4, 2e-4, 1e-3}) {
        SCOPED_TRACE("missed by " + std::to_string(miss));
        EXPECT_TRUE(cut_and_judge(10'000, *Plane::through({0, 0, 1.0 - miss}, {1.0, 2.0, 1.5}), random));
    }
}

TEST_P(Tips, TakeStepsInProportionToTheirPoints)
{
    constexpr double kStepsForPoint = 2000;
    for (const std::uint32_t n : {2'500u, 40'000u}) {
        Random random(n);
        const IndexedMesh mesh = test::repaired(double_cone(GetParam(), n, random));
        const Plane plane = *Plane::through({0, 0, double(0.99999994f)}, {-0.94371573, -0.19737820, -0.26540999});
        const CutResult result = cut(backend_->prepare(mesh).object, plane);
        ASSERT_EQ(result.status, Status::done);
        EXPECT_LE(double(result.statistics.cap_steps), kStepsForPoint * double(result.statistics.crossing_triangles));
    }
}

/// Half of each ring: each point turns left around the origin, so that no edge meets another, near as they are.
/// Untangled, caps had 0.5 % too much area at 3000 points, and fifty times the area at 32 000.
TEST(Stars, OfPointsAtEveryScaleCrossNothingAndAreCappedExactly)
{
    const auto backend = halfedge();
    if (backend == nullptr) GTEST_SKIP() << "this build has no half-edge back end";
    for (const std::uint32_t n : {3000u, 32'000u}) {
        SCOPED_TRACE(n);
        Random random(n);
        const IndexedMesh mesh = test::repaired(double_cone(Ring::every_scale, n, random));
        const CutResult result = cut(backend->prepare(mesh).object, Plane{{0, 0, 1}, 0.5});
        ASSERT_EQ(result.status, Status::done);
        EXPECT_FALSE(result.caps_exceed_section);
        for (const auto* side : {&result.positive, &result.negative}) {
            const IndexedMesh piece = side->front()->to_indexed_mesh();
            EXPECT_EQ(referee::open_edges(piece), 0u);
            const double cap = referee::cap_area_in_plane(piece, {0, 0, 1});
            EXPECT_NEAR(cap, result.section_area, 1e-9 * result.section_area);
        }
    }
}

std::string name_of(const testing::TestParamInfo<Ring>& info)
{
    constexpr std::array kNames{"smooth", "uneven_heights", "uneven_radii", "teeth", "raised_teeth"};
    return kNames[static_cast<std::size_t>(info.param)];
}

INSTANTIATE_TEST_SUITE_P(Rings, Tips,
                         testing::Values(Ring::smooth, Ring::uneven_heights, Ring::uneven_radii, Ring::teeth,
                                         Ring::raised_teeth),
                         name_of);

}  // namespace
}  // namespace kerf::core
