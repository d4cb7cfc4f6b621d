// CapQuality::delaunay: the same section, closed without needles but where the outline forces them.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "back_ends/back_ends.h"
#include "common/caps/constrained_triangulator.h"
#include "common/shapes/shapes.h"
#include "support/fixtures.h"
#include "support/referee.h"

namespace kerf::core {
namespace {

/// The two corners of an edge in the order of their numbers, by vertex.
using Edge = std::pair<std::uint32_t, std::uint32_t>;

/// The cap of a piece, seen along z.
struct Cap
{
    IndexedMesh mesh;
    std::map<Edge, std::vector<std::uint32_t>> apexes;  ///< of each edge: the third corners of its triangles

    explicit Cap(const Cuttable& piece) : mesh(piece.to_indexed_mesh())
    {
        for (const TriangleGroup& group : mesh.groups) {
            if (group.kind != TriangleKind::cap) continue;
            for (std::uint32_t t = group.first; t < group.first + group.count; ++t)
                for (std::size_t i = 0; i < 3; ++i) {
                    const std::uint32_t a = mesh.triangles[t][i], b = mesh.triangles[t][(i + 1) % 3];
                    apexes[std::minmax(a, b)].push_back(mesh.triangles[t][(i + 2) % 3]);
                }
        }
    }

    std::array<double, 2> place(std::uint32_t v) const
    {
        return {double(mesh.vertices[v].position.x), double(mesh.vertices[v].position.y)};
    }

    /// Of how many inner edges the circle through a triangle holds the fourth point: by more than what its sixteen
    /// products of four lengths round away.
    std::size_t edges_not_delaunay() const
    {
        std::size_t count = 0;
        for (const auto& [edge, apex] : apexes)
            if (apex.size() == 2) count += holds(edge, apex[0], apex[1]);
        return count;
    }

private:
    bool holds(const Edge& edge, std::uint32_t apex, std::uint32_t other) const
    {
        std::array<std::array<double, 3>, 3> rows{};
        const auto d = place(other);
        double largest = 0.0;
        const std::array corners{edge.first, edge.second, apex};
        for (std::size_t i = 0; i < 3; ++i) {
            const double x = place(corners[i])[0] - d[0], y = place(corners[i])[1] - d[1];
            rows[i] = {x, y, x * x + y * y};
            largest = std::max(largest, rows[i][2]);
        }
        const auto& [a, b, c] = rows;
        const double inside = a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
                              a[2] * (b[0] * c[1] - b[1] * c[0]);
        const double turn = (a[0] - c[0]) * (b[1] - c[1]) - (a[1] - c[1]) * (b[0] - c[0]);
        return std::copysign(1.0, turn) * inside > 16.0 * 0x1p-53 * largest * largest;
    }
};

class CapQualityTest : public testing::TestWithParam<std::string>
{
protected:
    void SetUp() override
    {
        entry_ = find_back_end(GetParam());
        if (entry_ == nullptr) GTEST_SKIP() << "this build has no such back end";
    }

    const RegisteredBackend* entry_ = nullptr;
};
INSTANTIATE_TEST_SUITE_P(All, CapQualityTest, testing::Values("linear", "halfedge", "halfedge/cgal"),
                         [](const auto& test) {
                             std::string name = test.param;
                             std::replace(name.begin(), name.end(), '/', '_');
                             return name;
                         });

TEST_P(CapQualityTest, DelaunayCoversTheSectionWithoutAnEdgeThatCouldBeFlipped)
{
    if (!has_constrained_ways()) GTEST_SKIP() << "this build has no CGAL";
    std::size_t cuts = 0, flips_of_fast = 0;
    for (const std::string shape : {"asteroid", "comb", "menger_sponge", "nested_spheres", "spiral_wall", "torus"}) {
        const auto object = entry_->back_end->prepare(test::repaired(*shapes::make(shape, 4000, 1))).object;
        ASSERT_NE(object, nullptr) << shape;
        const Box box = object->bounds();
        for (const double share : {0.31, 0.52, 0.68}) {
            const Plane plane =
                *Plane::through({0.0, 0.0, box.lo.z + share * (double(box.hi.z) - box.lo.z)}, {0, 0, 1});
            std::array<double, 2> area{};
            std::array<std::size_t, 2> triangles{};
            for (const CapQuality quality : {CapQuality::fast, CapQuality::delaunay}) {
                SCOPED_TRACE(shape + " at " + std::to_string(share) + (quality == CapQuality::fast ? ", fast" : ""));
                CutOptions options;
                options.cap_quality = quality;
                const CutResult result = cut(object->clone(), plane, options);
                ASSERT_EQ(result.status, Status::done);
                const Cap cap(*result.positive.front());
                EXPECT_EQ(referee::open_edges(cap.mesh), 0u);
                const auto which = static_cast<std::size_t>(quality);
                area[which] = referee::cap_area_in_plane(cap.mesh, plane.normal);
                triangles[which] = cap.apexes.size();
                EXPECT_NEAR(area[which], result.section_area, 1e-6 * result.section_area);
                // What was prepared by halfedge/cgal has the better caps, whatever is asked for.
                if (quality == CapQuality::delaunay || GetParam() == "halfedge/cgal")
                    EXPECT_EQ(cap.edges_not_delaunay(), 0u);
                else
                    flips_of_fast += cap.edges_not_delaunay();
                ++cuts;
            }
            // Both use the same points, and add none.
            EXPECT_EQ(triangles[0], triangles[1]) << shape << " at " << share;
        }
    }
    EXPECT_EQ(cuts, 36u);
    EXPECT_EQ(flips_of_fast > 100, GetParam() != "halfedge/cgal") << "the referee sees what is not Delaunay";
}

TEST(CapQualityOfHalfedgeCgal, IsThatOfItsPiecesAndCopies)
{
    const RegisteredBackend* const entry = find_back_end("halfedge/cgal");
    if (entry == nullptr) GTEST_SKIP() << "this build has no such back end";
    auto object = entry->back_end->prepare(test::repaired(*shapes::make("torus", 4000, 1))).object;
    for (int i = 0; i < 3; ++i) {
        const Plane plane = *Plane::through({0.0, 0.0, -0.1 * i}, {0, 0, 1});
        CutResult result = cut(i == 1 ? object->clone() : std::move(object), plane);
        ASSERT_EQ(result.status, Status::done);
        EXPECT_EQ(Cap(*result.negative.front()).edges_not_delaunay(), 0u) << i;
        object = std::move(result.negative.front());
        if (i == 1) object->compact();
    }
}

}  // namespace
}  // namespace kerf::core
