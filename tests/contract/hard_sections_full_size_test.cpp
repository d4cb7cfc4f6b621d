// Sections as large as they come: a loop of 100 000 points, 10 000 loops, a plane that grazes a million coplanar
// triangles. What a cut says of them and what it makes; docs/verification.md has the times.

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <string>

#include "common/cutting/cut.h"
#include "common/shapes/hard_sections.h"
#include "support/backends.h"
#include "support/fixtures.h"
#include "support/referee.h"

namespace kerf::core {
namespace {

struct FullSize
{
    std::string name;
    std::uint32_t size;
    std::uint64_t loops, points;  ///< at least so many in the section
};

void PrintTo(const FullSize& section, std::ostream* out)
{
    *out << section.name << " of " << section.size;
}

class FullSizeSection : public testing::TestWithParam<FullSize>
{
};

/// Area vector of the caps along a plane's normal: negative where they look the other way.
double signed_cap_area(const IndexedMesh& mesh, const Plane& plane)
{
    double twice = 0.0;
    for (const TriangleGroup& group : mesh.groups) {
        if (group.kind != TriangleKind::cap) continue;
        for (std::uint32_t t = group.first; t < group.first + group.count; ++t) {
            const auto at = [&](std::size_t i) { return glm::dvec3(mesh.vertices[mesh.triangles[t][i]].position); };
            twice += glm::dot(glm::cross(at(1) - at(0), at(2) - at(0)), plane.normal);
        }
    }
    return twice / 2.0;
}

TEST_P(FullSizeSection, IsCutClosedAndCovered)
{
    const FullSize& section = GetParam();
    const shapes::HardSection hard = *shapes::hard_section(section.name, section.size);
    const IndexedMesh mesh = test::repaired(hard.soup);
    ASSERT_EQ(referee::open_edges(mesh), 0u);
    const double volume = referee::volume(mesh), area = referee::area(mesh);
    std::vector<CutResult> results;
    std::vector<double> surface_behind;  // area of the negative sides' surface
    for (const test::NamedBackend& named : test::backends()) {
        if (named.name != "baseline_remap" && named.name != "halfedge") continue;
        SCOPED_TRACE(named.name);
        results.push_back(cut(named.make()->prepare(mesh).object, hard.plane));
        const CutResult &result = results.back(), &first = results.front();
        ASSERT_EQ(result.status, Status::done);
        EXPECT_GE(result.statistics.section_loops, section.loops);
        EXPECT_EQ(result.statistics.crossing_surface, first.statistics.crossing_surface);
        EXPECT_NEAR(result.section_area, first.section_area, 1e-9 * area);
        double sum = 0.0, surface = 0.0;
        for (const auto* side : {&result.negative, &result.positive}) {
            ASSERT_EQ(side->size(), 1u);
            const IndexedMesh piece = side->front()->to_indexed_mesh();
            EXPECT_EQ(referee::open_edges(piece), 0u);
            EXPECT_EQ(referee::triangles_with_equal_corners(piece), 0u);
            const double sign = side == &result.negative ? 1.0 : -1.0;
            EXPECT_NEAR(sign * signed_cap_area(piece, hard.plane), result.section_area, 1e-6 * area);
            // The fan of the baseline overlaps; a triangulation covers nothing twice.
            if (named.name == "halfedge") {
                EXPECT_NEAR(referee::area(piece, TriangleKind::cap), result.section_area, 1e-6 * area);
            }
            std::uint64_t points = 0;
            for (const SectionLoop& loop : side->front()->section_loops()) points += loop.points.size();
            EXPECT_GE(points, section.points);
            sum += referee::volume(piece);
            surface += referee::area(piece, TriangleKind::surface);
            if (side == &result.negative) surface_behind.push_back(surface);
        }
        EXPECT_NEAR(surface_behind.back(), surface_behind.front(), 1e-9 * area) << "another piece of the surface";
        EXPECT_NEAR(sum, volume, 1e-6 * volume);
        EXPECT_NEAR(surface, area, 1e-6 * area);
    }
}

INSTANTIATE_TEST_SUITE_P(
    All, FullSizeSection,
    testing::Values(FullSize{"comb", 100'000, 1, 100'000}, FullSize{"leaning_comb", 100'000, 1, 100'000},
                    FullSize{"spiral", 100'000, 1, 100'000}, FullSize{"tip", 80'000, 1, 40'000},
                    FullSize{"touches", 100'000, 1, 99'000}, FullSize{"teeth", 10'000, 10'000, 0},
                    FullSize{"hidden_pores", 10'000, 10'000, 0}, FullSize{"loose_parts", 10'000, 10'000, 0},
                    FullSize{"nested_shells", 10'000, 10'000, 0}, FullSize{"pores", 10'000, 10'000, 0},
                    FullSize{"bricks", 10'000, 10'000, 0}, FullSize{"checkerboard", 10'000, 10'000, 0},
                    FullSize{"rosette", 10'000, 10'000, 0}, FullSize{"stack", 10'000, 10'000, 0},
                    FullSize{"wedges", 10'000, 10'000, 0}, FullSize{"flat", 1'000'000, 1, 0},
                    FullSize{"flat_tilted", 1'000'000, 1, 0}, FullSize{"flat_rough", 1'000'000, 10'000, 0}),
    [](const auto& parameter) { return parameter.param.name; });

}  // namespace
}  // namespace kerf::core
