// Without CGAL: caps are right, however sections wind and whatever holes they have. Those of sections that cross
// themselves may cover too much, and the result says so. For the back ends with right caps, over all generated shapes.

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
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

TEST_P(WithoutCgal, CapsAreRightOrSaySo)
{
    std::size_t with_holes = 0;
    test::Random random(5);
    for (const std::string& shape : shapes::names()) {
        // Only one shape runs through itself.
        const bool crosses_itself = shape == "overlapping_spheres";
        const auto object = backend_->prepare(test::repaired(*shapes::make(shape, 4000, 1))).object;
        ASSERT_NE(object, nullptr) << shape;
        const Box box = object->bounds();
        const glm::dvec3 centre = 0.5 * (glm::dvec3(box.lo) + glm::dvec3(box.hi)),
                         size = glm::dvec3(box.hi) - glm::dvec3(box.lo);
        for (int i = 0; i < 12; ++i) {
            // Along the axes, too: there shapes wind most.
            const glm::dvec3 normal = i < 3 ? glm::dvec3(i == 0, i == 1, i == 2) : random.direction();
            const double offset = (0.6 * random.uniform() - 0.3) * std::abs(glm::dot(size, normal));
            const Plane plane = *Plane::through(centre + offset * normal, normal);
            const CutResult result = cut(object->clone(), plane);
            if (result.status != Status::done) continue;
            const Cuttable& piece = *result.positive.front();
            with_holes += has_holes(piece.section_loops(), plane.normal);
            const double covered = referee::cap_area_in_plane(piece.to_indexed_mesh(), plane.normal);
            EXPECT_TRUE(std::abs(covered - result.section_area) <= 1e-6 * result.section_area ||
                        (crosses_itself && result.caps_exceed_section))
                << shape << ' ' << i << " covers " << covered << " of " << result.section_area;
            EXPECT_TRUE(crosses_itself || !result.caps_exceed_section) << shape << ' ' << i;
        }
    }
    EXPECT_GT(with_holes, 20u);
}

/// The surface of random voxels. Those that share only an edge or a corner touch there, and their loops do.
IndexedMesh voxels(test::Random& random)
{
    constexpr int kSize = 6;
    bool is_full[kSize + 2][kSize + 2][kSize + 2] = {};
    for (int x = 1; x <= kSize; ++x)
        for (int y = 1; y <= kSize; ++y)
            for (int z = 1; z <= kSize; ++z) is_full[x][y][z] = random.below(2) == 0;
    TriangleSoup soup;
    soup.has_normals = false;
    const auto add_face = [&](const glm::ivec3& voxel, int axis, int step) {
        const auto first = static_cast<std::uint32_t>(soup.vertices.size());
        for (const auto& [u, v] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
            glm::vec3 corner(voxel);
            corner[axis] += step > 0 ? 1.0f : 0.0f;
            corner[(axis + 1) % 3] += float(step > 0 ? u : v);
            corner[(axis + 2) % 3] += float(step > 0 ? v : u);
            soup.vertices.push_back({corner, {0, 0, 1}, {0, 0}});
        }
        soup.triangles.push_back({first, first + 1, first + 2});
        soup.triangles.push_back({first, first + 2, first + 3});
    };
    for (int x = 1; x <= kSize; ++x)
        for (int y = 1; y <= kSize; ++y)
            for (int z = 1; z <= kSize; ++z)
                for (int axis = 0; axis < 3; ++axis)
                    for (const int step : {-1, 1}) {
                        glm::ivec3 beside(x, y, z);
                        beside[axis] += step;
                        if (is_full[x][y][z] && !is_full[beside.x][beside.y][beside.z]) add_face({x, y, z}, axis, step);
                    }
    return test::repaired(std::move(soup));
}

TEST_P(WithoutCgal, CapsOfWhatTouchesItselfAreRight)
{
    test::Random random(3);
    std::size_t cuts = 0;
    for (int i = 0; i < 20; ++i) {
        const auto object = backend_->prepare(voxels(random)).object;
        ASSERT_NE(object, nullptr);
        for (int k = 0; k < 12; ++k) {
            // Through the middle of a layer, through its faces, and anyhow.
            const glm::dvec3 normal = k < 6 ? glm::dvec3(k % 3 == 0, k % 3 == 1, k % 3 == 2) : random.direction();
            const double height = k < 3 ? 3.5 : k < 6 ? 4.0 : 3.0 + 2.0 * random.uniform();
            const CutResult result = cut(object->clone(), *Plane::through(glm::dvec3(height), normal));
            if (result.status != Status::done) continue;
            ++cuts;
            const IndexedMesh piece = result.positive.front()->to_indexed_mesh();
            EXPECT_EQ(referee::open_edges(piece), 0u) << i << ' ' << k;
            const double covered =
                referee::cap_area_in_plane(piece, Plane::through(glm::dvec3(height), normal)->normal);
            EXPECT_NEAR(covered, result.section_area, 1e-5) << i << ' ' << k;
            EXPECT_FALSE(result.caps_exceed_section) << i << ' ' << k;
        }
    }
    EXPECT_GT(cuts, 200u);
}

TEST_P(WithoutCgal, PiecesStayClosedWhereCapsRunThroughOneAnother)
{
    // The planes turn about nearly one line, along which caps of thin triangles pile up. Rounding to float makes them
    // run through one another, so that the next section has several points in one place, time and again.
    for (const auto& [triangles, step] : {std::pair{200, 0.05}, {800, 0.087}}) {
        CutResult half = cut(backend_->prepare(test::repaired(shapes::asteroid(std::uint64_t(triangles), 1))).object,
                             *Plane::through({0, 0, 0}, {0, 0, 1}));
        std::unique_ptr<Cuttable> object = std::move(half.negative.front());
        for (int i = 0; i < 12; ++i) {
            SCOPED_TRACE(std::to_string(triangles) + " triangles, cut " + std::to_string(i));
            CutResult result = cut(std::move(object), *Plane::through({0.0, 0.0, -0.05 - 0.01 * i},
                                                                      {2.0 * step * i, 1.0 - step * i, -1.0}));
            ASSERT_EQ(result.status, Status::done);
            for (const auto* side : {&result.negative, &result.positive})
                EXPECT_EQ(referee::open_edges(side->front()->to_indexed_mesh()), 0u);
            object = std::move(result.negative.front());
        }
    }
}

TEST_P(WithoutCgal, DelaunayIsRefusedAndTheObjectComesBack)
{
    CutOptions options;
    options.cap_quality = CapQuality::delaunay;
    CutResult result = cut(backend_->prepare(test::repaired(*shapes::make("torus", 500, 1))).object,
                           *Plane::through({0.0, 0.0, 0.0}, {0, 0, 1}), options);
    EXPECT_EQ(result.status, Status::invalid_argument);
    ASSERT_NE(result.object, nullptr);
    options.cap_quality = CapQuality::fast;
    EXPECT_EQ(cut(std::move(result.object), *Plane::through({0.0, 0.0, 0.0}, {0, 0, 1}), options).status, Status::done);
}

TEST(WithoutCgalEither, NothingFindsWhereEdgesCross)
{
    use_constrained_ways(nullptr);
    const std::vector<glm::dvec2> places{{0, 0}, {1, 1}, {0, 1}, {1, 0}};
    const std::vector<std::array<Index, 2>> edges{{0, 1}, {2, 3}};
    EdgeRoutes routes;
    EXPECT_FALSE(make_route_finder()->find(places, edges, 10, 100, routes));
}

INSTANTIATE_TEST_SUITE_P(All, WithoutCgal, testing::ValuesIn(with_right_caps()),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace kerf::core
