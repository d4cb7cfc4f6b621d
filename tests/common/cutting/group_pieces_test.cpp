#include "common/cutting/group_pieces.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <map>
#include <random>

#include "common/cutting/cut_geometry.h"
#include "common/mesh/plane_frame.h"
#include "common/shapes/shapes.h"

namespace kerf::core {
namespace {

void no_crossings(std::span<const AxisRay>, const std::vector<bool>&, const AddCrossing&)
{
    ADD_FAILURE() << "nobody should have to count crossings";
}

using Pieces = std::vector<std::uint32_t>;

/// A closed loop and the part that it bounds.
struct Loop
{
    std::uint32_t part = 0;
    std::vector<glm::vec3> points;
};

/// The pieces of `side`, where each solid is in one part on the other side. Loops share no points.
Pieces pieces_of(const Plane& plane, Side side, const std::vector<SurfacePart>& parts, const std::vector<Loop>& loops,
                 const CountCrossings& count_crossings)
{
    std::map<std::uint32_t, std::uint32_t> other_part;
    std::vector<SurfacePart> other_parts;
    std::vector<glm::vec3> points;
    std::vector<OutlineEdge> outline;
    for (const Loop& loop : loops) {
        const std::uint32_t solid = parts[loop.part].solid;
        const auto [entry, is_new] = other_part.try_emplace(solid, static_cast<std::uint32_t>(other_parts.size()));
        if (is_new) other_parts.push_back({solid, true, false, {}, 0.0});
        const auto first = static_cast<std::uint32_t>(points.size()),
                   count = static_cast<std::uint32_t>(loop.points.size());
        for (std::uint32_t i = 0; i < count; ++i) {
            points.push_back(loop.points[i]);
            OutlineEdge edge{first + i, first + (i + 1) % count, {}};
            edge.part[side] = loop.part;
            edge.part[opposite(side)] = entry->second;
            outline.push_back(edge);
        }
    }
    BySide<SideParts> sides;
    sides[side] = {parts, count_crossings};
    sides[opposite(side)] = {other_parts, no_crossings};
    return group_pieces(plane, sides, points, outline)[side];
}

/// Loops of one section, each with a part of its own, drawn in the plane's frame: u to the right, v up.
class Section
{
public:
    explicit Section(const glm::dvec3& normal = {0, 0, 1}) : plane_(*Plane::through({1, 2, 3}, normal)) {}

    /// A loop through the given points; counter-clockwise is an outer loop. Returns its part.
    std::uint32_t add(const std::vector<glm::dvec2>& points, std::uint32_t solid = 0)
    {
        const PlaneFrame frame = PlaneFrame::of(plane_.normal);
        Loop& loop = loops_.emplace_back();
        loop.part = static_cast<std::uint32_t>(parts_.size());
        for (const glm::dvec2& p : points)
            loop.points.push_back(glm::vec3(plane_.offset * plane_.normal + p.x * frame.u + p.y * frame.v));
        parts_.push_back({solid, true, false, {}, 0.0});
        return static_cast<std::uint32_t>(parts_.size() - 1);
    }

    std::uint32_t add_square(const glm::dvec2& corner, double size, bool hole, std::uint32_t solid = 0)
    {
        const glm::dvec2 a = corner, b{corner.x + size, corner.y}, c{corner.x + size, corner.y + size},
                         d{corner.x, corner.y + size};
        return hole ? add({a, d, c, b}, solid) : add({a, b, c, d}, solid);
    }

