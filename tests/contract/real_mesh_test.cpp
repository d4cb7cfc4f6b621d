// The fifteen models and the real meshes of the folder KERF_SHARED_MESHES_DIR, cut by planes through vertices, along
// edges, in faces and at random: what holds for shapes that were made for the purpose must hold for them.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "common/io/mesh_file.h"
#include "common/mesh/plane_noise.h"
#include "common/repair/mesh_facts.h"
#include "support/backends.h"
#include "support/fixtures.h"
#include "support/real_files.h"
#include "support/referee.h"

namespace kerf::core {
namespace {

namespace fs = std::filesystem;

/// Whether the section is a single loop all of whose edges are seen counter-clockwise from its mean point: then a fan
/// covers it.
bool is_one_star_shaped_loop(std::span<const SectionLoop> loops, const Plane& plane)
{
    if (loops.size() != 1 || !loops[0].closed) return false;
    const std::vector<glm::vec3>& points = loops[0].points;
    glm::dvec3 centre{0};
    for (const glm::vec3& p : points) centre += glm::dvec3(p);
    centre /= double(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        const glm::dvec3 a = glm::dvec3(points[i]) - centre, b = glm::dvec3(points[(i + 1) % points.size()]) - centre;
        if (glm::dot(glm::cross(a, b), plane.normal) <= 0) return false;
    }
    return true;
}

class RealMesh : public testing::TestWithParam<std::tuple<fs::path, test::NamedBackend>>
{
};

GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(RealMesh);

/// The quadratic lookups are tested on shapes; here they would take hours.
std::vector<test::NamedBackend> fast_backends()
{
    std::vector<test::NamedBackend> fast;
    for (const test::NamedBackend& backend : test::backends())
        if (backend.name != "baseline_scan" && backend.name != "baseline_two_bucket_hash") fast.push_back(backend);
    return fast;
}

INSTANTIATE_TEST_SUITE_P(All, RealMesh,
                         testing::Combine(testing::ValuesIn(test::real_files()), testing::ValuesIn(fast_backends())),
                         [](const auto& param) {
                             return test::test_name_of(std::get<0>(param.param)) + "_" + std::get<1>(param.param).name;
                         });

TEST_P(RealMesh, IsCutIntoSidesThatAreClosedAndAddUp)
{
    const auto& [path, back_end] = GetParam();
    const IndexedMesh mesh = *io::read_mesh(path).mesh;
    const bool is_closed = referee::open_edges(mesh) == 0;
    const bool is_large = mesh.triangles.size() > 200'000;
    const double volume = referee::volume(mesh), surface = referee::area(mesh);
    const double noise = plane_noise(mesh.bounds().largest_coordinate());
    const PrepareResult prepared = back_end.make()->prepare(mesh);
    ASSERT_EQ(prepared.status, Status::done) << prepared.reason;

    auto planes = test::planes_for(mesh, is_large ? 1 : 3, 41);
    if (is_large) planes.resize(6);
    std::size_t cuts = 0;
    for (const test::NamedPlane& plane : planes) {
        SCOPED_TRACE("plane " + plane.name);
        const CutResult result = cut(prepared.object->clone(), plane.plane);
        if (result.status == Status::missed) continue;
        ++cuts;
        ASSERT_TRUE(result.status == Status::done || (!is_closed && result.status == Status::open_section));
        double volumes = 0, surfaces = 0;
        for (const auto* side : {&result.positive, &result.negative}) {
            ASSERT_EQ(side->size(), 1u);
            const IndexedMesh part = side->front()->to_indexed_mesh();
            EXPECT_EQ(check(part), "");
            EXPECT_EQ(referee::triangles_with_equal_corners(part), 0u);
            EXPECT_LE(referee::overhang(part, plane.plane, side == &result.positive), noise);
            if (is_closed) {
                EXPECT_EQ(referee::open_edges(part), 0u);
            }
            volumes += referee::volume(part);
            surfaces += referee::area(part, TriangleKind::surface);
            const auto loops = side->front()->section_loops();
            if (is_one_star_shaped_loop(loops, plane.plane)) {
                EXPECT_NEAR(referee::area(part, TriangleKind::cap), result.section_area, 1e-6 * surface);
            }
        }
        EXPECT_NEAR(surfaces, surface, referee::kSumTolerance * surface);
        if (is_closed) {
            EXPECT_NEAR(volumes, volume, referee::kSumTolerance * std::abs(volume));
        }
    }
    EXPECT_GT(cuts, 3u);
}

}  // namespace
}  // namespace kerf::core
