// Whether a point lies inside a piece, asked at 10 000 points a cut: CGAL answers for its own clip with its own test,
// and for our fragments exact winding numbers do. Fragments are not given to CGAL's test as well, because they need not
// be what it asks for: the report's fans overlap, and where loops touch, a point has several fans.

#include <gtest/gtest.h>

#include <CGAL/Side_of_triangle_mesh.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "common/cutting/cut.h"
#include "common/cutting/cut_geometry.h"
#include "common/io/mesh_file.h"
#include "support/cgal_clip.h"
#include "support/fixtures.h"
#include "support/ray_winding.h"

namespace kerf::core {
namespace {

using test::CgalKernel;
using test::CgalMesh;
using test::NamedMesh;
using test::RayWinding;

constexpr std::size_t kPoints = 10'000;
/// A point this near to one of the surfaces, as a share of the mesh's diagonal, may be inside of one and outside of the
/// other: cut points are rounded to float.
constexpr double kNear = 1e-6;

/// Where to ask: a quarter each anywhere in the box, beside the plane, beside the surface and beside the section's rim.
/// Those beside something are 2e-6 to 1e-2 of the diagonal away from it, every order of magnitude as often.
class Sampler
{
public:
    Sampler(const IndexedMesh& mesh, const Plane& plane, std::uint64_t seed)
        : mesh_(mesh),
          plane_(plane),
          random_(seed),
          lo_(mesh.bounds().lo),
          size_(glm::dvec3(mesh.bounds().hi) - glm::dvec3(mesh.bounds().lo))
    {
        for (const Triangle& t : mesh.triangles) {
            const auto [a, b, c] = distances(t);
            if (classify(a, b, c) == TriangleClass::crossing) crossing_.push_back(t);
        }
    }

    std::vector<glm::dvec3> points(std::size_t count)
    {
        std::vector<glm::dvec3> points;
        points.reserve(count);
        while (points.size() < count) {
            points.push_back(anywhere());
            points.push_back(beside_the_plane());
            points.push_back(beside_the_surface());
            points.push_back(crossing_.empty() ? beside_the_plane() : beside_the_rim());
        }
        return points;
    }

private:
    std::array<double, 3> distances(const Triangle& t) const
    {
        return {plane_.signed_distance(mesh_.vertices[t[0]].position),
                plane_.signed_distance(mesh_.vertices[t[1]].position),
                plane_.signed_distance(mesh_.vertices[t[2]].position)};
    }
    glm::dvec3 corner(const Triangle& t, std::size_t i) const { return glm::dvec3(mesh_.vertices[t[i]].position); }

    /// A short way, in mesh units.
    double little()
    {
        constexpr double kLeast = 2e-6, kMost = 1e-2;
        return glm::length(size_) * kLeast * std::pow(kMost / kLeast, random_.uniform());
    }
    double forth_or_back() { return random_.below(2) == 0 ? 1.0 : -1.0; }

    glm::dvec3 anywhere()
    {
        const glm::dvec3 share(random_.uniform(), random_.uniform(), random_.uniform());
        return lo_ + size_ * (1.1 * share - 0.05);
    }
    glm::dvec3 beside_the_plane()
    {
        const glm::dvec3 p = anywhere();
        const double distance = glm::dot(plane_.normal, p) - plane_.offset;
        return p + plane_.normal * (forth_or_back() * little() - distance);
    }
    glm::dvec3 beside_the_surface()
    {
        const Triangle& t = mesh_.triangles[random_.below(std::uint32_t(mesh_.triangles.size()))];
        const double u = std::sqrt(random_.uniform()), v = random_.uniform();
        const glm::dvec3 a = corner(t, 0), b = corner(t, 1), c = corner(t, 2), normal = glm::cross(b - a, c - a);
        const double length = glm::length(normal);
        const glm::dvec3 away = length > 0.0 ? normal / length : random_.direction();
        return (1 - u) * a + u * (1 - v) * b + u * v * c + forth_or_back() * little() * away;
    }
    glm::dvec3 beside_the_rim()
    {
        const Triangle& t = crossing_[random_.below(std::uint32_t(crossing_.size()))];
        const std::array<double, 3> d = distances(t);
        std::array<glm::dvec3, 2> ends{};
        std::size_t found = 0;
        for (std::size_t i = 0; i < 3 && found < 2; ++i) {
            const std::size_t j = (i + 1) % 3;
            if ((d[i] < 0.0) != (d[j] < 0.0))
                ends[found++] = glm::mix(corner(t, i), corner(t, j), d[i] / (d[i] - d[j]));
        }
        return glm::mix(ends[0], ends[1], random_.uniform()) + little() * random_.direction();
    }

