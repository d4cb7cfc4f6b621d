// Sections of the fifteen models and of the real meshes of the folder KERF_SHARED_MESHES_DIR, by planes through
// vertices, along edges, in faces and at random. Judges: the cut of a copy, the sum over all triangles, CGAL's slicer,
// and winding numbers.

#include <CGAL/AABB_halfedge_graph_segment_primitive.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Polygon_mesh_slicer.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <iterator>
#include <numeric>
#include <optional>

#include "common/io/mesh_file.h"
#include "common/mesh/plane_noise.h"
#include "common/sections/loop_nesting.h"
#include "common/sections/section_measures.h"
#include "support/cgal_clip.h"
#include "support/fixtures.h"
#include "support/real_files.h"
#include "support/referee.h"

namespace kerf::core {
namespace {

namespace fs = std::filesystem;

/// Planes of a mesh: 4 + 6 * 8.
constexpr std::uint32_t kPlanesOfAKind = 8;
/// Of areas, beside what rounding the points to float may change.
constexpr double kAreaShare = 1e-6;

class RealSection : public testing::TestWithParam<std::tuple<fs::path, test::NamedBackend>>
{
};

GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(RealSection);

INSTANTIATE_TEST_SUITE_P(All, RealSection,
                         testing::Combine(testing::ValuesIn(test::real_files()),
                                          testing::ValuesIn(test::fast_backends())),
                         [](const auto& param) {
                             return test::test_name_of(std::get<0>(param.param)) + "_" + std::get<1>(param.param).name;
                         });

TEST_P(RealSection, HasTheLoopsOfACut)
{
    const auto& [path, back_end] = GetParam();
    const IndexedMesh mesh = *io::read_mesh(path).mesh;
    const auto maker = back_end.make();
    const auto object = maker->prepare(mesh).object;
    const auto before = referee::bytes_of(object->to_indexed_mesh());
    PlaneSection found;
    std::size_t sections = 0;
    for (const test::NamedPlane& plane : test::planes_for(mesh, kPlanesOfAKind, 51)) {
        SCOPED_TRACE("plane " + plane.name);
        const Status status = section(*object, plane.plane, found);
        const CutResult result = cut(object->clone(), plane.plane);
        ASSERT_EQ(name_of(status), name_of(result.status));
        ASSERT_EQ(measure_section(plane.plane, found).area, result.section_area);
        if (result.positive.empty()) continue;
        const auto loops = result.positive.front()->section_loops();
        ASSERT_EQ(found.paths.size(), loops.size());
        sections += loops.empty() ? 0 : 1;
        for (std::size_t i = 0; i < loops.size(); ++i) {
            ASSERT_EQ(found.paths[i].closed, loops[i].closed);
            ASSERT_TRUE(std::ranges::equal(found.points_of(found.paths[i]), loops[i].points));
        }
    }
    EXPECT_GT(sections, 15u);  // of a small convex mesh: planes in faces and along edges miss
    EXPECT_EQ(before, referee::bytes_of(object->to_indexed_mesh()));
}

/// What a closed surface encloses in a plane, summed over triangles one by one; points on the plane count as above it.
/// Nothing if a triangle lies in the plane: the section has a jump there.
std::optional<double> area_by_triangles(const IndexedMesh& mesh, const Plane& plane)
{
    const glm::dvec3 origin = plane.offset * plane.normal;
    double twice = 0.0;
    for (const Triangle& t : mesh.triangles) {
        std::array<glm::dvec3, 3> p;
        std::array<double, 3> d;
        for (std::size_t i = 0; i < 3; ++i) {
            p[i] = glm::dvec3(mesh.vertices[t[i]].position);
            d[i] = plane.signed_distance(mesh.vertices[t[i]].position);
        }
        if (d[0] == 0.0 && d[1] == 0.0 && d[2] == 0.0) return std::nullopt;
        glm::dvec3 up{0}, down{0};  // where its boundary passes the plane
        bool crosses = false;
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t j = (i + 1) % 3;
            if ((d[i] >= 0.0) == (d[j] >= 0.0)) continue;
            crosses = true;
            const glm::dvec3 at = p[i] + (p[j] - p[i]) * (d[i] / (d[i] - d[j]));
            (d[j] >= 0.0 ? up : down) = at - origin;
        }
        if (crosses) twice += glm::dot(plane.normal, glm::cross(down, up));
    }
    return 0.5 * twice;
}

/// Loops as they are seen from the positive side.
using Outline = std::vector<glm::dvec2>;

struct Axes
{
    glm::dvec3 x, y;