    std::vector<std::uint32_t> pieces() const
    {
        Pieces positive = pieces_of(plane_, Side::positive, parts_, loops_, no_crossings);
        EXPECT_EQ(positive, pieces_of(plane_, Side::negative, parts_, loops_, no_crossings));
        return positive;
    }

private:
    Plane plane_;
    std::vector<SurfacePart> parts_;
    std::vector<Loop> loops_;
};

TEST(Pieces, AHoleJoinsTheOuterLoopAroundIt)
{
    Section section;
    section.add_square({2, 2}, 1, true);
    section.add_square({0, 0}, 4, false);
    section.add_square({5, 0}, 4, false);
    EXPECT_EQ(section.pieces(), (Pieces{0, 0, 1}));
}

TEST(Pieces, AnIslandInAHoleIsAPieceOfItsOwn)
{
    Section section;
    section.add_square({0, 0}, 10, false);
    section.add_square({1, 1}, 8, true);
    section.add_square({2, 2}, 6, false);
    section.add_square({3, 3}, 4, true);
    EXPECT_EQ(section.pieces(), (Pieces{0, 0, 1, 1}));
}

TEST(Pieces, SolidsThatOverlapDoNotJoin)
{
    Section section;
    section.add_square({0, 0}, 10, false, 7);
    section.add_square({2, 2}, 2, true, 3);
    section.add_square({1, 1}, 5, false, 3);
    EXPECT_EQ(section.pieces(), (Pieces{0, 1, 1}));
}

TEST(Pieces, AHoleMayTouchItsOuterLoopInPointsAndEdges)
{
    const std::vector<glm::dvec2> outer{{0, 0}, {4, 0}, {8, 0}, {8, 8}, {0, 8}};
    const std::vector<std::vector<glm::dvec2>> holes{
        {{4, 0}, {2, 4}, {6, 4}},                  // a point of both
        {{0, 0}, {0, 8}, {2, 8}, {2, 0}},          // three edges overlap
        {{0, 0}, {0, 8}, {8, 8}, {8, 0}, {4, 1}},  // nearly all of it
        {{3, 0}, {2, 4}, {6, 4}},                  // a point on an edge
        {{0, 4}, {4, 8}, {8, 4}, {4, 0}},          // a point on each edge
    };
    for (const auto& hole : holes) {
        Section section;
        section.add({{8, 0}, {12, 0}, {12, 8}, {8, 8}});  // touches the other one from outside
        section.add(outer);
        section.add(hole);
        EXPECT_EQ(section.pieces(), (Pieces{0, 1, 1}));
    }
}

TEST(Pieces, AHoleInTheBayOfAConcaveLoopIsNotInIt)
{
    Section section;
    section.add_square({-9, -9}, 18, false);
    section.add({{0, 0}, {5, 0}, {5, 5}, {4, 5}, {4, 1}, {1, 1}, {1, 5}, {0, 5}});
    section.add_square({2, 2}, 1, true);
    EXPECT_EQ(section.pieces(), (Pieces{0, 1, 0}));
}

TEST(Pieces, ASolidThatIsNotCutStaysOnePiece)
{
    const std::vector<SurfacePart> parts{
        {4, false, false, {}, 1.0}, {9, false, false, {}, 1.0}, {4, false, false, {}, -0.5}};
    EXPECT_EQ(pieces_of({}, Side::positive, parts, {}, no_crossings), (Pieces{0, 1, 0}));
}

/// The outlines of nested regions: outer loops with holes with outer loops, turned and shifted at random.
struct RandomNest
{
    std::vector<std::vector<glm::dvec2>> loops;
    Pieces expected;

    explicit RandomNest(std::uint32_t seed) : random_(seed)
    {
        fill({0, 0}, 1000.0, false, 0, 0);
        std::vector<std::size_t> order(loops.size());
        for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
        std::shuffle(order.begin(), order.end(), random_);
        std::vector<std::vector<glm::dvec2>> shuffled;
        std::map<std::uint32_t, std::uint32_t> number;
        for (const std::size_t i : order) {
            shuffled.push_back(loops[i]);
            expected.push_back(number.try_emplace(owner_[i], std::uint32_t(number.size())).first->second);
        }
        loops = shuffled;
    }

private:
    double between(double a, double b) { return std::uniform_real_distribution<double>(a, b)(random_); }

    /// Fills a disc with up to four disjoint polygons, each of which is filled with polygons of the other kind.
    void fill(const glm::dvec2& centre, double radius, bool hole, std::uint32_t owner, int depth)
    {
        for (int slot = 0; slot < 4; ++slot) {
            if (depth > 4 || between(0, 1) < 0.35) continue;
            // Four discs in a disc: centres at 0.58 of the radius, radii at most 0.41 of it.
            const double angle = 1.5707963267948966 * slot + 0.3, r = radius * between(0.2, 0.4);
            const glm::dvec2 c = centre + 0.58 * radius * glm::dvec2(std::cos(angle), std::sin(angle));
            const int corners = 3 + static_cast<int>(between(0, 20));
            std::vector<glm::dvec2> points;
            const double start = between(0, 6), step = 6.283185307179586 / corners * (hole ? -1 : 1);
            for (int i = 0; i < corners; ++i)
                points.push_back(c + r * glm::dvec2(std::cos(start + step * i), std::sin(start + step * i)));
            const std::uint32_t own = hole ? owner : static_cast<std::uint32_t>(loops.size());
            loops.push_back(points);
            owner_.push_back(own);
            // A disc that fits into any regular polygon.
            fill(c, 0.5 * r, !hole, own, depth + 1);
        }
    }

