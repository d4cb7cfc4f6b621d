#include <kerf/fracture.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <vector>

#include "api/fracture_referee.h"
#include "api/objects.h"
#include "support/brief.h"

namespace kerf {
namespace {

using test::Corners;
using test::expect_right;
using test::Triangles;

std::uint64_t hash_of(Fracture& fracture)
{
    std::uint64_t hash = 0xcbf29ce484222325u;
    const auto add = [&](const void* data, std::size_t bytes) {
        for (std::size_t i = 0; i < bytes; ++i)
            hash = (hash ^ static_cast<const unsigned char*>(data)[i]) * 0x100000001b3u;
    };
    for (std::size_t i = 0; Object* const piece = fracture.piece(i); ++i) {
        const Mesh mesh = *piece->mesh();
        const MeshArrays& arrays = mesh.arrays();
        add(arrays.positions.data(), arrays.positions.size_bytes());
        add(arrays.normals.data(), arrays.normals.size_bytes());
        add(arrays.indices.data(), arrays.indices.size_bytes());
    }
    for (const FractureBond& bond : fracture.bonds()) add(&bond.area, sizeof bond.area);
    return hash;
}

class FractureTest : public testing::TestWithParam<std::string>
{
};
INSTANTIATE_TEST_SUITE_P(All, FractureTest, testing::ValuesIn(test::back_end_names()),
                         [](const auto& param) { return param.param; });

constexpr FracturePattern kPatterns[]{FracturePattern::uniform, FracturePattern::impact, FracturePattern::crack,
                                      FracturePattern::grid, FracturePattern::splinters};

TEST_P(FractureTest, PiecesFillTheObjectAndFitTogether)
{
    constexpr std::uint64_t kTriangles = test::kBrief ? 700 : 2000;
    for (const char* name : {"asteroid", "torus", "menger_sponge", "sphere_in_sphere", "two_legs", "comb"}) {
        const Object whole = test::object_of(test::shape(name, kTriangles), GetParam());
        for (const FracturePattern pattern : kPatterns) {
            SCOPED_TRACE(std::string(name) + ", pattern " + std::to_string(int(pattern)));
            FractureOptions options;
            options.pattern = pattern;
            options.cells = 20;
            options.seed = 3;
            Fracture fracture = kerf::fracture(whole, options);
            expect_right(whole, fracture);
            if (HasFatalFailure()) return;
            EXPECT_GE(fracture.count(), 12u);
            EXPECT_EQ(std::string(fracture.piece(0)->back_end_name()), GetParam());
        }
    }
}

TEST_P(FractureTest, TheSameSeedGivesTheSameBytes)
{
    const Object whole = test::object_of(test::shape("asteroid", 3000), GetParam());
    FractureOptions options;
    options.cells = 30;
    options.seed = 11;
    Fracture first = kerf::fracture(whole, options), second = kerf::fracture(whole, options);
    EXPECT_EQ(hash_of(first), hash_of(second));
    options.pattern = static_cast<FracturePattern>(200);
    Fracture unknown = kerf::fracture(whole, options);
    EXPECT_EQ(hash_of(first), hash_of(unknown)) << "a number that is no pattern is uniform";
    options.pattern = FracturePattern::uniform;
    options.seed = 12;
    Fracture other = kerf::fracture(whole, options);
    EXPECT_NE(hash_of(first), hash_of(other));
}

TEST(Fracture, BackEndsGiveTheSameSurfaces)
{
    const auto names = test::back_end_names();
    for (const char* name : {"asteroid", "menger_sponge"}) {
        std::vector<std::vector<std::vector<Corners>>> found;
        for (const std::string& back_end : names) {
            const Object whole = test::object_of(test::shape(name, 3000), back_end);
            FractureOptions options;
            options.cells = 40;
            options.pattern = FracturePattern::impact;
            Fracture fracture = kerf::fracture(whole, options);
            ASSERT_EQ(fracture.status(), Status::done);
            std::vector<std::vector<Corners>>& pieces = found.emplace_back();
            for (std::size_t i = 0; Object* const piece = fracture.piece(i); ++i) {
                std::vector<Corners> surface = Triangles(*piece).surface;
                std::ranges::sort(surface);
                pieces.push_back(std::move(surface));
            }
            std::ranges::sort(pieces);
        }
        for (std::size_t i = 1; i < names.size(); ++i) EXPECT_EQ(found[i], found[0]) << name << ", " << names[i];
    }
}

TEST_P(FractureTest, SmallPiecesAreJoinedToTheirNeighbours)
{
    const Object whole = test::object_of(test::shape("asteroid", 2000), GetParam());
    FractureOptions options;
    options.cells = 60;
    options.pattern = FracturePattern::impact;
    Fracture many = kerf::fracture(whole, options);
    options.least_volume = whole.mass_properties().volume / 50.0;
    Fracture few = kerf::fracture(whole, options);
    expect_right(whole, few);
    EXPECT_LT(few.count(), many.count());
    std::size_t cells = 0;
    for (std::size_t i = 0; Object* const piece = few.piece(i); ++i) {
        EXPECT_GE(piece->mass_properties().volume, options.least_volume);
        cells += few.cells(i).size();
    }
    EXPECT_EQ(cells, many.count());
}

TEST_P(FractureTest, SitesMakeTheCells)
{
    // The eight corners of a lattice: cells are cubes, and four of them meet along each axis.
    std::vector<Vec3d> sites;
    for (int i = 0; i < 8; ++i) sites.emplace_back((i & 1) - 0.5, (i >> 1 & 1) - 0.5, (i >> 2 & 1) - 0.5);
    const Object whole = test::cube(GetParam());
    FractureOptions options;
    options.sites = sites;
    Fracture fracture = kerf::fracture(whole, options);
    expect_right(whole, fracture);
    ASSERT_EQ(fracture.count(), 8u);
    ASSERT_EQ(fracture.sites().size(), 8u);
    for (std::uint32_t i = 0; i < 8; ++i) {
        EXPECT_NEAR(fracture.piece(i)->mass_properties().volume, 1.0, 1e-4);
        EXPECT_EQ(std::vector(fracture.cells(i).begin(), fracture.cells(i).end()), std::vector{i});
        EXPECT_NEAR(fracture.sites()[i].x, sites[i].x, 1e-4);
    }
    double large = 0.0;
    for (const FractureBond& bond : fracture.bonds())
        if (bond.area > 0.9) ++large;
    EXPECT_EQ(large, 12.0);
}

TEST_P(FractureTest, ConnectedPartsOfACellAreDifferentPieces)
{
    // One cell around both legs, one above.
    const Object whole = test::object_of(test::shape("two_legs", 100), GetParam());
    const Box box = whole.bounds();
    const double x = 0.5 * (double(box.lo.x) + double(box.hi.x)), y = 0.5 * (double(box.lo.y) + double(box.hi.y));
    const double z = double(box.lo.z), height = double(box.hi.z) - z;
    const std::vector<Vec3d> sites{{x, y, z - height}, {x, y, z + 1.5 * height}};
    FractureOptions options;
    options.sites = sites;
    Fracture fracture = kerf::fracture(whole, options);
    expect_right(whole, fracture);
    EXPECT_EQ(fracture.count(), 3u);
    EXPECT_EQ(fracture.bonds().size(), 2u);
}

TEST_P(FractureTest, InsidesHaveTheirMaterialAndUvThatRunOn)
{
    const Object whole = test::object_of(test::shape("asteroid", 2000), GetParam());
    FractureOptions options;
    options.cells = 12;
    options.uv_scale = 0.5;
    Fracture fracture = kerf::fracture(whole, options);
    ASSERT_EQ(fracture.status(), Status::done);
    for (std::size_t i = 0; Object* const piece = fracture.piece(i); ++i) {
        const Mesh mesh = *piece->mesh();
        const MeshArrays& arrays = mesh.arrays();
        for (std::size_t t = 0; t < arrays.kinds.size(); ++t) {
            if (arrays.kinds[t] != TriangleKind::cap) {
                EXPECT_NE(arrays.sources[t], kNone);
                continue;
            }
            EXPECT_EQ(arrays.sources[t], kNone);
            EXPECT_STREQ(piece->material(arrays.triangle_materials[t]).name, "cap");
            for (std::size_t c = 0; c < 3; ++c) {
                const std::uint32_t v = arrays.indices[3 * t + c];
                const Vec3f &p = arrays.positions[v], &n = arrays.normals[v];
                const float length = std::sqrt(n.x * n.x + n.y * n.y + n.z * n.z);
                EXPECT_NEAR(length, 1.0f, 1e-5f);
                // Half of two coordinates, in turn: those across the normal's longest component.
                const float a[]{p.x, p.y, p.z}, m[]{std::abs(n.x), std::abs(n.y), std::abs(n.z)};
                const std::size_t axis = std::size_t(std::max_element(m, m + 3) - m);
                EXPECT_EQ(arrays.uvs[v].x, 0.5f * a[(axis + 1) % 3]);
                EXPECT_EQ(arrays.uvs[v].y, 0.5f * a[(axis + 2) % 3]);
            }
        }
    }
}

TEST_P(FractureTest, PiecesCanBeCutAndBrokenAgain)
{
    const Object whole = test::object_of(test::shape("asteroid", 2000), GetParam());
    FractureOptions options;
    options.cells = 8;
    Fracture first = kerf::fracture(whole, options);
    ASSERT_EQ(first.status(), Status::done);
    for (std::size_t i = 0; Object* const piece = first.piece(i); ++i) {
        options.seed = i;
        Fracture second = kerf::fracture(*piece, options);
        test::expect_full(*piece, second);
        const Box box = piece->bounds();
        const Point middle(0.5 * (box.lo.x + box.hi.x), 0.5 * (box.lo.y + box.hi.y), 0.5 * (box.lo.z + box.hi.z));
        const Cut cut = kerf::cut(std::move(*piece), *Plane::at(middle, Normal(1, 2, 3)));
        EXPECT_EQ(cut.status, Status::done);
    }
}

TEST(Fracture, AThousandSeedsGiveRightPieces)
{
    constexpr std::uint64_t kSeeds = test::kBrief ? 50 : 1000;
    const auto back_ends = test::back_end_names();
    std::vector<Object> wholes;
    for (const char* name : {"asteroid", "torus", "menger_sponge", "sphere_in_sphere", "comb"})
        for (const std::string& back_end : back_ends)
            wholes.push_back(test::object_of(test::shape(name, 300), back_end));
    for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const Object& whole = wholes[seed % wholes.size()];
        FractureOptions options;
        options.seed = seed;
        options.pattern = kPatterns[seed / wholes.size() % std::size(kPatterns)];
        options.cells = 2 + std::uint32_t(seed % 23);
        options.direction = Normal(double(seed % 7) - 3.0, 1.0, double(seed % 5) - 2.0);
        Fracture fracture = kerf::fracture(whole, options);
        expect_right(whole, fracture);
        if (HasFailure()) return;
    }
}

/// The mesh, so far from the origin that its floats are coarse.
Mesh moved(const Mesh& mesh, float far)
{
    const MeshArrays arrays = mesh.arrays();
    std::vector<Vec3f> positions(arrays.positions.begin(), arrays.positions.end());
    for (Vec3f& p : positions) p = {p.x + far, p.y + far, p.z + far};
    MeshInput input;
    input.positions = &positions[0].x;
    input.vertex_count = positions.size();
    input.indices = arrays.indices.data();
    input.triangle_count = arrays.indices.size() / 3;
    return *Mesh::make(input);
}

// Borders and contacts collapse there: outlines have edges of no length, and cross themselves.
TEST_P(FractureTest, CoarseCoordinatesGiveClosedPiecesOrARefusal)
{
    std::size_t broken = 0;
    for (const std::uint64_t triangles : {500u, 30'000u}) {
        if (test::kBrief && triangles > 500) break;
        const Mesh mesh = test::shape("asteroid", triangles);
        for (const float far : {3e4f, 1e5f, 3e5f, 1e6f, 1e7f})
            for (std::uint64_t seed = 0; seed < (test::kBrief || triangles > 500 ? 2u : 4u); ++seed) {
                SCOPED_TRACE(std::to_string(triangles) + " at " + std::to_string(far) + ", seed " +
                             std::to_string(seed));
                const Object whole = test::object_of(moved(mesh, far), GetParam());
                FractureOptions options;
                options.cells = 64;
                options.seed = seed;
                Fracture fracture = kerf::fracture(whole, options);
                if (!ok(fracture.status())) {
                    EXPECT_EQ(fracture.status(), Status::invalid_mesh);
                    EXPECT_STRNE(fracture.reason(), "");
                    continue;
                }
                ++broken;
                for (std::size_t i = 0; const Object* const piece = fracture.piece(i); ++i)
                    EXPECT_TRUE(piece->mass_properties().is_of_solid) << "piece " << i;
            }
    }
    EXPECT_GE(broken, test::kBrief ? 5u : 8u) << "many can be broken";
}

TEST(Fracture, RefusesWhatCannotBeBroken)
{
    Fracture none = kerf::fracture(Object());
    EXPECT_EQ(none.status(), Status::invalid_argument);
    EXPECT_EQ(none.count(), 0u);
    EXPECT_EQ(none.piece(0), nullptr);
    EXPECT_TRUE(none.cells(0).empty() && none.bonds().empty() && none.sites().empty());

    const Object whole = test::cube("linear");
    const auto refused = [&](auto change) {
        FractureOptions options;
        change(options);
        Fracture fracture = kerf::fracture(whole, options);
        EXPECT_STRNE(fracture.reason(), "");
        return fracture.status();
    };
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(refused([](FractureOptions& o) { o.cells = 0; }), Status::invalid_argument);
    EXPECT_EQ(refused([](FractureOptions& o) { o.at = Point(0, kNan, 0); }), Status::invalid_argument);
    EXPECT_EQ(refused([](FractureOptions& o) { o.direction = Normal(0, 0, 0); }), Status::invalid_argument);
    EXPECT_EQ(refused([](FractureOptions& o) { o.least_volume = -1.0; }), Status::invalid_argument);
    EXPECT_EQ(refused([](FractureOptions& o) { o.uv_scale = kNan; }), Status::invalid_argument);
    EXPECT_EQ(refused([](FractureOptions& o) { o.progress = [](void*, double share) { return share < 0.3; }; }),
              Status::cancelled);
    const std::vector<Vec3d> nowhere{{0, 0, 0}, {kNan, 0, 0}};
    EXPECT_EQ(refused([&](FractureOptions& o) { o.sites = nowhere; }), Status::invalid_argument);
    for (const double far : {1e8, 1e14, 1e155, 1e300}) {
        const std::vector<Vec3d> away{{0, 0, 0}, {0, far, 0}};
        EXPECT_EQ(refused([&](FractureOptions& o) { o.sites = away; }), Status::invalid_argument) << far;
    }
    EXPECT_EQ(whole.triangle_count(), 12u) << "it stays as it is";
}

// Places inside are looked for along a million lines at most, some for each cell.
TEST(Fracture, ManyCellsAreNoReasonToFindNoInside)
{
    const Object whole = test::cube("linear");
    for (const auto& [pattern, cells] :
         {std::pair{FracturePattern::impact, 50'000u}, {FracturePattern::uniform, 300'000u}}) {
        FractureOptions options;
        options.pattern = pattern;
        options.cells = cells;
        // Sites are there at a tenth of the work.
        options.progress = [](void*, double share) { return share < 0.09; };
        EXPECT_EQ(kerf::fracture(whole, options).status(), Status::cancelled);
    }
}

TEST(Fracture, SplintersOfALongRodAreAsManyAsAreWanted)
{
    test::Arrays rod = test::cube_arrays(0.0f, 1.0f);
    for (auto& position : rod.positions) position[0] *= 1000.0f;
    FractureOptions options;
    options.pattern = FracturePattern::splinters;
    options.direction = Normal(1, 0, 0);
    options.cells = 20;
    EXPECT_EQ(kerf::fracture(test::object_of(test::mesh_of(rod), "linear"), options).count(), 20u);
}

TEST(Fracture, AGridOfAScatteredObjectIsNoFinerThanItMustBe)
{
    test::Arrays cubes = test::two_cubes();
    for (std::size_t v = 8; v < 16; ++v)
        for (float& coordinate : cubes.positions[v]) coordinate += 100.0f;
    const Object whole = test::object_of(test::mesh_of(cubes), "linear");
    FractureOptions options;
    options.pattern = FracturePattern::grid;
    options.cells = 2;
    Fracture fracture = kerf::fracture(whole, options);
    test::expect_right(whole, fracture);
    EXPECT_EQ(fracture.count(), 2u);
    EXPECT_LT(fracture.sites().size(), 10u);
}

// The squares of their coordinates are the same.
TEST(Fracture, SitesMayBeVeryNearToOneAnother)
{
    const Object whole = test::cube("linear");
    const std::vector<Vec3d> sites{
        {0.1, 0.2, 0.3}, {0.1 + 1e-9, 0.2, 0.3}, {0.1, 0.2 + 1e-9, 0.3}, {0.1, 0.2, 0.3 - 1e-9}, {-0.4, 0.1, 0.2}};
    FractureOptions options;
    options.sites = sites;
    Fracture fracture = kerf::fracture(whole, options);
    test::expect_right(whole, fracture);
    EXPECT_EQ(fracture.count(), 5u);
}

TEST(Fracture, SaysHowFarItIs)
{
    struct Seen
    {
        std::vector<double> shares;
    } seen;
    FractureOptions options;
    options.user = &seen;
    options.progress = [](void* user, double share) {
        static_cast<Seen*>(user)->shares.push_back(share);
        return true;
    };
    Fracture fracture = kerf::fracture(test::cube("linear"), options);
    ASSERT_EQ(fracture.status(), Status::done);
    EXPECT_EQ(seen.shares.front(), 0.0);
    EXPECT_EQ(seen.shares.back(), 1.0);
    EXPECT_TRUE(std::ranges::is_sorted(seen.shares));
}

/// How many cells of a grid have a piece.
std::size_t cells_of_grid(const Object& whole, std::uint32_t wanted)
{
    FractureOptions options;
    options.pattern = FracturePattern::grid;
    options.cells = wanted;
    Fracture fracture = kerf::fracture(whole, options);
    std::set<std::uint32_t> cells;
    for (std::size_t i = 0; i < fracture.count(); ++i) cells.insert(fracture.cells(i).begin(), fracture.cells(i).end());
    return cells.size();
}

TEST(Fracture, AGridHasTheWantedCellsWhereTheyFit)
{
    const Object whole = test::cube("linear");
    for (const std::uint32_t wanted : {1u, 2u, 4u, 8u, 12u, 18u, 27u, 64u, 125u})
        EXPECT_EQ(cells_of_grid(whole, wanted), wanted);
}

TEST(Fracture, AGridHasAboutAsManyCellsAsAreWanted)
{
    for (const char* name : {"box", "asteroid", "torus", "menger_sponge", "comb", "sphere_in_sphere"}) {
        const Object whole = test::object_of(test::shape(name, 1000), "linear");
        for (const double wanted : {2.0, 3.0, 5.0, 10.0, 30.0, 100.0, 300.0})
            EXPECT_NEAR(double(cells_of_grid(whole, std::uint32_t(wanted))), wanted, std::max(1.0, 0.4 * wanted))
                << name;
    }
}

TEST(Fracture, OneCellIsTheWhole)
{
    FractureOptions options;
    options.cells = 1;
    const Object whole = test::cube("linear");
    Fracture fracture = kerf::fracture(whole, options);
    expect_right(whole, fracture);
    EXPECT_EQ(fracture.count(), 1u);
    EXPECT_TRUE(fracture.bonds().empty());
}

}  // namespace
}  // namespace kerf
