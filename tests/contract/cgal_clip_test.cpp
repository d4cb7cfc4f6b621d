// CGAL's own clip as a referee of the cut: another method, exact predicates, other people's code.

#include <gtest/gtest.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/clip.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh.h>
#include <algorithm>
#include <cmath>
#include <exception>
#include <optional>

#include "common/cut.h"
#include "common/io/mesh_file.h"
#include "support/backends.h"
#include "support/fixtures.h"
#include "support/referee.h"

namespace kerf {
namespace {

using test::NamedMesh;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using CgalMesh = CGAL::Surface_mesh<Kernel::Point_3>;

/// Volumes and areas agree within this share of the whole mesh's: what rounding cut points to float costs.
constexpr double kTolerance = 1e-6;

/// Of CGAL's two clips of one mesh.
struct Verdict
{
    double volume_positive, volume_negative;
    double area_positive, area_negative;  ///< of the closed sides, sections included
    double section_area;
};

CgalMesh to_cgal(const IndexedMesh& mesh)
{
    CgalMesh result;
    std::vector<std::optional<CgalMesh::Vertex_index>> points(mesh.point_count);
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
        const glm::dvec3 p(mesh.vertices[v].position);
        auto& point = points[mesh.points[v]];
        if (!point) point = result.add_vertex({p.x, p.y, p.z});
    }
    for (const Triangle& t : mesh.triangles)
        result.add_face(*points[mesh.points[t[0]]], *points[mesh.points[t[1]]], *points[mesh.points[t[2]]]);
    return result;
}

/// What lies on the negative side of a plane, closed; empty when CGAL gives up.
std::optional<CgalMesh> clipped(CgalMesh mesh, const Plane& plane)
{
    namespace PMP = CGAL::Polygon_mesh_processing;
    try {
        const bool is_done =
            PMP::clip(mesh, Kernel::Plane_3(plane.normal.x, plane.normal.y, plane.normal.z, -plane.offset),
                      CGAL::parameters::clip_volume(true));
        if (!is_done || !CGAL::is_closed(mesh)) return std::nullopt;
        return mesh;
    } catch (const std::exception&) {
        return std::nullopt;
    }
}

std::optional<Verdict> judge(const CgalMesh& whole, const Plane& plane)
{
    namespace PMP = CGAL::Polygon_mesh_processing;
    const auto negative = clipped(whole, plane), positive = clipped(whole, plane.flipped());
    if (!negative || !positive) return std::nullopt;
    Verdict verdict{PMP::volume(*positive), PMP::volume(*negative), PMP::area(*positive), PMP::area(*negative), 0};
    verdict.section_area = (verdict.area_positive + verdict.area_negative - PMP::area(whole)) / 2;
    return verdict;
}

double volume_of(const std::vector<std::unique_ptr<Cuttable>>& side)
{
    double sum = 0;
    for (const auto& fragment : side) sum += referee::volume(fragment->to_indexed_mesh());
    return sum;
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

/// Back ends that are not slow on purpose.
std::vector<test::NamedBackend> fast_backends()
{
    std::vector<test::NamedBackend> result;
    for (const test::NamedBackend& backend : test::backends())
        if (backend.name != "baseline_scan" && backend.name != "baseline_two_bucket_hash") result.push_back(backend);
    return result;
}

/// How many cuts were compared, and how many CGAL could not judge.
struct Count
{
    int compared = 0, skipped = 0;
};

/// Cuts a mesh by `planes_each` planes of each kind with every fast back end and compares with CGAL.
void compare(const NamedMesh& shape, std::uint32_t planes_each, std::uint64_t seed, Count& count)
{
    const CgalMesh whole = to_cgal(shape.mesh);
    ASSERT_TRUE(CGAL::is_closed(whole));
    const double volume = referee::volume(shape.mesh), area = referee::area(shape.mesh);
    std::vector<std::unique_ptr<Cuttable>> objects;
    for (const test::NamedBackend& backend : fast_backends())
        objects.push_back(backend.make()->prepare(shape.mesh).object);

    for (const test::NamedPlane& plane : test::planes_for(shape.mesh, planes_each, seed)) {
        const CutResult first = cut(objects.front()->clone(), plane.plane);
        if (first.status == Status::missed) continue;
        const std::optional<Verdict> verdict = judge(whole, plane.plane);
        ++(verdict ? count.compared : count.skipped);
        if (!verdict) continue;
        const double slack = undecided_area(shape.mesh, plane.plane);
        for (std::size_t i = 0; i < objects.size(); ++i) {
            SCOPED_TRACE(fast_backends()[i].name + ", " + shape.name + ", plane " + plane.name);
            // Caps are compared by the section's area: the report's fan covers a concave section wrongly, and rightly
            // so. The volume does not mind: a fan and the right cap have one rim and lie in one plane, and between two
            // such chains there is no volume.
            const CutResult result = cut(objects[i]->clone(), plane.plane);
            ASSERT_EQ(result.status, Status::cut);
            EXPECT_NEAR(volume_of(result.positive), verdict->volume_positive, kTolerance * volume);
            EXPECT_NEAR(volume_of(result.negative), verdict->volume_negative, kTolerance * volume);
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
        compare({name, io::read_mesh(path).mesh}, 1, 43, count);
    }
    EXPECT_GT(count.compared, 25);
    EXPECT_LT(count.skipped * 10, count.compared) << count.skipped << " cuts were not compared";
}

}  // namespace
}  // namespace kerf