    explicit Axes(const glm::dvec3& normal)
        : x(glm::normalize(glm::cross(std::abs(normal.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0), normal))),
          y(glm::cross(normal, x))
    {
    }
    glm::dvec2 operator()(const glm::dvec3& p) const { return {glm::dot(p, x), glm::dot(p, y)}; }
};

double cross(const glm::dvec2& a, const glm::dvec2& b)
{
    return a.x * b.y - a.y * b.x;
}

double area_of(const Outline& loop)
{
    double twice = 0.0;
    for (std::size_t i = 0; i < loop.size(); ++i)
        twice += cross(loop[i] - loop[0], loop[(i + 1) % loop.size()] - loop[0]);
    return 0.5 * twice;
}

/// How often a loop runs around a place; nothing if the place is nearer to it than `least`.
std::optional<int> winding(const Outline& loop, const glm::dvec2& o, double least)
{
    int turns = 0;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const glm::dvec2 a = loop[i] - o, b = loop[(i + 1) % loop.size()] - o, along = b - a;
        const double squared = glm::dot(along, along);
        const double t = squared > 0.0 ? std::clamp(-glm::dot(a, along) / squared, 0.0, 1.0) : 0.0;
        if (glm::length(a + t * along) < least) return std::nullopt;
        if ((a.y <= 0.0) == (b.y <= 0.0)) continue;
        if (a.y <= 0.0 ? cross(a, b) > 0.0 : cross(a, b) < 0.0) turns += a.y <= 0.0 ? 1 : -1;
    }
    return turns;
}

/// How often a loop runs around another one, asked in the middle of some of its edges; nothing if the answers differ,
/// as where solids overlap, or if they come too near to one another to tell.
std::optional<int> winding_around(const Outline& around, const Outline& loop, double least)
{
    constexpr std::size_t kAsked = 16;
    std::optional<int> answer;
    for (std::size_t i = 0; i < loop.size(); i += 1 + loop.size() / kAsked) {
        const auto turns = winding(around, 0.5 * (loop[i] + loop[(i + 1) % loop.size()]), least);
        if (!turns || (answer && *answer != *turns)) return std::nullopt;
        answer = turns;
    }
    return answer;
}

/// The plane, or one near by that has no vertex within `noise`: where one is nearly on the plane CGAL's slicer, whose
/// points are not exact, does not survive. Nothing if there is none.
std::optional<Plane> off_all_vertices(const IndexedMesh& mesh, Plane plane, double noise)
{
    constexpr int kTries = 20;
    constexpr double kStep = 7.0;  // in units of noise
    const auto is_free = [&] {
        return std::ranges::none_of(
            mesh.vertices, [&](const Vertex& v) { return std::abs(plane.signed_distance(v.position)) <= noise; });
    };
    for (int i = 0; i < kTries; ++i, plane.offset += kStep * noise)
        if (is_free()) return plane;
    return std::nullopt;
}

/// By CGAL: polylines without an orientation, so that each is added or taken away by how many others it lies in.
/// Nothing if CGAL leaves a polyline open, or if two come too near to one another to tell.
template <class Slicer>
std::optional<double> area_by_cgal(const Slicer& slicer, const Plane& plane, double noise)
{
    std::vector<std::vector<test::CgalKernel::Point_3>> lines;
    slicer(test::CgalKernel::Plane_3(plane.normal.x, plane.normal.y, plane.normal.z, -plane.offset),
           std::back_inserter(lines));
    const Axes axes(plane.normal);
    std::vector<Outline> loops;
    for (const auto& line : lines) {
        if (line.size() < 3) continue;  // a point, or an edge that the plane touches
        if (line.front() != line.back()) return std::nullopt;
        Outline& loop = loops.emplace_back();
        for (std::size_t i = 0; i + 1 < line.size(); ++i) loop.push_back(axes({line[i].x(), line[i].y(), line[i].z()}));
    }
    double area = 0.0;
    for (const Outline& loop : loops) {
        int depth = 0;
        for (const Outline& other : loops) {
            if (&other == &loop) continue;
            const auto turns = winding_around(other, loop, noise);
            if (!turns) return std::nullopt;
            depth += *turns != 0;
        }
        area += (depth % 2 == 0 ? 1.0 : -1.0) * std::abs(area_of(loop));
    }
    return area;
}

class RealSectionOfClosed : public testing::TestWithParam<fs::path>
{
};

GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(RealSectionOfClosed);

