// A cap uses every edge of the outline once, and covers it as often as the loops wind around it.

#include <gtest/gtest.h>

#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <map>
#include <numbers>

#include "common/caps/clipping_triangulator.h"
#include "common/caps/constrained_triangulator.h"
#include "common/caps/convex_triangulator.h"
#include "common/caps/nested_triangulator.h"
#include "common/caps/topological_triangulator.h"
#include "common/caps/untangling_triangulator.h"
#include "support/brief.h"
#include "support/fixtures.h"
#include "support/referee.h"

namespace kerf::core {
namespace {

std::unique_ptr<CapTriangulator> make_untangling()
{
    return make_untangling_triangulator(make_constrained_triangulator(), make_route_finder());
}

struct Outline
{
    std::vector<glm::dvec2> points;
    std::vector<glm::vec3> positions;
    std::vector<Index> starts;

    void add(const std::vector<glm::dvec2>& loop)
    {
        if (starts.empty()) starts.push_back(0);
        for (const glm::dvec2& p : loop) {
            points.push_back(p);
            positions.emplace_back(p.x, p.y, 0.0f);
        }
        starts.push_back(static_cast<Index>(points.size()));
    }
    CapOutline view() const { return {points, positions, starts}; }

    double area() const
    {
        double twice = 0;
        for (std::size_t l = 0; l + 1 < starts.size(); ++l)
            for (Index i = starts[l]; i < starts[l + 1]; ++i) {
                const glm::dvec2 &a = points[i], &b = points[view().successor(i, static_cast<Index>(l))];
                twice += a.x * b.y - b.x * a.y;
            }
        return twice / 2;
    }
};

/// Where a corner lies: a point of the outline, or where edges of it cross.
glm::dvec2 place_of(const Outline& outline, const CapMesh& cap, Index corner)
{
    const std::size_t n = outline.points.size();
    return corner < n ? outline.points[corner] : glm::dvec2(cap.crossing_points[corner - n].position);
}

double area_of(const Outline& outline, const CapMesh& cap, const CapTriangle& t)
{
    const glm::dvec2 a = place_of(outline, cap, t.corner[0]), b = place_of(outline, cap, t.corner[1]),
                     c = place_of(outline, cap, t.corner[2]);
    return ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)) / 2;
}

/// Links are mutual, and each edge of the outline is linked once or cancelled.
void expect_linked(const Outline& outline, const CapMesh& cap)
{
    std::vector<int> uses(outline.points.size(), 0);
    for (Index t = 0; t < cap.triangles.size(); ++t)
        for (Index i = 0; i < 3; ++i) {
            const CapLink link = cap.triangles[t].link[i];
            ASSERT_NE(link, CapLink());
            if (link.is_outline())
                ++uses[link.outline_edge()];
            else
                EXPECT_EQ(cap.triangles[link.triangle()].link[link.corner()], CapLink::to_triangle(t, i));
        }
    for (const auto& [a, b] : cap.cancelled) {
        ++uses[a];
        ++uses[b];
    }
    EXPECT_EQ(uses, std::vector<int>(uses.size(), 1));
}

double signed_area(const Outline& outline, const CapMesh& cap)
{
    double sum = 0;
    for (const CapTriangle& t : cap.triangles) sum += area_of(outline, cap, t);
    return sum;
}

double unsigned_area(const Outline& outline, const CapMesh& cap)
{
    double sum = 0;
    for (const CapTriangle& t : cap.triangles) sum += std::abs(area_of(outline, cap, t));
    return sum;
}

std::vector<glm::dvec2> star(std::size_t points, double outer, double inner, glm::dvec2 centre = {0, 0})
{
    std::vector<glm::dvec2> loop;
    for (std::size_t i = 0; i < points; ++i) {
        const double angle = 2 * std::numbers::pi * double(i) / double(points), r = i % 2 == 0 ? outer : inner;
        loop.emplace_back(float(centre.x + r * std::cos(angle)), float(centre.y + r * std::sin(angle)));
    }
    return loop;
}

std::vector<glm::dvec2> reversed(std::vector<glm::dvec2> loop)
{
    return {loop.rbegin(), loop.rend()};
}

TEST(ConvexTriangulator, CoversAConvexLoopWithoutAFan)
{
    constexpr std::size_t kPoints = 1000;
    Outline outline;
    outline.add(star(kPoints, 1, 1));
    CapMesh cap;
    ASSERT_TRUE(make_convex_triangulator()->triangulate(outline.view(), cap));
    EXPECT_EQ(cap.triangles.size(), kPoints - 2);
    expect_linked(outline, cap);
    EXPECT_NEAR(unsigned_area(outline, cap), outline.area(), 1e-12);
    std::vector<std::size_t> valence(kPoints, 0);
    for (const CapTriangle& t : cap.triangles)
        for (const Index corner : t.corner) ++valence[corner];
    EXPECT_LE(*std::max_element(valence.begin(), valence.end()), 2 * std::ceil(std::log2(kPoints)));
}