    const IndexedMesh& mesh_;
    const Plane& plane_;
    test::Random random_;
    const glm::dvec3 lo_, size_;
    std::vector<Triangle> crossing_;
};

/// For each point what it is to CGAL's clips of one mesh.
class CgalSides
{
public:
    CgalSides(const CgalMesh& whole, const Plane& plane)
        : clips_{test::cgal_clipped(whole, plane), test::cgal_clipped(whole, plane.flipped())}
    {
    }

    bool can_judge() const { return clips_[0] && clips_[1]; }

    std::vector<bool> inside(Side side, const std::vector<glm::dvec3>& points) const
    {
        const CGAL::Side_of_triangle_mesh<CgalMesh, CgalKernel> side_of(*clip(side));
        std::vector<bool> answers;
        answers.reserve(points.size());
        for (const glm::dvec3& p : points) answers.push_back(side_of({p.x, p.y, p.z}) == CGAL::ON_BOUNDED_SIDE);
        return answers;
    }

    double distance(Side side, const glm::dvec3& p) const
    {
        const CgalMesh& mesh = *clip(side);
        double square = std::numeric_limits<double>::infinity();
        for (const auto face : mesh.faces()) {
            const auto h = mesh.halfedge(face);
            const CgalKernel::Triangle_3 triangle(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)),
                                                  mesh.point(mesh.target(mesh.next(h))));
            square = std::min(square, CGAL::squared_distance(CgalKernel::Point_3(p.x, p.y, p.z), triangle));
        }
        return std::sqrt(square);
    }

private:
    const std::optional<CgalMesh>& clip(Side side) const { return clips_[std::size_t(side)]; }

    std::array<std::optional<CgalMesh>, 2> clips_;  // by Side
};

double distance(const RayWinding& surface, const glm::dvec3& p)
{
    double square = std::numeric_limits<double>::infinity();
    for (const auto& [a, b, c] : surface.triangles()) {
        const CgalKernel::Triangle_3 triangle({a.x, a.y, a.z}, {b.x, b.y, b.z}, {c.x, c.y, c.z});
        square = std::min(square, CGAL::squared_distance(CgalKernel::Point_3(p.x, p.y, p.z), triangle));
    }
    return std::sqrt(square);
}

RayWinding winding_of(const std::vector<std::unique_ptr<Cuttable>>& side)
{
    std::vector<IndexedMesh> surfaces;
    for (const auto& fragment : side) surfaces.push_back(fragment->to_indexed_mesh());
    return RayWinding(surfaces);
}

/// Of one or more cuts.
struct Count
{
    int cuts = 0, skipped = 0;  ///< cuts compared, and cuts that CGAL could not judge
    std::uint64_t asked = 0;    ///< points, once for each side and back end
    std::uint64_t inside = 0;   ///< of those that are inside
    std::uint64_t near = 0;     ///< different answers at points that are too near to a surface to tell
    std::uint64_t wrong = 0;    ///< different answers at all others
    glm::dvec3 example{0.0};    ///< one of those
};

/// Asks at all points whether they are inside the pieces of one side, which fill it once.
void compare_side(const CgalSides& referee, Side side, const std::vector<std::unique_ptr<Cuttable>>& pieces,
                  const std::vector<glm::dvec3>& points, const std::vector<bool>& inside, double near, Count& count)
{
    const RayWinding winding = winding_of(pieces);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const std::optional<int> number = winding.around(points[i]);
        ++count.asked;
        count.inside += inside[i];
        if (number == (inside[i] ? 1 : 0)) continue;
        if (std::min(distance(winding, points[i]), referee.distance(side, points[i])) <= near) {
            ++count.near;
        } else {
            ++count.wrong;
            count.example = points[i];
        }
    }
}

void compare_cut(const CgalSides& referee, const CutResult& result, const std::vector<glm::dvec3>& points,
                 const std::array<std::vector<bool>, 2>& inside, double near, Count& count)
{
    compare_side(referee, Side::negative, result.negative, points, inside[0], near, count);
    compare_side(referee, Side::positive, result.positive, points, inside[1], near, count);
}