    std::mt19937 random_;
    std::vector<std::uint32_t> owner_;
};

RC_GTEST_PROP(Pieces, AreRightForLoopsNestedAtRandomInAnyPlane, ())
{
    const RandomNest nest(*rc::gen::noShrink(rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0u, 1000000u))));
    const auto component = [] { return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(-100, 101)) / 100.0; };
    const glm::dvec3 normal{component(), component(), component()};
    RC_PRE(glm::dot(normal, normal) > 0.01);
    Section section(normal);
    for (const auto& loop : nest.loops) section.add(loop);
    RC_ASSERT(section.pieces() == nest.expected);
}

TEST(Pieces, ThousandsOfLoopsTakeNoQuadraticStep)
{
    // Side by side, each with a hole, in one row; and in one another.
    Section row, nest;
    Pieces expected_row, expected_nest;
    for (std::uint32_t i = 0; i < 10000; ++i) {
        row.add_square({3.0 * i, 0}, 2, false);
        row.add_square({3.0 * i + 0.5, 0.5}, 1, true);
        nest.add_square({-1.0 * i, -1.0 * i}, 2.0 * i + 1, i % 2 == 0);
        expected_row.insert(expected_row.end(), {i, i});
        expected_nest.push_back(i / 2);
    }
    EXPECT_EQ(row.pieces(), expected_row);
    EXPECT_EQ(nest.pieces(), expected_nest);
}

/// A sphere cut by z = 0, as parts: the upper half, and whole shells above the plane.
class CutSpheres
{
public:
    std::uint32_t add(const glm::vec3& centre, float radius, bool inside_out, bool is_cut)
    {
        TriangleSoup mesh = shapes::icosphere(radius, 8);
        auto& triangles = triangles_.emplace_back();
        for (const auto& [a, b, c] : mesh.triangles) {
            const glm::vec3 p = mesh.vertices[a].position + centre, q = mesh.vertices[b].position + centre,
                            r = mesh.vertices[c].position + centre;
            if (p.z < 0 && q.z < 0 && r.z < 0) continue;
            triangles.push_back(inside_out ? std::array{p, r, q} : std::array{p, q, r});
        }
        parts.push_back({0, is_cut, false, triangles.front()[0], inside_out ? -1.0 : 1.0});
        if (is_cut) {
            Loop& loop = loops_.emplace_back();
            loop.part = static_cast<std::uint32_t>(parts.size() - 1);
            const double r = std::sqrt(double(radius) * radius - double(centre.z) * centre.z);
            for (int i = 0; i < 60; ++i) {
                const double angle = 6.283185307179586 / 60 * (inside_out ? -i : i);
                loop.points.push_back(centre + glm::vec3(r * std::cos(angle), r * std::sin(angle), -centre.z));
            }
        }
        return static_cast<std::uint32_t>(parts.size() - 1);
    }

    Pieces pieces() const
    {
        const Plane plane{{0, 0, 1}, 0.0};
        return pieces_of(plane, Side::positive, parts, loops_,
                         [&](std::span<const AxisRay> rays, const std::vector<bool>&, const AddCrossing& add) {
                             for (std::uint32_t i = 0; i < rays.size(); ++i) {
                                 EXPECT_EQ(rays[i].axis, 2);
                                 EXPECT_TRUE(rays[i].ascending);
                                 for (std::uint32_t part = 0; part < triangles_.size(); ++part)
                                     for (const auto& [a, b, c] : triangles_[part])
                                         add(part, i, ray_crossing(rays[i], a, b, c));
                             }
                         });
    }

    std::vector<SurfacePart> parts;

private:
    std::vector<std::vector<std::array<glm::vec3, 3>>> triangles_;
    std::vector<Loop> loops_;
};