INSTANTIATE_TEST_SUITE_P(All, RealSectionOfClosed, testing::ValuesIn(test::real_files()),
                         [](const auto& param) { return test::test_name_of(param.param); });

TEST_P(RealSectionOfClosed, HasTheAreaOfAllTrianglesAndOfCgalsSlicer)
{
    const IndexedMesh mesh = *io::read_mesh(GetParam()).mesh;
    if (referee::open_edges(mesh) > 0) GTEST_SKIP() << "not closed: it encloses nothing";
    const double noise = plane_noise(mesh.bounds().largest_coordinate());
    const auto maker = test::fast_backends().back().make();
    const auto object = maker->prepare(mesh).object;
    const test::CgalMesh of_cgal = test::to_cgal(mesh);
    const bool cgal_can = of_cgal.number_of_faces() == mesh.triangles.size() && CGAL::is_closed(of_cgal) &&
                          !CGAL::Polygon_mesh_processing::does_self_intersect(of_cgal);
    std::optional<CGAL::Polygon_mesh_slicer<test::CgalMesh, test::CgalKernel>> slicer;
    if (cgal_can) slicer.emplace(of_cgal);

    std::size_t summed = 0, sliced = 0;
    PlaneSection found;
    for (const test::NamedPlane& plane : test::planes_for(mesh, kPlanesOfAKind, 52)) {
        SCOPED_TRACE("plane " + plane.name);
        if (section(*object, plane.plane, found) == Status::missed) continue;
        ASSERT_EQ(found.status, Status::done);
        const SectionMeasures measures = measure_section(plane.plane, found);
        const auto expected = area_by_triangles(mesh, plane.plane);
        if (!expected) continue;
        const double allowed = kAreaShare * std::abs(measures.area) + noise * measures.length;
        EXPECT_NEAR(measures.area, *expected, allowed);
        ++summed;
        const auto free_plane = slicer ? off_all_vertices(mesh, plane.plane, noise) : std::nullopt;
        if (!free_plane || section(*object, *free_plane, found) != Status::done) continue;
        const auto by_cgal = area_by_cgal(*slicer, *free_plane, noise);
        if (!by_cgal) continue;
        EXPECT_NEAR(measure_section(*free_plane, found).area, *by_cgal, allowed);
        ++sliced;
    }
    RecordProperty("planes_summed", int(summed));
    RecordProperty("planes_by_cgal", int(sliced));
    EXPECT_GT(summed, 20u);
    if (cgal_can) {
        EXPECT_GT(sliced, 20u);
    }
}

TEST_P(RealSectionOfClosed, IsNestedAsWindingNumbersSay)
{
    const IndexedMesh mesh = *io::read_mesh(GetParam()).mesh;
    if (referee::open_edges(mesh) > 0) GTEST_SKIP() << "not closed: it encloses nothing";
    const double noise = plane_noise(mesh.bounds().largest_coordinate());
    const auto maker = test::fast_backends().back().make();
    const auto object = maker->prepare(mesh).object;
    PlaneSection found;
    LoopNesting nesting;
    std::size_t asked = 0;
    for (const test::NamedPlane& plane : test::planes_for(mesh, kPlanesOfAKind, 53)) {
        SCOPED_TRACE("plane " + plane.name);
        if (section(*object, plane.plane, found) == Status::missed) continue;
        const Axes axes(plane.plane.normal);
        std::vector<Outline> loops;
        for (const PlaneSection::Path& path : found.paths) {
            Outline& loop = loops.emplace_back();
            for (const glm::vec3& p : found.points_of(path)) loop.push_back(axes(glm::dvec3(p)));
        }
        const auto parents = nesting.find(plane.plane, found);
        for (std::uint32_t i = 0; i < loops.size(); ++i) {
            // The smallest one that runs around the loop, unless one crosses it or comes too near to tell.
            std::optional<std::uint32_t> around = kNoContainer;
            double smallest = 0.0;
            for (std::uint32_t j = 0; j < loops.size() && around; ++j) {
                if (j == i) continue;
                const auto turns = winding_around(loops[j], loops[i], noise);
                if (!turns) around.reset();
                if (!turns || *turns == 0) continue;
                const double area = std::abs(area_of(loops[j]));
                if (*around == kNoContainer || area < smallest) {
                    around = j;
                    smallest = area;
                }
            }
            if (!around) continue;
            ++asked;
            EXPECT_EQ(parents[i], *around) << "loop " << i;
        }
    }
    EXPECT_GT(asked, 20u);
}

}  // namespace
}  // namespace kerf::core
