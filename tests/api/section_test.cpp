#include <kerf/section.h>
#include <kerf/shapes.h>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <set>
#include <tuple>

#include "api/objects.h"

namespace kerf {
namespace {

class SectionTest : public testing::TestWithParam<std::string>
{
};
INSTANTIATE_TEST_SUITE_P(All, SectionTest, testing::ValuesIn(test::back_end_names()),
                         [](const auto& param) { return param.param; });

double dot(const Vec3d& a, const Vec3d& b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
Vec3d cross(const Vec3d& a, const Vec3d& b)
{
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
double distance(const Vec3d& a, const Vec3d& b)
{
    const Vec3d d{a.x - b.x, a.y - b.y, a.z - b.z};
    return std::sqrt(dot(d, d));
}

/// Twice the signed area of a triangle of the drawing.
double turn(const Vec2d& a, const Vec2d& b, const Vec2d& c)
{
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

std::vector<Vec2d> drawn(const Section& section, std::span<const Vec3f> points)
{
    std::vector<Vec2d> places;
    for (const Vec3f& p : points) places.push_back(section.frame.to_plane(p));
    return places;
}

/// How often a drawn loop runs around a place.
int winding(std::span<const Vec2d> loop, const Vec2d& o)
{
    int turns = 0;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const Vec2d &p = loop[i], &q = loop[(i + 1) % loop.size()];
        if ((p.y <= o.y) == (q.y <= o.y)) continue;
        if (p.y <= o.y ? turn(p, q, o) > 0.0 : turn(p, q, o) < 0.0) turns += p.y <= o.y ? 1 : -1;
    }
    return turns;
}

/// Without the side at x = 1.
Object open_cube(const std::string& back_end)
{
    test::Arrays cube = test::cube_arrays();
    cube.indices.resize(30);
    return test::object_of(test::mesh_of(cube), back_end);
}

Plane random_plane(std::mt19937& random, const Box& box)
{
    std::uniform_real_distribution<double> unit(-1.0, 1.0), share(0.1, 0.9);
    const Normal normal(unit(random), unit(random), unit(random));
    return Plane::at(
               Point(box.lo.x + share(random) * (box.hi.x - box.lo.x), box.lo.y + share(random) * (box.hi.y - box.lo.y),
                     box.lo.z + share(random) * (box.hi.z - box.lo.z)),
               normal)
        .value();
}

TEST_P(SectionTest, OfACubeIsASquare)
{
    const Object cube = test::cube(GetParam());
    const Section found = section(cube, Plane::x(0.25).value());
    EXPECT_EQ(found.status, Status::done);
    EXPECT_STREQ(found.reason(), "");
    EXPECT_NEAR(found.area, 4.0, 1e-12);
    EXPECT_NEAR(found.length, 8.0, 1e-12);
    EXPECT_NEAR(distance(found.centroid, {0.25, 0, 0}), 0.0, 1e-12);
    EXPECT_EQ(found.bounds.lo, Vec3f(0.25f, -1, -1));
    EXPECT_EQ(found.bounds.hi, Vec3f(0.25f, 1, 1));
    ASSERT_EQ(found.path_count(), 1u);
    const SectionPath path = found.path(0);
    EXPECT_TRUE(path.is_closed);
    EXPECT_EQ(path.parent, kNone);
    EXPECT_EQ(path.area, found.area);
    EXPECT_EQ(path.length, found.length);
    EXPECT_EQ(path.points.size(), 8u) << "the corners, and the diagonals of four sides";
    ASSERT_EQ(path.edges.size(), 8u);
    std::set<std::uint32_t> sources;
    for (const SectionEdge& edge : path.edges) {
        EXPECT_EQ(edge.material, 0u);
        EXPECT_LT(edge.source, 12u);
        sources.insert(edge.source);
    }
    EXPECT_EQ(sources.size(), 8u);
    EXPECT_EQ(found.statistics().triangles, 12u);
    EXPECT_EQ(found.statistics().crossing_triangles, 8u);
    EXPECT_EQ(found.statistics().section_loops, 1u);
    EXPECT_TRUE(found.triangles().empty()) << "nobody asked for them";
    EXPECT_TRUE(found.path(1).points.empty());
    EXPECT_EQ(cube.triangle_count(), 12u);
}

TEST_P(SectionTest, EachPathLiesInThePlaneAndOnTheTrianglesThatItsEdgesName)
{
    const Mesh mesh = test::shape("torus", 800);
    const MeshArrays arrays = mesh.arrays();
    const Object torus = test::object_of(mesh, GetParam());
    std::mt19937 random(3);
    for (int i = 0; i < 20; ++i) {
        const Plane plane = random_plane(random, torus.bounds());
        const Section found = section(torus, plane);
        for (std::size_t p = 0; p < found.path_count(); ++p) {
            const SectionPath path = found.path(p);
            for (std::size_t e = 0; e < path.edges.size(); ++e) {
                // A point of an edge lies in the plane of its triangle.
                ASSERT_LT(path.edges[e].source, arrays.indices.size() / 3);
                Vec3d corner[3];
                for (int c = 0; c < 3; ++c) corner[c] = arrays.positions[arrays.indices[3 * path.edges[e].source + c]];
                const Vec3d a{corner[1].x - corner[0].x, corner[1].y - corner[0].y, corner[1].z - corner[0].z},
                    b{corner[2].x - corner[0].x, corner[2].y - corner[0].y, corner[2].z - corner[0].z}, n = cross(a, b);
                const double size = std::sqrt(dot(n, n));
                for (const Vec3f& end : {path.points[e], path.points[(e + 1) % path.points.size()]}) {
                    EXPECT_NEAR(plane.distance(end), 0.0, 1e-6);
                    const Vec3d to{end.x - corner[0].x, end.y - corner[0].y, end.z - corner[0].z};
                    EXPECT_NEAR(dot(n, to) / size, 0.0, 1e-6);
                }
            }
        }
    }
}

TEST_P(SectionTest, TheDrawingIsSeenFromThePositiveSide)
{
    const Object torus = test::object_of(test::shape("torus", 800), GetParam());
    std::mt19937 random(5);
    for (int i = 0; i < 50; ++i) {
        const Plane plane = random_plane(random, torus.bounds());
        const Section found = section(torus, plane);
        const SectionFrame& frame = found.frame;
        EXPECT_NEAR(dot(frame.x, frame.x), 1.0, 1e-14);
        EXPECT_NEAR(dot(frame.y, frame.y), 1.0, 1e-14);
        EXPECT_NEAR(dot(frame.x, frame.y), 0.0, 1e-14);
        EXPECT_NEAR(distance(cross(frame.x, frame.y), plane.normal()), 0.0, 1e-14);
        EXPECT_NEAR(plane.distance(frame.origin), 0.0, 1e-15);
        double twice = 0.0;
        for (std::size_t p = 0; p < found.path_count(); ++p) {
            const std::vector<Vec2d> places = drawn(found, found.path(p).points);
            for (std::size_t k = 0; k < places.size(); ++k) {
                EXPECT_NEAR(distance(frame.to_space(places[k]), found.path(p).points[k]), 0.0, 1e-6);
                twice += turn({0, 0}, places[k], places[(k + 1) % places.size()]);
            }
        }
        EXPECT_NEAR(0.5 * twice, found.area, 1e-6 * std::abs(found.area)) << "it would be mirrored";
    }
}

TEST_P(SectionTest, ZPointsUpwardsUnlessThePlaneIsNearlyLevelOrTheCallerSaysWhatDoes)
{
    const Object cube = test::cube(GetParam());
    const auto frame_of = [&](const Plane& plane, std::optional<Vec3d> up = {}) {
        SectionOptions options;
        options.up = up;
        return section(cube, plane, options).frame;
    };
    const auto expect = [](const SectionFrame& frame, const Vec3d& x, const Vec3d& y) {
        EXPECT_NEAR(distance(frame.x, x), 0.0, 1e-14);
        EXPECT_NEAR(distance(frame.y, y), 0.0, 1e-14);
    };
    expect(frame_of(Plane::z(0.1).value()), {1, 0, 0}, {0, 1, 0});
    expect(frame_of(Plane::x(0.1).value()), {0, 1, 0}, {0, 0, 1});
    expect(frame_of(Plane::y(0.1).value()), {-1, 0, 0}, {0, 0, 1});
    expect(frame_of(Plane::z(0.1).value().flipped()), {-1, 0, 0}, {0, 1, 0});
    expect(frame_of(Plane::x(0.1).value(), Vec3d{0, 7, 0}), {0, 0, -1}, {0, 1, 0});
    expect(frame_of(Plane::z(0.1).value(), Vec3d{1e-300, 0, 0}), {0, -1, 0}, {1, 0, 0});
    // With nothing of it in the plane, any direction is as good.
    const SectionFrame upright = frame_of(Plane::z(0.1).value(), Vec3d{0, 0, 1});
    EXPECT_NEAR(dot(upright.x, upright.x), 1.0, 1e-14);
    EXPECT_NEAR(distance(cross(upright.x, upright.y), {0, 0, 1}), 0.0, 1e-14);
    // A miss has a frame, too.
    expect(frame_of(Plane::x(5.0).value()), {0, 1, 0}, {0, 0, 1});
}

TEST_P(SectionTest, AHoleLiesInItsLoopAndWhatStandsInTheHoleLiesInTheHole)
{
    // Shells in shells: body, cavity, core, its cavity ...
    const Object dolls = test::object_of(test::shape("nested_spheres", 8000), GetParam());
    std::mt19937 random(7);
    std::size_t nested = 0;
    for (int i = 0; i < 30; ++i) {
        const Section found = section(dolls, random_plane(random, dolls.bounds()));
        std::vector<std::size_t> by_size(found.path_count());
        for (std::size_t p = 0; p < by_size.size(); ++p) by_size[p] = p;
        std::sort(by_size.begin(), by_size.end(), [&](std::size_t a, std::size_t b) {
            return std::abs(found.path(a).area) > std::abs(found.path(b).area);
        });
        for (std::size_t rank = 0; rank < by_size.size(); ++rank) {
            EXPECT_EQ(found.path(by_size[rank]).parent, rank == 0 ? kNone : by_size[rank - 1]);
            EXPECT_EQ(found.path(by_size[rank]).area < 0.0, rank % 2 == 1);
        }
        nested += by_size.size() > 2 ? 1 : 0;
    }
    EXPECT_GT(nested, 10u);
}

TEST_P(SectionTest, NestingIsWhatWindingNumbersSay)
{
    for (const char* name : {"menger_sponge", "torus", "comb", "tray", "pipe", "sphere_in_sphere", "two_legs"}) {
        SCOPED_TRACE(name);
        const Object object = test::object_of(test::shape(name, 6000), GetParam());
        std::mt19937 random(11);
        for (int i = 0; i < 15; ++i) {
            const Section found = section(object, random_plane(random, object.bounds()));
            std::vector<std::vector<Vec2d>> loops;
            for (std::size_t p = 0; p < found.path_count(); ++p) {
                ASSERT_TRUE(found.path(p).is_closed);
                loops.push_back(drawn(found, found.path(p).points));
            }
            for (std::size_t p = 0; p < loops.size(); ++p) {
                std::uint32_t around = kNone;
                for (std::uint32_t q = 0; q < loops.size(); ++q) {
                    if (q == p || winding(loops[q], loops[p].front()) == 0) continue;
                    if (around == kNone || std::abs(found.path(q).area) < std::abs(found.path(around).area)) around = q;
                }
                EXPECT_EQ(found.path(p).parent, around);
            }
        }
    }
}

TEST_P(SectionTest, TheTrianglesCoverTheSection)
{
    SectionOptions options;
    options.fill = true;
    options.nesting = false;
    for (const char* name : {"menger_sponge", "torus", "comb", "spiral_wall", "sphere_in_sphere", "asteroid"}) {
        SCOPED_TRACE(name);
        const Object object = test::object_of(test::shape(name, 6000), GetParam());
        std::mt19937 random(13);
        Section found;
        for (int i = 0; i < 15; ++i) {
            const Plane plane = random_plane(random, object.bounds());
            if (!ok(section(object, plane, found, options))) continue;
            const std::vector<Vec2d> places = drawn(found, found.points());
            double twice = 0.0;
            const auto corners = found.triangles();
            ASSERT_EQ(corners.size() % 3, 0u);
            ASSERT_FALSE(corners.empty());
            for (const std::uint32_t corner : corners) ASSERT_LT(corner, places.size());
            for (std::size_t c = 0; c < corners.size(); c += 3)
                twice += std::abs(turn(places[corners[c]], places[corners[c + 1]], places[corners[c + 2]]));
            EXPECT_NEAR(0.5 * twice, found.area, 1e-6 * found.area);
            EXPECT_FALSE(found.fill_exceeds_section);
        }
    }
}

TEST_P(SectionTest, OverlappingSolidsAreFilledEach)
{
    const Object both = test::object_of(test::shape("overlapping_spheres", 4000), GetParam());
    SectionOptions options;
    options.fill = true;
    const Section found = section(both, Plane::z(0.1).value(), options);
    ASSERT_EQ(found.path_count(), 2u);
    EXPECT_NE(found.path(0).solid, found.path(1).solid);
    EXPECT_EQ(found.path(0).parent, kNone);
    EXPECT_EQ(found.path(1).parent, kNone);
    const std::vector<Vec2d> places = drawn(found, found.points());
    double twice = 0.0;
    const auto corners = found.triangles();
    for (std::size_t c = 0; c < corners.size(); c += 3)
        twice += turn(places[corners[c]], places[corners[c + 1]], places[corners[c + 2]]);
    EXPECT_NEAR(0.5 * twice, found.area, 1e-6 * found.area);
}

TEST_P(SectionTest, OfAnOpenMeshHasChains)
{
    const Section found = section(open_cube(GetParam()), Plane::y(0.05).value());
    EXPECT_EQ(found.status, Status::open_section);
    ASSERT_EQ(found.path_count(), 1u);
    const SectionPath chain = found.path(0);
    EXPECT_FALSE(chain.is_closed);
    EXPECT_EQ(chain.points.size(), chain.edges.size() + 1);
    EXPECT_EQ(chain.area, 0.0);
    EXPECT_EQ(found.area, 0.0);
    EXPECT_NEAR(chain.length, 6.0, 1e-6);
    EXPECT_EQ(chain.parent, kNone);
    EXPECT_NEAR(distance(found.centroid, {-1.0 / 3.0, 0.05, 0}), 0.0, 1e-6) << "of three sides";
    EXPECT_EQ(found.statistics().open_chains, 1u);
}

TEST_P(SectionTest, OfAMissSaysOnWhichSideTheObjectLies)
{
    const Object cube = test::cube(GetParam());
    const Section found = section(cube, Plane::x(-2.0).value());
    EXPECT_EQ(found.status, Status::missed);
    EXPECT_EQ(found.side_of_object, Side::positive);
    EXPECT_EQ(found.path_count(), 0u);
    EXPECT_EQ(found.area, 0.0);
    EXPECT_STREQ(found.reason(), "");
}

/// Edges as sets of points, and what they say.
std::vector<std::array<float, 8>> edges_of(const Section& section)
{
    std::vector<std::array<float, 8>> edges;
    for (std::size_t p = 0; p < section.path_count(); ++p) {
        const SectionPath path = section.path(p);
        for (std::size_t e = 0; e < path.edges.size(); ++e) {
            const Vec3f &from = path.points[e], &to = path.points[e + 1 < path.points.size() ? e + 1 : 0];
            edges.push_back(
                {from.x, from.y, from.z, to.x, to.y, to.z, float(path.edges[e].source), float(path.edges[e].material)});
        }
    }
    std::sort(edges.begin(), edges.end());
    return edges;
}

TEST(Section, IsTheSameForAllBackEnds)
{
    const std::vector<std::string> names = test::back_end_names();
    for (const char* shape : {"menger_sponge", "torus", "two_legs", "bowl", "nested_spheres"}) {
        SCOPED_TRACE(shape);
        const Mesh mesh = test::shape(shape, 3000);
        const Object first = test::object_of(mesh, names.front());
        std::mt19937 random(17);
        for (int i = 0; i < 10; ++i) {
            const Plane plane = i == 0 ? Plane::z(0.0).value() : random_plane(random, first.bounds());
            const Section expected = section(first, plane);
            for (const std::string& name : names) {
                const Section found = section(test::object_of(mesh, name), plane);
                EXPECT_EQ(found.status, expected.status);
                EXPECT_EQ(edges_of(found), edges_of(expected));
                EXPECT_EQ(found.area, expected.area);
                EXPECT_EQ(found.length, expected.length);
                EXPECT_EQ(std::tie(found.centroid.x, found.centroid.y, found.centroid.z),
                          std::tie(expected.centroid.x, expected.centroid.y, expected.centroid.z));
            }
        }
    }
}

TEST_P(SectionTest, ThatWasUsedBeforeHoldsNothingOfIt)
{
    const Object cube = test::cube(GetParam());
    SectionOptions options;
    options.fill = true;
    Section again;
    EXPECT_EQ(section(open_cube(GetParam()), Plane::y(0.05).value(), again), Status::open_section);
    EXPECT_EQ(section(cube, Plane::x(0.25).value(), again, options), Status::done);
    const Section fresh = section(cube, Plane::x(0.25).value(), options);
    EXPECT_EQ(edges_of(again), edges_of(fresh));
    EXPECT_EQ(again.triangles().size(), fresh.triangles().size());
    EXPECT_EQ(section(cube, Plane::x(9.0).value(), again), Status::missed);
    EXPECT_EQ(again.path_count(), 0u);
    EXPECT_TRUE(again.points().empty() && again.triangles().empty());
    EXPECT_EQ(again.area, 0.0);
    EXPECT_EQ(again.length, 0.0);
    EXPECT_EQ(again.statistics().section_loops, 0u);
}

TEST_P(SectionTest, OfWhatIsNoObjectOrWithOptionsThatMeanNothingSaysSo)
{
    Section found = section(test::cube(GetParam()), Plane::x(0.25).value());
    EXPECT_EQ(section(Object(), Plane::x(0.25).value(), found), Status::invalid_argument);
    EXPECT_STRNE(found.reason(), "");
    EXPECT_EQ(found.path_count(), 0u);
    const double infinity = std::numeric_limits<double>::infinity();
    for (const Vec3d& up : {Vec3d{0, 0, 0}, Vec3d{infinity, 0, 0}, Vec3d{0, std::nan(""), 1}}) {
        SectionOptions options;
        options.up = up;
        EXPECT_EQ(section(test::cube(GetParam()), Plane::x(0.25).value(), options).status, Status::invalid_argument);
    }
    Section moved = section(test::cube(GetParam()), Plane::x(0.25).value());
    Section target = std::move(moved);
    EXPECT_EQ(target.path_count(), 1u);
    EXPECT_EQ(moved.path_count(), 0u);  // NOLINT(bugprone-use-after-move): that is what is tested
    EXPECT_EQ(moved.status, Status::missed);
    EXPECT_EQ(moved.area, 0.0);
    EXPECT_EQ(section(test::cube(GetParam()), Plane::x(0.25).value(), moved), Status::done);
    EXPECT_EQ(moved.path_count(), 1u);
}

TEST_P(SectionTest, OfAPieceNamesTheCapsMaterialAndNoTriangleOfTheInput)
{
    Cut halves = cut(test::cube(GetParam()), Plane::x(0.25).value());
    const Object& half = *halves.one(Side::positive);
    const Section found = section(half, Plane::y(0.1).value());
    EXPECT_NEAR(found.area, 1.5, 1e-6);
    double of_cap = 0.0;
    ASSERT_EQ(found.path_count(), 1u);
    const SectionPath path = found.path(0);
    for (std::size_t e = 0; e < path.edges.size(); ++e) {
        if (path.edges[e].source != kNone) continue;
        EXPECT_STREQ(half.material(path.edges[e].material).name, "cap");
        of_cap += distance(path.points[e], path.points[(e + 1) % path.points.size()]);
    }
    EXPECT_NEAR(of_cap, 2.0, 1e-6);
}

TEST_P(SectionTest, HasAttributesAlongTheOutlineIfTheyAreAskedFor)
{
    const Object cube = test::cube(GetParam());
    SectionOptions options;
    EXPECT_TRUE(section(cube, Plane::z(0.25).value()).path(0).ends.empty());
    options.attributes = true;
    const Section found = section(cube, Plane::z(0.25).value(), options);
    const SectionPath path = found.path(0);
    ASSERT_EQ(path.ends.size(), 2 * path.edges.size());
    for (std::size_t e = 0; e < path.edges.size(); ++e) {
        const DrawVertex &from = path.ends[2 * e], &to = path.ends[2 * e + 1];
        EXPECT_EQ(from.position, path.points[e]);
        EXPECT_EQ(to.position, path.points[(e + 1) % path.points.size()]);
        // The outline of a face: both normals are the face's, across the edge and level.
        EXPECT_EQ(from.normal, to.normal);
        const Vec3d along{to.position.x - from.position.x, to.position.y - from.position.y, 0.0};
        EXPECT_NEAR(dot(along, from.normal), 0.0, 1e-6);
        EXPECT_NEAR(from.normal.z, 0.0, 1e-6);
    }
}

}  // namespace
}  // namespace kerf