TEST(Pieces, AWholeCavityJoinsThePieceItLiesIn)
{
    CutSpheres spheres;
    spheres.add({5, 0, 0}, 2.0f, false, true);
    spheres.add({0, 0, 0}, 2.0f, false, true);
    spheres.add({0.3f, 0.2f, 1.0f}, 0.5f, true, false);
    spheres.add({5.3f, 0.2f, 1.0f}, 0.5f, true, false);
    EXPECT_EQ(spheres.pieces(), (Pieces{0, 1, 1, 0}));
}

TEST(Pieces, ACavityBesideACutCavityIsInTheSamePiece)
{
    CutSpheres spheres;
    spheres.add({0.3f, 0.2f, 2.6f}, 0.5f, true, false);
    spheres.add({0.2f, 0.1f, 0.0f}, 1.5f, true, true);
    spheres.add({9, 0, 0}, 4.0f, false, true);
    spheres.add({0, 0, 0}, 4.0f, false, true);
    EXPECT_EQ(spheres.pieces(), (Pieces{0, 0, 1, 0}));
}

TEST(Pieces, AWholeShellOfPositiveVolumeIsAPieceOfItsOwn)
{
    CutSpheres spheres;
    spheres.add({0, 0, 0}, 2.0f, false, true);
    spheres.add({9, 0, 5}, 2.0f, false, false);  // came off in an earlier cut
    spheres.add({9.2f, 0.1f, 5}, 1.0f, true, false);
    EXPECT_EQ(spheres.pieces(), (Pieces{0, 1, 1}));
}

/// A section drawn as edges between numbered points of the plane z = 0, with what they bound on both sides.
struct Drawing
{
    std::array<std::vector<SurfacePart>, 2> parts;
    std::vector<glm::vec3> points;
    std::vector<OutlineEdge> outline;

    std::uint32_t add_part(Side side, bool is_flat = false)
    {
        auto& list = parts[static_cast<std::size_t>(side)];
        list.push_back({0, true, is_flat, {}, 0.0});
        return static_cast<std::uint32_t>(list.size() - 1);
    }

    void add_path(const std::vector<std::uint32_t>& path, std::uint32_t negative, std::uint32_t positive)
    {
        for (std::size_t i = 0; i + 1 < path.size(); ++i)
            outline.push_back({path[i], path[i + 1], {negative, positive}, static_cast<std::uint32_t>(outline.size())});
    }

    BySide<Pieces> pieces() const
    {
        const BySide<SideParts> sides{SideParts{parts[0], no_crossings}, SideParts{parts[1], no_crossings}};
        return group_pieces({{0, 0, 1}, 0.0}, sides, points, outline);
    }
};

/// Two outer loops side by side, and one of two parts a side of no volume far away.
Drawing with_flat_parts()
{
    Drawing d;
    d.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 0, 0}, {3, 0, 0}, {2, 1, 0}, {-5, 0, 0}, {-4, 0, 0}, {-5, 1, 0}};
    d.add_part(Side::negative);
    d.add_path({3, 4, 5, 3}, 0, d.add_part(Side::positive));
    d.add_path({0, 1, 2, 0}, 0, d.add_part(Side::positive));
    d.add_path({6, 7, 8, 6}, 0, d.add_part(Side::positive, true));
    return d;
}

TEST(Pieces, AFlatPartStaysWithTheFirstPieceThatHasVolume)
{
    EXPECT_EQ(with_flat_parts().pieces(), (BySide<Pieces>{Pieces{0}, Pieces{0, 1, 1}}));
}

TEST(Pieces, WhatIsFlatThroughoutIsApartAsUsual)
{
    Drawing d = with_flat_parts();
    for (SurfacePart& part : d.parts[1]) part.is_flat = true;
    EXPECT_EQ(d.pieces(), (BySide<Pieces>{Pieces{0}, Pieces{0, 1, 2}}));
}

TEST(Pieces, PartsThatTouchInAPointAreApart)
{
    // Two triangles that meet in the origin; the other side hangs together.
    Drawing d;
    d.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {-1, 0, 0}, {-1, -1, 0}};
    d.add_part(Side::negative);
    d.add_path({0, 1, 2, 0}, 0, d.add_part(Side::positive));
    d.add_path({0, 3, 4, 0}, 0, d.add_part(Side::positive));
    EXPECT_EQ(d.pieces(), (BySide<Pieces>{Pieces{0}, Pieces{0, 1}}));
}