TEST(ConvexTriangulator, RefusesWhatIsNotStrictlyConvex)
{
    CapMesh cap;
    Outline concave, collinear, twice_around, two_loops;
    concave.add(star(10, 1, 0.5));
    collinear.add({{0, 0}, {1, 0}, {2, 0}, {2, 2}});
    auto ring = star(8, 1, 1);
    ring.insert(ring.end(), ring.begin(), ring.begin() + 8);
    twice_around.add(ring);
    two_loops.add(star(8, 1, 1));
    two_loops.add(star(8, 1, 1, {4, 0}));
    for (const Outline* outline : {&concave, &collinear, &twice_around, &two_loops})
        EXPECT_FALSE(make_convex_triangulator()->triangulate(outline->view(), cap));
}

/// The section of a rock: a circle with a few octaves of noise.
std::vector<glm::dvec2> rocky(std::size_t points)
{
    test::Random random(4);
    std::array<double, 12> phase{};
    for (double& p : phase) p = 2 * std::numbers::pi * random.uniform();
    std::vector<glm::dvec2> loop;
    for (std::size_t i = 0; i < points; ++i) {
        const double angle = 2 * std::numbers::pi * double(i) / double(points);
        double r = 1, amplitude = 0.2, frequency = 2;
        for (const double p : phase) {
            r += amplitude * std::sin(frequency * angle + p);
            amplitude *= 0.55;
            frequency *= 2;
        }
        loop.emplace_back(float(r * std::cos(angle)), float(r * std::sin(angle)));
    }
    return loop;
}

/// How many triangles a random line crosses, on average: what a later cut pays for a cap.
double triangles_along_a_line(const Outline& outline, const CapMesh& cap)
{
    test::Random random(8);
    std::size_t crossed = 0;
    constexpr int kLines = 200;
    for (int i = 0; i < kLines; ++i) {
        const double angle = 2 * std::numbers::pi * random.uniform(), offset = 1.6 * random.uniform() - 0.8;
        const glm::dvec2 n(std::cos(angle), std::sin(angle));
        for (const CapTriangle& t : cap.triangles) {
            int above = 0;
            for (const Index corner : t.corner) above += glm::dot(n, outline.points[corner]) > offset;
            crossed += above == 1 || above == 2;
        }
    }
    return double(crossed) / kLines;
}

TEST(ClippingTriangulators, CoverAConcaveLoopOnce)
{
    for (const auto& make : {make_clipping_triangulator, make_patient_triangulator})
        for (const auto& loop : {rocky(1000), star(50, 2, 1), star(7, 1, 1), star(3, 1, 1)}) {
            Outline outline;
            outline.add(loop);
            CapMesh cap;
            ASSERT_TRUE(make()->triangulate(outline.view(), cap));
            EXPECT_EQ(cap.triangles.size(), loop.size() - 2);
            expect_linked(outline, cap);
            EXPECT_NEAR(unsigned_area(outline, cap), outline.area(), 1e-12);
        }
}

/// A wedge with points along its sides, whose tip is cut off by an edge of `units` in the last place, downwards.
std::vector<glm::dvec2> wedge_with_a_turned_tip(int points_a_side, int units)
{
    constexpr double kUnit = std::numeric_limits<float>::epsilon() / 2;  // of coordinates in front of 1
    const glm::dvec2 upper(0.75, 0.5 - kUnit * units), lower(0.75, 0.5);
    std::vector<glm::dvec2> loop;
    for (int i = 0; i <= points_a_side; ++i)
        loop.emplace_back(glm::vec2(glm::mix(glm::dvec2(0, 0.3), lower, double(i) / points_a_side)));
    for (int i = 0; i <= points_a_side; ++i)
        loop.emplace_back(glm::vec2(glm::mix(upper, glm::dvec2(0, 0.6), double(i) / points_a_side)));
    return loop;
}

TEST(ClippingTriangulator, TakesATipForASliverWhoseCornersChangedPlacesByARounding)
{
    for (int points = 1; points < 20; ++points) {
        Outline outline;
        outline.add(wedge_with_a_turned_tip(points, 1));
        CapMesh cap;
        ASSERT_TRUE(make_clipping_triangulator()->triangulate(outline.view(), cap)) << points;
        EXPECT_TRUE(cap.turns_over);
        EXPECT_EQ(cap.triangles.size(), outline.points.size() - 2);
        expect_linked(outline, cap);
        EXPECT_NEAR(unsigned_area(outline, cap), outline.area(), 2e-7);

        Outline crossing;
        crossing.add(wedge_with_a_turned_tip(points, 16));
        EXPECT_FALSE(make_clipping_triangulator()->triangulate(crossing.view(), cap)) << points;
    }
}