double near_of(const IndexedMesh& mesh)
{
    const Box box = mesh.bounds();
    return kNear * glm::length(glm::dvec3(box.hi) - glm::dvec3(box.lo));
}

/// Cuts a mesh by planes of all kinds with every fast back end and compares with CGAL.
void compare(const NamedMesh& shape, std::uint64_t seed, Count& count)
{
    const CgalMesh whole = test::to_cgal(shape.mesh);
    const std::vector<test::NamedBackend> backends = test::fast_backends();
    std::vector<std::unique_ptr<Cuttable>> objects;
    for (const test::NamedBackend& backend : backends) objects.push_back(backend.make()->prepare(shape.mesh).object);

    for (const test::NamedPlane& plane : test::planes_for(shape.mesh, 1, seed)) {
        if (cut(objects.front()->clone(), plane.plane).status == Status::missed) continue;
        const CgalSides referee(whole, plane.plane);
        ++(referee.can_judge() ? count.cuts : count.skipped);
        if (!referee.can_judge()) continue;
        const std::vector<glm::dvec3> points = Sampler(shape.mesh, plane.plane, seed).points(kPoints);
        const std::array<std::vector<bool>, 2> inside{referee.inside(Side::negative, points),
                                                      referee.inside(Side::positive, points)};
        for (std::size_t i = 0; i < objects.size(); ++i) {
            CutOptions options;
            options.split_components = i % 2 == 0;
            const CutResult result = cut(objects[i]->clone(), plane.plane, options);
            const std::uint64_t before = count.wrong;
            compare_cut(referee, result, points, inside, near_of(shape.mesh), count);
            EXPECT_EQ(count.wrong, before)
                << backends[i].name << ", " << shape.name << ", plane " << plane.name << ", for example at "
                << count.example.x << ", " << count.example.y << ", " << count.example.z;
        }
    }
}

/// What must be so for the comparison to mean anything.
void check(const Count& count, int least_cuts)
{
    EXPECT_GT(count.cuts, least_cuts);
    EXPECT_LT(count.skipped * 10, count.cuts) << count.skipped << " cuts were not compared";
    EXPECT_LT(count.near * 1000, count.asked);
    EXPECT_GT(count.inside * 20, count.asked);
    EXPECT_LT(count.inside * 2, count.asked);
}

TEST(CgalInside, IsTheSameAtTenThousandPointsForShapes)
{
    Count count;
    for (const NamedMesh& shape : test::closed_shapes()) {
        // CGAL does not clip the volume of a mesh that passes through itself.
        if (shape.name == "overlapping_spheres") continue;
        compare(shape, 51, count);
    }
    check(count, 100);
}

TEST(CgalInside, IsTheSameAtTenThousandPointsForModels)
{
    Count count;
    for (const char* name : {"rook", "barrel", "horse", "pedestal"}) {
        const std::string path = std::string(KERF_DATA_DIR) + "/models/" + name + ".obj";
        compare({name, *io::read_mesh(path).mesh}, 53, count);
    }
    check(count, 25);
}

/// The points are worth asking at: they tell a plane from one that lies a hundred-thousandth of the diagonal beside it.
TEST(CgalInside, SeesAPlaneThatIsALittleOff)
{
    const IndexedMesh& mesh = test::closed_shape("torus");
    const Plane plane = *Plane::through({0.1, 0.2, 0.05}, {1, 2, 3});
    Plane other = plane;
    other.offset += 10 * near_of(mesh);
    const CgalSides referee(test::to_cgal(mesh), plane);
    ASSERT_TRUE(referee.can_judge());
    const std::vector<glm::dvec3> points = Sampler(mesh, plane, 57).points(kPoints);
    const std::array<std::vector<bool>, 2> inside{referee.inside(Side::negative, points),
                                                  referee.inside(Side::positive, points)};
    for (const test::NamedBackend& backend : test::fast_backends()) {
        Count right, wrong;
        compare_cut(referee, cut(backend.make()->prepare(mesh).object, plane), points, inside, near_of(mesh), right);
        compare_cut(referee, cut(backend.make()->prepare(mesh).object, other), points, inside, near_of(mesh), wrong);
        EXPECT_EQ(right.wrong, 0u) << backend.name;
        EXPECT_GT(wrong.wrong, 100u) << backend.name;
    }
}

}  // namespace
}  // namespace kerf::core