TEST(Pieces, ALensOnEitherSideOfAHoleJoinsItsRimOnOneSideOnly)
{
    // Two lenses that meet in both their ends. Above they are apart; below, the outer rim is one part and the inner
    // rim, a hole, another.
    Drawing d;
    d.points = {{0, -2, 0}, {0, 2, 0}, {3, 0, 0}, {1, 0, 0}, {-1, 0, 0}, {-3, 0, 0}};
    const std::uint32_t right = d.add_part(Side::positive), left = d.add_part(Side::positive);
    const std::uint32_t outer = d.add_part(Side::negative), inner = d.add_part(Side::negative);
    d.add_path({0, 2, 1}, outer, right);
    d.add_path({1, 3, 0}, inner, right);
    d.add_path({0, 4, 1}, inner, left);
    d.add_path({1, 5, 0}, outer, left);
    EXPECT_EQ(d.pieces(), (BySide<Pieces>{Pieces{0, 0}, Pieces{0, 1}}));
}

TEST(Pieces, WhereLoopsCannotKeepToOnePieceOnEitherSideThePiecesAreOne)
{
    // The same joints, but all paths lie side by side, so that none is a hole around or in another: the surface meets
    // itself.
    Drawing d;
    d.points = {{0, -2, 0}, {0, 2, 0}, {3, 0, 0}, {2, 0, 0}, {1, 0, 0}, {0.5f, 0, 0}};
    const std::uint32_t one = d.add_part(Side::positive), other = d.add_part(Side::positive);
    const std::uint32_t below = d.add_part(Side::negative), too = d.add_part(Side::negative);
    d.add_path({0, 2, 1}, below, one);
    d.add_path({1, 5, 0}, too, one);
    d.add_path({0, 3, 1}, too, other);
    d.add_path({1, 4, 0}, below, other);
    EXPECT_EQ(d.pieces(), (BySide<Pieces>{Pieces{0, 0}, Pieces{0, 0}}));
}

TEST(Pieces, EdgesThatRunForthAndBackBoundNothing)
{
    // A hole, and the same way back, in a loop: nothing is left of it, so nothing joins.
    Drawing d;
    d.points = {{0, 0, 0}, {9, 0, 0}, {0, 9, 0}, {1, 1, 0}, {1, 2, 0}, {2, 1, 0}};
    d.add_part(Side::negative);
    d.add_path({0, 1, 2, 0}, 0, d.add_part(Side::positive));
    const std::uint32_t gone = d.add_part(Side::positive);
    d.add_path({3, 4, 5, 3}, 0, gone);
    EXPECT_EQ(d.pieces()[Side::positive], (Pieces{0, 0}));
    d.add_path({3, 5, 4, 3}, 0, gone);
    EXPECT_EQ(d.pieces()[Side::positive], (Pieces{0, 1}));
}

RC_GTEST_PROP(Pieces, DoNotDependOnTheOrderOfEdgesAndPoints, ())
{
    const auto number = [](std::uint32_t end) { return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0u, end)); };
    // Closed walks over a small lattice: they touch, cross, and run forth and back.
    Drawing d;
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 4; ++x) d.points.push_back({float(x), float(y), 0.0f});
    for (int i = 0; i < 3; ++i) {
        d.add_part(Side::negative);
        d.add_part(Side::positive);
    }
    for (int walk = 0; walk < 5; ++walk) {
        std::vector<std::uint32_t> path;
        for (int i = 0; i < 5; ++i) path.push_back(number(16));
        path.push_back(path.front());
        d.add_path(path, number(3), number(3));
    }
    std::erase_if(d.outline, [](const OutlineEdge& edge) { return edge.from == edge.to; });

    Drawing shuffled = d;
    std::mt19937 random(number(1000000));
    std::vector<std::uint32_t> place(d.points.size());
    for (std::uint32_t i = 0; i < place.size(); ++i) place[i] = i;
    std::shuffle(place.begin(), place.end(), random);
    for (std::uint32_t i = 0; i < place.size(); ++i) shuffled.points[place[i]] = d.points[i];
    for (OutlineEdge& edge : shuffled.outline) {
        edge.from = place[edge.from];
        edge.to = place[edge.to];
    }
    std::shuffle(shuffled.outline.begin(), shuffled.outline.end(), random);
    RC_ASSERT(shuffled.pieces() == d.pieces());
}

}  // namespace
}  // namespace kerf::core
