// Volumes and areas of the pieces against CGAL's clip.

#include <gtest/gtest.h>

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>

#include "common/cutting/cut.h"
#include "common/io/mesh_file.h"
#include "common/mesh/plane_noise.h"
#include "support/cgal_clip.h"
#include "support/fixtures.h"
#include "support/referee.h"

namespace kerf::core {
namespace {

using test::CgalMesh;
using test::NamedMesh;

/// Volumes and areas agree within this share of the whole mesh's: what rounding cut points to float costs.
constexpr double kTolerance = 1e-6;

/// Of CGAL's two clips of one mesh.
struct Verdict
{
    double volume_positive, volume_negative;
    double area_positive, area_negative;  ///< of the closed sides, sections included
    double section_area;
};

std::optional<Verdict> judge(const CgalMesh& whole, const Plane& plane)
{
    namespace PMP = CGAL::Polygon_mesh_processing;
    const auto negative = test::cgal_clipped(whole, plane), positive = test::cgal_clipped(whole, plane.flipped());
    if (!negative || !positive) return std::nullopt;
    Verdict verdict{PMP::volume(*positive), PMP::volume(*negative), PMP::area(*positive), PMP::area(*negative), 0};
    verdict.section_area = (verdict.area_positive + verdict.area_negative - PMP::area(whole)) / 2;
    return verdict;
}

double surface_of(const std::vector<std::unique_ptr<Cuttable>>& side)
{
    double sum = 0;
    for (const auto& fragment : side) sum += referee::area(fragment->to_indexed_mesh(), TriangleKind::surface);
    return sum;
}

/// Area of the faces that lie in the plane but for rounding. On which side of such a face the plane passes is decided
/// by the last bit of a vertex, and the section goes over the face or not: both answers are right.
double undecided_area(const IndexedMesh& mesh, const Plane& plane)
{
    const double noise = plane_noise(mesh.bounds().largest_coordinate());
    const glm::dvec3 size = glm::abs(plane.normal);
    if (std::max({size.x, size.y, size.z}) == 1.0) return 0;
    double sum = 0;
    for (const Triangle& t : mesh.triangles) {
        const bool is_near = std::all_of(t.begin(), t.end(), [&](std::uint32_t v) {
            return std::abs(plane.signed_distance(mesh.vertices[v].position)) <= noise;
        });
        if (!is_near) continue;
        const glm::dvec3 a(mesh.vertices[t[0]].position), b(mesh.vertices[t[1]].position),
            c(mesh.vertices[t[2]].position);
        sum += glm::length(glm::cross(b - a, c - a)) / 2;
    }
    return sum;
}

/// How many cuts were compared, and how many CGAL could not judge.
struct Count
{
    int compared = 0, skipped = 0;
};

/// Cuts a mesh by `planes_each` planes of each kind with every fast back end and compares with CGAL.
void compare(const NamedMesh& shape, std::uint32_t planes_each, std::uint64_t seed, Count& count)
{
    const CgalMesh whole = test::to_cgal(shape.mesh);
    ASSERT_TRUE(CGAL::is_closed(whole));
    const double volume = referee::volume(shape.mesh), area = referee::area(shape.mesh);
    std::vector<std::unique_ptr<Cuttable>> objects;
    for (const test::NamedBackend& backend : test::fast_backends())
        objects.push_back(backend.make()->prepare(shape.mesh).object);

    for (const test::NamedPlane& plane : test::planes_for(shape.mesh, planes_each, seed)) {
        const CutResult first = cut(objects.front()->clone(), plane.plane);
        if (first.status == Status::missed) continue;
        const std::optional<Verdict> verdict = judge(whole, plane.plane);
        ++(verdict ? count.compared : count.skipped);
        if (!verdict) continue;
        const double slack = undecided_area(shape.mesh, plane.plane);
        for (std::size_t i = 0; i < objects.size(); ++i) {
            SCOPED_TRACE(test::fast_backends()[i].name + ", " + shape.name + ", plane " + plane.name);
            // Caps are compared by the section's area: the report's fan covers a concave section wrongly, and rightly
            // so. The volume does not mind: a fan and the right cap have one rim and lie in one plane, and between two
            // such chains there is no volume.
            const CutResult result = cut(objects[i]->clone(), plane.plane);
            ASSERT_EQ(result.status, Status::done);
            EXPECT_NEAR(referee::volume(result.positive), verdict->volume_positive, kTolerance * volume);
            EXPECT_NEAR(referee::volume(result.negative), verdict->volume_negative, kTolerance * volume);
            EXPECT_NEAR(result.section_area, verdict->section_area, kTolerance * area + slack);
            EXPECT_NEAR(surface_of(result.positive) + result.section_area, verdict->area_positive,
                        kTolerance * area + 2 * slack);
            EXPECT_NEAR(surface_of(result.negative) + result.section_area, verdict->area_negative,
                        kTolerance * area + 2 * slack);
        }
    }
}

TEST(CgalClip, AgreesWithEveryBackEndOnShapes)
{
    Count count;
    for (const NamedMesh& shape : test::closed_shapes()) {
        // CGAL does not clip the volume of a mesh that passes through itself.
        if (shape.name == "overlapping_spheres") continue;
        compare(shape, 2, 41, count);
    }
    EXPECT_GT(count.compared, 150);
    EXPECT_LT(count.skipped * 10, count.compared) << count.skipped << " cuts were not compared";
}

TEST(CgalClip, AgreesWithEveryBackEndOnModels)
{
    Count count;
    for (const char* name : {"rook", "barrel", "horse", "pedestal"}) {
        const std::string path = std::string(KERF_DATA_DIR) + "/models/" + name + ".obj";
        compare({name, *io::read_mesh(path).mesh}, 1, 43, count);
    }
    EXPECT_GT(count.compared, 25);
    EXPECT_LT(count.skipped * 10, count.compared) << count.skipped << " cuts were not compared";
}

}  // namespace
}  // namespace kerf::core