/// A square with points along its edges, of which neighbours are out of order now and then.
std::vector<glm::dvec2> square_that_runs_back(test::Random& random, std::size_t points_a_side)
{
    std::vector<glm::dvec2> loop;
    const std::array<glm::dvec2, 4> corners{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
    for (std::size_t side = 0; side < 4; ++side) {
        const std::size_t first = loop.size() + 1;
        for (std::size_t i = 0; i < points_a_side; ++i)
            loop.push_back(glm::mix(corners[side], corners[(side + 1) % 4], double(i) / double(points_a_side)));
        for (std::size_t i = first; i + 1 < loop.size(); i += 2)
            if (random.uniform() < 0.3) std::swap(loop[i], loop[i + 1]);
    }
    return loop;
}

TEST(ClippingTriangulators, CloseALoopThatRunsBackAlongAStraightEdge)
{
    test::Random random(4);
    for (const auto& make : {make_clipping_triangulator, make_patient_triangulator})
        for (int i = 0; i < 200; ++i) {
            Outline outline;
            outline.add(square_that_runs_back(random, 2 + std::size_t(i) % 16));
            CapMesh cap;
            ASSERT_TRUE(make()->triangulate(outline.view(), cap)) << i;
            EXPECT_EQ(cap.triangles.size(), outline.points.size() - 2);
            EXPECT_TRUE(cap.cancelled.empty());
            expect_linked(outline, cap);
            EXPECT_NEAR(unsigned_area(outline, cap), 1.0, 1e-12);
        }
}

TEST(ClippingTriangulator, LeavesFewTrianglesAlongALine)
{
    // The issue allows 1.7 times as many as Delaunay's.
    for (const auto& loop : {rocky(3462), star(3462, 1, 1), star(1000, 1, 0.97)}) {
        Outline outline;
        outline.add(loop);
        CapMesh clipped, delaunay;
        ASSERT_TRUE(make_clipping_triangulator()->triangulate(outline.view(), clipped));
        ASSERT_TRUE(make_constrained_triangulator()->triangulate(outline.view(), delaunay));
        EXPECT_LE(triangles_along_a_line(outline, clipped), 1.7 * triangles_along_a_line(outline, delaunay));
    }
}

TEST(ClippingTriangulator, RefusesHolesAndSeveralLoops)
{
    CapMesh cap;
    Outline hole, two_loops;
    hole.add(reversed(star(12, 2, 1)));
    two_loops.add(star(8, 1, 1));
    two_loops.add(star(8, 1, 1, {4, 0}));
    EXPECT_FALSE(make_clipping_triangulator()->triangulate(hole.view(), cap));
    EXPECT_FALSE(make_clipping_triangulator()->triangulate(two_loops.view(), cap));
}

/// A wall that winds around itself, from inside out and back: it has two ears at a time.
std::vector<glm::dvec2> spiral(std::size_t points, double turns)
{
    std::vector<glm::dvec2> out, back;
    const std::size_t half = points / 2;
    for (std::size_t i = 0; i < half; ++i) {
        const double angle = 2 * std::numbers::pi * turns * double(i) / double(half);
        const glm::dvec2 direction(std::cos(angle), std::sin(angle));
        out.push_back(glm::vec2((1.4 + angle) * direction));
        back.push_back(glm::vec2((1.0 + angle) * direction));
    }
    out.insert(out.end(), back.rbegin(), back.rend());
    return out;
}

/// Long teeth that lean over their neighbours: each lies in the bounds of many ears.
std::vector<glm::dvec2> leaning_comb(std::size_t teeth)
{
    std::vector<glm::dvec2> loop{{-1, -1}, {double(teeth) + 1, -1}};
    for (std::size_t i = teeth; i-- > 0;) {
        loop.emplace_back(double(i) + 0.75, 0);
        loop.emplace_back(double(i) + 100.5, 100);
        loop.emplace_back(double(i) + 0.25, 0);
    }
    return loop;
}

TEST(PatientTriangulator, CoversAConcaveLoopOnceThatClippingInLayersRefuses)
{
    for (const auto& loop : {spiral(1000, 20), spiral(100'000, 300), leaning_comb(1500)}) {
        Outline outline;
        outline.add(loop);
        CapMesh cap;
        EXPECT_FALSE(make_clipping_triangulator()->triangulate(outline.view(), cap));
        ASSERT_TRUE(make_patient_triangulator()->triangulate(outline.view(), cap));
        EXPECT_EQ(cap.triangles.size(), loop.size() - 2);
        expect_linked(outline, cap);
        EXPECT_NEAR(unsigned_area(outline, cap), outline.area(), 1e-11 * outline.area());
    }
}

TEST(PatientTriangulator, LooksAtFewCornersOfASpiral)
{
    Outline outline;
    outline.add(spiral(100'000, 300));
    CapMesh cap;
    ASSERT_TRUE(make_patient_triangulator()->triangulate(outline.view(), cap));
    EXPECT_LT(cap.steps, 256 * outline.points.size());
}

/// The same way with two limits.
constexpr auto kNestedWays = {make_nested_triangulator, make_patient_triangulator};

TEST(NestedTriangulators, CoverNestedLoopsOnce)
{
    Outline outline;
    outline.add(star(40, 4, 3));
    outline.add(reversed(star(12, 2, 1.5)));  // a hole
    outline.add(star(8, 1, 0.7));             // an island in it
    outline.add(star(6, 1, 1, {10, 0}));      // beside it
    for (const auto& make : kNestedWays) {
        CapMesh cap;
        ASSERT_TRUE(make()->triangulate(outline.view(), cap));
        // Of an outer loop with h holes: two triangles more for each.
        EXPECT_EQ(cap.triangles.size() + 4, outline.points.size());
        expect_linked(outline, cap);
        EXPECT_NEAR(unsigned_area(outline, cap), outline.area(), 1e-9);
    }
}

/// A plate with a star-shaped hole in each of `rows` times `rows` fields.
Outline perforated(int rows)
{
    test::Random random(11);
    Outline outline;
    const double end = double(rows);
    outline.add({{-1, -1}, {end, -1}, {end, end}, {-1, end}});
    for (int x = 0; x < rows; ++x)
        for (int y = 0; y < rows; ++y) {
            const double angle = random.uniform();
            std::vector<glm::dvec2> loop;
            for (const glm::dvec2& p : star(3 + random.below(9), 0.45, 0.2))
                loop.emplace_back(x + std::cos(angle) * p.x - std::sin(angle) * p.y,
                                  y + std::sin(angle) * p.x + std::cos(angle) * p.y);
            outline.add(reversed(loop));
        }
    return outline;
}

TEST(NestedTriangulators, CoverAPlateWithManyHolesOnce)
{
    constexpr int kRows = 40;
    const Outline outline = perforated(kRows);
    for (const auto& make : kNestedWays) {
        CapMesh cap;
        ASSERT_TRUE(make()->triangulate(outline.view(), cap));
        expect_linked(outline, cap);
        EXPECT_NEAR(unsigned_area(outline, cap), outline.area(), 1e-12 * kRows * kRows);
        EXPECT_LT(cap.steps, 128 * outline.points.size());
    }
}

TEST(NestedTriangulators, LeaveFewTrianglesAlongALine)
{
    const Outline outline = perforated(20);
    CapMesh clipped, delaunay;
    ASSERT_TRUE(make_nested_triangulator()->triangulate(outline.view(), clipped));
    ASSERT_TRUE(make_constrained_triangulator()->triangulate(outline.view(), delaunay));
    EXPECT_LE(triangles_along_a_line(outline, clipped), 2.0 * triangles_along_a_line(outline, delaunay));
}

/// The boundary of random cells of a chequered board: loops in loops, islands, corners that touch, straight runs of points.
/// Their number is the area.
Outline polyomino(test::Random& random, int side, double share, int& cells)
{
    const std::size_t size = static_cast<std::size_t>(side) + 2;
    std::vector<std::uint8_t> is_full(size * size, 0);
    const auto full = [&](int x, int y) -> std::uint8_t& {
        return is_full[static_cast<std::size_t>(y + 1) * size + static_cast<std::size_t>(x + 1)];
    };
    cells = 0;
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) cells += full(x, y) = random.uniform() < share ? 1 : 0;
    // Edges with a full cell on the left and none on the right, by where they start; two start where corners touch.
    std::multimap<std::pair<int, int>, std::pair<int, int>> edges;
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            if (full(x, y) == 0) continue;
            if (full(x, y - 1) == 0) edges.insert({{x, y}, {x + 1, y}});
            if (full(x + 1, y) == 0) edges.insert({{x + 1, y}, {x + 1, y + 1}});
            if (full(x, y + 1) == 0) edges.insert({{x + 1, y + 1}, {x, y + 1}});
            if (full(x - 1, y) == 0) edges.insert({{x, y + 1}, {x, y}});
        }
    Outline outline;
    while (!edges.empty()) {
        std::vector<glm::dvec2> loop;
        const std::pair<int, int> start = edges.begin()->first;
        std::pair<int, int> at = start;
        do {
            auto next = edges.find(at);
            if (edges.count(at) == 2 && random.below(2) == 1) ++next;
            loop.emplace_back(at.first, at.second);
            at = next->second;
            edges.erase(next);
        } while (at != start);
        outline.add(loop);
    }
    return outline;
}

TEST(NestedTriangulators, CoverTenThousandPolyominoesAsTheConstrainedOneDoes)
{
    test::Random random(5);
    const auto nested = make_nested_triangulator(), patient = make_patient_triangulator(),
               constrained = make_constrained_triangulator();
    int closed_by_both = 0, tried = 0;
    constexpr int kTries = test::kBrief ? 1000 : 10'000;
    for (int i = 0; i < kTries; ++i) {
        int cells = 0;
        const Outline outline = polyomino(random, 2 + int(random.below(11)), 0.3 + 0.6 * random.uniform(), cells);
        if (cells == 0) continue;
        ++tried;
        for (const auto* way : {&nested, &patient}) {
            CapMesh cap;
            if (!(*way)->triangulate(outline.view(), cap)) {
                ASSERT_TRUE(way == &nested && outline.starts.size() == 2) << "one loop, which touches nothing";
                continue;
            }
            expect_linked(outline, cap);
            ASSERT_EQ(unsigned_area(outline, cap), cells) << "covered once, no triangle turned over";
        }
        CapMesh referee;
        if (!constrained->triangulate(outline.view(), referee)) continue;
        ++closed_by_both;
        ASSERT_EQ(unsigned_area(outline, referee), cells);
    }
    EXPECT_GT(tried, kTries / 10 * 9);
    EXPECT_GT(closed_by_both, tried / 2);
}

TEST(NestedTriangulators, LetHolesTouchInPoints)
{
    // A chain of holes, each of which begins where the one before ends.
    Outline outline;
    outline.add({{0, 0}, {10, 0}, {10, 10}, {0, 10}});
    for (int i = 1; i < 9; ++i) outline.add(reversed({glm::dvec2(i, i), {i + 1, i}, {i + 1, i + 1}, {i, i + 1}}));
    for (const auto& make : kNestedWays) {
        CapMesh cap;
        ASSERT_TRUE(make()->triangulate(outline.view(), cap));
        expect_linked(outline, cap);
        EXPECT_NEAR(unsigned_area(outline, cap), outline.area(), 1e-12);
    }
}

/// Loops that touch, each in its own way, and what they cover.
struct Touching
{
    const char* name;
    std::vector<std::vector<glm::dvec2>> loops;
    double area;
};

std::vector<Touching> touching()
{
    const std::vector<glm::dvec2> square{{0, 0}, {4, 0}, {4, 4}, {0, 4}};
    std::vector<Touching> all{
        {"a hole at a corner of its own loop", {square, {{0, 0}, {1, 2}, {2, 1}}}, 14.5},
        {"a hole at two corners", {square, {{0, 0}, {1, 2}, {4, 4}, {2, 1}}}, 12.0},
        {"two holes at one point", {square, {{2, 2}, {1, 1}, {1, 3}}, {{2, 2}, {3, 3}, {3, 1}}}, 14.0},
        {"an island at a corner of its hole",
         {{{-9, -9}, {9, -9}, {9, 9}, {-9, 9}}, {{0, 0}, {0, 4}, {4, 4}, {4, 0}}, {{0, 0}, {2, 1}, {1, 2}}},
         324 - 16 + 1.5},
        {"a loop that runs through itself: two triangles at a point",
         {{{0, 0}, {2, 0}, {1, 1}, {2, 2}, {0, 2}, {1, 1}}},
         2.0},
        {"the same, the other way around the point", {{{0, 0}, {2, 0}, {1, 1}}, {{1, 1}, {2, 2}, {0, 2}}}, 2.0},
    };
    Touching board{"a chequerboard", {}, 32};
    for (int x = 0; x < 8; ++x)
        for (int y = x % 2; y < 8; y += 2)
            board.loops.push_back({glm::dvec2(x, y), {x + 1, y}, {x + 1, y + 1}, {x, y + 1}});
    all.push_back(board);
    Touching grid{"a chequerboard of holes", {{{-1, -1}, {9, -1}, {9, 9}, {-1, 9}}}, 100 - 32};
    for (const auto& loop : board.loops) grid.loops.push_back(reversed(loop));
    all.push_back(grid);
    return all;
}

TEST(NestedTriangulators, LetLoopsTouchInPointsInEveryWay)
{
    for (const Touching& each : touching()) {
        SCOPED_TRACE(each.name);
        Outline outline;
        for (const auto& loop : each.loops) outline.add(loop);
        for (const auto& make : kNestedWays) {
            CapMesh cap;
            ASSERT_TRUE(make()->triangulate(outline.view(), cap));
            expect_linked(outline, cap);
            EXPECT_NEAR(unsigned_area(outline, cap), each.area, 1e-12);
        }
    }
}

TEST(NestedTriangulator, LeavesOneLoopThatTouchesNothingToOthers)
{
    CapMesh cap;
    Outline outline;
    outline.add(spiral(1000, 20));
    EXPECT_FALSE(make_nested_triangulator()->triangulate(outline.view(), cap));
}

TEST(NestedTriangulators, RefuseAHoleInNothingAndWhatHasNoEar)
{
    CapMesh cap;
    Outline hole, turned;
    hole.add(reversed(star(12, 2, 1)));
    turned.add({{0, 0}, {0, 1}, {1, 0}});
    for (const Outline* outline : {&hole, &turned})
        for (const auto& make : kNestedWays) EXPECT_FALSE(make()->triangulate(outline->view(), cap));
}

TEST(ConstrainedTriangulator, CoversConcaveAndNestedLoopsOnce)
{
    Outline outline;
    outline.add(star(40, 4, 3));
    outline.add(reversed(star(12, 2, 1.5)));  // a hole
    outline.add(star(8, 1, 0.7));             // an island in it
    outline.add(star(6, 1, 1, {10, 0}));      // beside it
    CapMesh cap;
    ASSERT_TRUE(make_constrained_triangulator()->triangulate(outline.view(), cap));
    expect_linked(outline, cap);
    EXPECT_NEAR(signed_area(outline, cap), outline.area(), 1e-9);
    EXPECT_NEAR(unsigned_area(outline, cap), outline.area(), 1e-9);
}

TEST(ConstrainedTriangulator, CoversTwiceWhatIsWoundAroundTwice)
{
    Outline outline;
    outline.add(star(20, 3, 2.5));
    outline.add(star(8, 1, 1));
    CapMesh cap;
    ASSERT_TRUE(make_constrained_triangulator()->triangulate(outline.view(), cap));
    expect_linked(outline, cap);
    EXPECT_NEAR(signed_area(outline, cap), outline.area(), 1e-9);
}

TEST(ConstrainedTriangulator, LetsLoopsTouchInPointsAndEdges)
{
    Outline outline;
    outline.add({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
    outline.add({{1, 1}, {2, 1}, {2, 2}, {1, 2}});  // touches in a corner
    outline.add({{1, 0}, {2, 0}, {2, 1}, {1, 1}});  // touches in two edges
    CapMesh cap;
    ASSERT_TRUE(make_constrained_triangulator()->triangulate(outline.view(), cap));
    expect_linked(outline, cap);
    EXPECT_NEAR(unsigned_area(outline, cap), 3.0, 1e-12);
    for (const Index i : {1u, 2u, 4u, 8u, 11u})  // corners (1, 0) and (1, 1)
        EXPECT_EQ(std::count(cap.shared_points.begin(), cap.shared_points.end(), i) > 0, true) << i;
}

TEST(ConstrainedTriangulator, RefusesLoopsThatCrossOrRunThroughAPoint)
{
    CapMesh cap;
    Outline crossing, through;
    crossing.add({{0, 0}, {2, 2}, {2, 0}, {0, 2}});
    through.add({{0, 0}, {4, 0}, {4, 4}, {0, 4}});
    through.add({{2, 0}, {3, 1}, {2, 2}, {1, 1}});
    const auto triangulator = make_constrained_triangulator();
    EXPECT_FALSE(triangulator->triangulate(crossing.view(), cap));
    EXPECT_FALSE(triangulator->triangulate(through.view(), cap));
    // And is fit for use afterwards.
    Outline good;
    good.add(star(10, 2, 1));
    ASSERT_TRUE(triangulator->triangulate(good.view(), cap));
    EXPECT_NEAR(unsigned_area(good, cap), good.area(), 1e-12);
}

std::vector<glm::dvec2> polygon(std::size_t points, glm::dvec2 (*at)(double))
{
    std::vector<glm::dvec2> loop;
    for (std::size_t i = 0; i < points; ++i) {
        const glm::dvec2 p(glm::vec2(at(double(i) / double(points))));
        if (loop.empty() || loop.back() != p) loop.push_back(p);
    }
    return loop;
}

double power_of_two(double share)
{
    return std::exp2(-80 * share);
}

TEST(ConstrainedTriangulator, TakesAFewStepsForEachPointWhereverPointsCluster)
{
    constexpr std::size_t kPoints = 16'000;
    constexpr double kTurn = 2 * std::numbers::pi;
    const std::vector<std::pair<std::string, std::vector<glm::dvec2>>> loops{
        // Half of the points as good as in one place, on a line, the others on an arc around them.
        {"beside a tip", polygon(kPoints,
                                 [](double t) {
                                     if (t < 0.5) return glm::dvec2(1, (0.5 - t) * 0x1p-53);
                                     const double angle = 0.45 * kTurn * (2 * t - 1.5);
                                     return glm::dvec2(1 - std::cos(angle), std::sin(angle));
                                 })},
        {"around a centre", polygon(kPoints,
                                    [](double t) {
                                        const double angle = kTurn * (t < 0.5 ? 0.8 * t - 0.2 : 0.6 - 0.8 * t);
                                        const double r = t < 0.5 ? 1 : 1e-17;
                                        return glm::dvec2(r * std::cos(angle), r * std::sin(angle));
                                    })},
        {"in line", polygon(kPoints, [](double t) { return t == 0 ? glm::dvec2(0.5, 0.7) : glm::dvec2(1 - t, 0); })},
        {"teeth that shrink", polygon(kPoints,
                                      [](double t) {
                                          const auto i = static_cast<std::size_t>(std::round(t * kPoints));
                                          if (i < 2) return glm::dvec2(double(i), -1);
                                          const std::size_t pair = i / 2;
                                          return glm::dvec2(power_of_two(double(pair - 1) * 2 / kPoints),
                                                            (i - 1) / 2 % 2);
                                      })},
        {"steps to a corner", polygon(kPoints,
                                      [](double t) {
                                          const auto i = static_cast<std::size_t>(std::round(t * kPoints));
                                          if (i == 0) return glm::dvec2(1, 0);
                                          const std::size_t across = i / 2, up = (i - 1) / 2;
                                          return glm::dvec2(power_of_two(double(across) * 2 / kPoints),
                                                            power_of_two(double(up) * 2 / kPoints));
                                      })},
        {"spiral to a point", polygon(kPoints,
                                      [](double t) {
                                          const double s = t < 0.5 ? 2 * t : 2 - 2 * t;
                                          const double r = (t < 0.5 ? 1 : 0.6) * power_of_two(s);
                                          return glm::dvec2(r * std::cos(60 * kTurn * s), r * std::sin(60 * kTurn * s));
                                      })},
        {"small clusters", polygon(kPoints,
                                   [](double t) {
                                       const double cluster = std::floor(30 * t);
                                       const double angle = kTurn * (cluster + 1e-4 * (30 * t - cluster)) / 30;
                                       return glm::dvec2(std::cos(angle), std::sin(angle));
                                   })},
    };
    for (const auto& [name, loop] : loops) {
        Outline outline;
        outline.add(loop);
        CapMesh cap;
        ASSERT_TRUE(make_constrained_triangulator()->triangulate(outline.view(), cap)) << name;
        expect_linked(outline, cap);
        EXPECT_NEAR(unsigned_area(outline, cap), std::abs(outline.area()), 1e-9) << name;
        EXPECT_LE(cap.steps, 200 * loop.size()) << name;
        EXPECT_GT(loop.size(), 3'000) << name;
    }
}

TEST(UntanglingTriangulator, LetsLoopsRunThroughPointsOfOthers)
{
    Outline outline;
    outline.add({{0, 0}, {4, 0}, {4, 4}, {0, 4}});
    outline.add(reversed({{2, 0}, {3, 1}, {2, 2}, {1, 1}}));  // a hole that touches the lower edge
    outline.add({{4, 1}, {6, 1}, {6, 2}, {4, 2}});            // lies against the right edge
    CapMesh cap;
    ASSERT_FALSE(make_constrained_triangulator()->triangulate(outline.view(), cap));
    ASSERT_TRUE(make_untangling()->triangulate(outline.view(), cap));
    expect_linked(outline, cap);
    EXPECT_NEAR(unsigned_area(outline, cap), 16.0 - 2.0 + 2.0, 1e-12);
}

TEST(UntanglingTriangulator, CancelsSpikesAndEdgesThatRunForthAndBack)
{
    Outline outline;
    // A spike out of the corner (2, 0) that comes back a part of its way, and one inward that is two edges long.
    outline.add({{0, 0}, {5, 0}, {2, 0}, {2, 1}, {1, 1}, {0.5, 1}, {1, 1}, {2, 1}, {2, 2}, {0, 2}});
    CapMesh cap;
    ASSERT_TRUE(make_untangling()->triangulate(outline.view(), cap));
    expect_linked(outline, cap);
    EXPECT_NEAR(unsigned_area(outline, cap), 4.0, 1e-12);
}

TEST(UntanglingTriangulator, SetsPointsApartThatDifferOnlyAlongTheDroppedAxis)
{
    // Two squares that touch in a corner which rounding has put at two heights.
    Outline outline;
    outline.add({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
    outline.add({{1, 1}, {2, 1}, {2, 2}, {1, 2}});
    outline.positions[4].z = std::nextafter(0.0f, 1.0f);
    CapMesh cap;
    ASSERT_FALSE(make_constrained_triangulator()->triangulate(outline.view(), cap));
    ASSERT_TRUE(make_untangling()->triangulate(outline.view(), cap));
    expect_linked(outline, cap);
    EXPECT_NEAR(unsigned_area(outline, cap), 2.0, 1e-12);
    for (const CapTriangle& t : cap.triangles)
        for (const Index corner : t.corner) EXPECT_EQ(corner == 4, outline.positions[corner].z != 0.0f);
}

/// Combs whose teeth meet those of the next one in points, in edges and across, shaken by a unit in the last place.
TEST(UntanglingTriangulator, CoversWhatRoundingHasLedAcrossItself)
{
    test::Random random(5);
    std::size_t refused_without = 0;
    for (int run = 0; run < 200; ++run) {
        const double angle = 2 * std::numbers::pi * random.uniform();
        const auto turned = [&](double x, double y) {
            const auto shaken = [&](double v) {
                const auto rounded = static_cast<float>(v);
                return double(std::nextafter(rounded, random.uniform() < 0.5 ? -10.0f : 10.0f));
            };
            return glm::dvec2(shaken(std::cos(angle) * x - std::sin(angle) * y),
                              shaken(std::sin(angle) * x + std::cos(angle) * y));
        };
        const int teeth = 3 + static_cast<int>(random.below(20));
        Outline outline;
        std::vector<glm::dvec2> comb, other;
        comb.push_back(turned(0, 0));
        for (int i = 0; i <= teeth; ++i) {
            comb.push_back(turned(i, 2 + random.below(2)));  // some tips lie in the other comb's back
            if (i < teeth) comb.push_back(turned(i + 0.5, 1));
        }
        comb.push_back(turned(teeth, 0));
        std::reverse(comb.begin(), comb.end());
        outline.add(comb);
        outline.add({turned(-1, 3), turned(teeth + 1, 3), turned(teeth + 1, 4), turned(-1, 4)});
        CapMesh cap;
        refused_without += make_constrained_triangulator()->triangulate(outline.view(), cap) ? 0 : 1;
        ASSERT_TRUE(make_untangling()->triangulate(outline.view(), cap));
        expect_linked(outline, cap);
        EXPECT_NEAR(signed_area(outline, cap), outline.area(), 1e-9);
        // A unit in the last place of 20 over the length of the back.
        EXPECT_NEAR(unsigned_area(outline, cap), outline.area(), 2e-6 * teeth);
        for (const CapTriangle& t : cap.triangles)
            for (std::size_t i = 0; i < 3; ++i)
                EXPECT_NE(outline.positions[t.corner[i]], outline.positions[t.corner[(i + 1) % 3]]);
    }
    EXPECT_GT(refused_without, 100u);
}

TEST(UntanglingTriangulator, CoversOutlinesThatCrossInEarnestAsOftenAsTheyWind)
{
    test::Random random(2);
    for (int n = 3; n < 60; ++n) {
        std::vector<glm::dvec2> loop;
        while (loop.size() < std::size_t(n)) loop.emplace_back(float(random.uniform()), float(random.uniform()));
        Outline outline;
        outline.add(loop);
        CapMesh cap;
        ASSERT_TRUE(make_untangling()->triangulate(outline.view(), cap));
        expect_linked(outline, cap);
        EXPECT_NEAR(signed_area(outline, cap), outline.area(), 1e-9);
        const SectionLoop wound{outline.positions, true};
        EXPECT_NEAR(unsigned_area(outline, cap), referee::wound_area({&wound, 1}, {0, 0, 1}), 1e-6 * n);
    }
}

TEST(UntanglingTriangulator, AddsNoPointWhereLoopsOnlyTouch)
{
    Outline outline;
    outline.add({{0, 0}, {4, 0}, {4, 4}, {0, 4}});
    outline.add(reversed({{2, 0}, {3, 1}, {2, 2}, {1, 1}}));
    outline.add({{4, 1}, {6, 1}, {6, 2}, {4, 2}});
    CapMesh cap;
    ASSERT_TRUE(make_untangling()->triangulate(outline.view(), cap));
    EXPECT_TRUE(cap.crossing_points.empty());
}

TEST(UntanglingTriangulator, AddsOnePointWhereSeveralEdgesCrossInOne)
{
    // Three bars through the origin.
    Outline outline;
    outline.add({{-4, -4}, {4, 4}, {4, 5}, {-4, -3}});
    outline.add({{-4, 4}, {4, -4}, {4, -3}, {-4, 5}});
    outline.add({{-4, 0}, {4, 0}, {4, 1}, {-4, 1}});
    CapMesh cap;
    ASSERT_TRUE(make_untangling()->triangulate(outline.view(), cap));
    expect_linked(outline, cap);
    EXPECT_NEAR(unsigned_area(outline, cap), outline.area(), 1e-5);
    EXPECT_NEAR(signed_area(outline, cap), outline.area(), 1e-9);
    const auto at_origin = [](const CrossingPoint& p) { return p.position == glm::vec3(0.0f); };
    EXPECT_EQ(std::count_if(cap.crossing_points.begin(), cap.crossing_points.end(), at_origin), 1);
}

TEST(UntanglingTriangulator, SeesAFoldOfACornerThatADifferenceInDoubleDoesNot)
{
    // As a section of a scanned man had it: alone, and with a hole.
    const double fold = 1.62488128e-20f;
    const std::vector<glm::dvec2> corner{
        {0.125f, 0},  {0.1348581165f, fold}, {0.1348581165f, 0}, {0.1330788136f, 0.00131935824f},
        {0.1f, 0.1f}, {0.02f, 0.1f},         {0.05f, 0.05f},     {0, 0}};
    Outline outline;
    outline.add(corner);
    for (const bool with_hole : {false, true}) {
        if (with_hole) outline.add(reversed({{0.07f, 0.03f}, {0.08f, 0.03f}, {0.08f, 0.04f}, {0.07f, 0.04f}}));
        CapMesh cap;
        ASSERT_FALSE(make_constrained_triangulator()->triangulate(outline.view(), cap));
        ASSERT_TRUE(make_untangling()->triangulate(outline.view(), cap));
        expect_linked(outline, cap);
        EXPECT_NEAR(signed_area(outline, cap), outline.area(), 1e-15);
        EXPECT_NEAR(unsigned_area(outline, cap), outline.area(), 1e-15);
    }
}

TEST(TopologicalTriangulator, ClosesAnythingWithTheRightSignedArea)
{
    test::Random random(1);
    for (int n = 3; n < 60; ++n) {
        std::vector<glm::dvec2> loop;
        // On a coarse grid, so that points fall together; consecutive ones never do.
        while (loop.size() < std::size_t(n)) {
            const glm::dvec2 p(random.below(4), random.below(4));
            if (!loop.empty() && (loop.back() == p || (loop.size() + 1 == std::size_t(n) && loop.front() == p)))
                continue;
            loop.push_back(p);
        }
        Outline outline;
        outline.add(loop);
        CapMesh cap;
        ASSERT_TRUE(make_topological_triangulator()->triangulate(outline.view(), cap));
        expect_linked(outline, cap);
        EXPECT_NEAR(signed_area(outline, cap), outline.area(), 1e-9);
        for (const CapTriangle& t : cap.triangles)
            for (std::size_t i = 0; i < 3; ++i)
                EXPECT_NE(outline.points[t.corner[i]], outline.points[t.corner[(i + 1) % 3]]);
    }
}

}  // namespace
}  // namespace kerf::core
