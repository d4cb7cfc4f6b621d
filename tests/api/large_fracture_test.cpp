// Objects that are so large that the half-edge back end hands subtrees over: their pieces are those of any other.

#include <kerf/fracture.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "api/fracture_referee.h"
#include "api/objects.h"
#include "support/brief.h"

namespace kerf {
namespace {

/// Subtrees are handed over from 20 000 triangles on.
constexpr std::uint64_t kLarge = 25'000;

class LargeFractureTest : public testing::TestWithParam<std::string>
{
};
INSTANTIATE_TEST_SUITE_P(All, LargeFractureTest, testing::ValuesIn(test::back_end_names()),
                         [](const auto& param) { return param.param; });

bool is_half_edge(const std::string& back_end)
{
    return back_end == "halfedge";
}

/// A triangle of a piece with all that its corners have, and its material and source.
using Corner = std::array<float, 11>;
struct Whole
{
    std::array<Corner, 3> corners;
    std::uint32_t material, source;

    auto operator<=>(const Whole&) const = default;
};

std::vector<Whole> surface_of(const Object& piece)
{
    const Mesh mesh = *piece.mesh();
    const MeshArrays arrays = mesh.arrays();
    const Stream colours = mesh.stream_count() > 0 ? mesh.stream(0) : Stream();
    std::vector<Whole> surface;
    for (std::size_t t = 0; t < arrays.kinds.size(); ++t) {
        if (arrays.kinds[t] == TriangleKind::cap) continue;
        Whole whole{{}, arrays.triangle_materials[t], arrays.sources[t]};
        for (std::size_t c = 0; c < 3; ++c) {
            const std::size_t v = arrays.indices[3 * t + c];
            const Vec3f &p = arrays.positions[v], &n = arrays.normals[v];
            whole.corners[c] = {p.x, p.y, p.z, n.x, n.y, n.z, arrays.uvs[v].x, arrays.uvs[v].y};
            for (std::size_t i = 0; i < colours.width && !colours.values.empty(); ++i)
                whole.corners[c][8 + i] = colours.values[colours.width * v + i];
        }
        std::rotate(whole.corners.begin(), std::ranges::min_element(whole.corners), whole.corners.end());
        surface.push_back(whole);
    }
    std::ranges::sort(surface);
    return surface;
}

std::vector<std::vector<Whole>> surfaces_of(Fracture& fracture)
{
    std::vector<std::vector<Whole>> surfaces;
    for (std::size_t i = 0; const Object* const piece = fracture.piece(i); ++i) surfaces.push_back(surface_of(*piece));
    std::ranges::sort(surfaces);
    return surfaces;
}

/// The position of each vertex as its colour, and two materials in stripes.
Mesh coloured(const Mesh& plain)
{
    const MeshArrays arrays = plain.arrays();
    std::vector<std::uint32_t> materials;
    for (std::size_t t = 0; t < arrays.kinds.size(); ++t) materials.push_back(t / 700 % 2);
    const std::array<Material, 2> named{Material{.name = "moss"}, Material{.name = "stone"}};
    StreamInput stream;
    stream.name = "place";
    stream.width = 3;
    stream.values = &arrays.positions[0].x;
    MeshInput input;
    input.positions = &arrays.positions[0].x;
    input.vertex_count = arrays.positions.size();
    input.indices = arrays.indices.data();
    input.triangle_count = arrays.kinds.size();
    input.normals = &arrays.normals[0].x;
    input.uvs = &arrays.uvs[0].x;
    input.triangle_materials = materials.data();
    input.materials = named;
    input.streams = std::span(&stream, 1);
    return *Mesh::make(input);
}

TEST_P(LargeFractureTest, PiecesFillTheObjectAndFitTogether)
{
    for (const char* name : {"sphere_in_sphere", "asteroid", "torus", "menger_sponge"}) {
        const Object whole = test::object_of(test::shape(name, kLarge), GetParam());
        for (const FracturePattern pattern :
             {FracturePattern::uniform, FracturePattern::impact, FracturePattern::grid}) {
            SCOPED_TRACE(std::string(name) + ", pattern " + std::to_string(int(pattern)));
            FractureOptions options;
            options.pattern = pattern;
            options.cells = 30;
            options.seed = 5;
            Fracture fracture = kerf::fracture(whole, options);
            test::expect_right(whole, fracture);
            if (HasFailure() || test::kBrief) return;
        }
    }
}

TEST(LargeFracture, BackEndsGiveTheSameSurfacesWithAllTheirAttributes)
{
    for (const char* name : {"asteroid", "sphere_in_sphere"}) {
        const Mesh mesh = coloured(test::shape(name, kLarge));
        for (const std::uint32_t cells : {3u, 40u}) {
            std::vector<std::vector<std::vector<Whole>>> found;
            for (const std::string& back_end : test::back_end_names()) {
                FractureOptions options;
                options.cells = cells;
                Fracture fracture = kerf::fracture(test::object_of(mesh, back_end), options);
                ASSERT_EQ(fracture.status(), Status::done);
                found.push_back(surfaces_of(fracture));
                EXPECT_TRUE(found.back() == found.front()) << name << ", " << cells << ", " << back_end;
            }
        }
    }
}

TEST(LargeFracture, BackEndsAgreeOnWhatMissesAPiece)
{
    std::vector<std::vector<Status>> found;
    for (const std::string& back_end : test::back_end_names()) {
        const Object whole = test::object_of(test::shape("asteroid", kLarge), back_end);
        FractureOptions options;
        options.cells = 8;
        Fracture fracture = kerf::fracture(whole, options);
        std::vector<Status>& statuses = found.emplace_back();
        for (std::size_t i = 0; Object* const piece = fracture.piece(i); ++i) {
            // Some units in the last place of the whole's coordinates before the end of the piece.
            const double end = double(piece->bounds().hi.x);
            for (int step = 12; step >= 0; --step) {
                const Plane plane = test::plane_at(end - 0x1p-24 * step, 0, 0, 1, 0, 0);
                statuses.push_back(kerf::cut(*piece->clone(), plane).status);
            }
        }
        EXPECT_EQ(found.back(), found.front()) << back_end;
        EXPECT_NE(std::ranges::find(statuses, Status::missed), statuses.end());
    }
}

TEST_P(LargeFractureTest, InsidesHaveTheColourOfTheSurfaceWhereTheyMeetIt)
{
    const Object whole = test::object_of(coloured(test::shape("asteroid", kLarge)), GetParam());
    FractureOptions options;
    options.cells = 12;
    Fracture fracture = kerf::fracture(whole, options);
    ASSERT_EQ(fracture.status(), Status::done);
    for (std::size_t i = 0; const Object* const piece = fracture.piece(i); ++i) {
        const Mesh mesh = *piece->mesh();
        const MeshArrays arrays = mesh.arrays();
        const Stream places = mesh.stream(0);
        std::map<test::Place, bool> is_on_surface;
        for (std::size_t t = 0; t < arrays.kinds.size(); ++t)
            for (std::size_t c = 0; c < 3; ++c) {
                const Vec3f& p = arrays.positions[arrays.indices[3 * t + c]];
                is_on_surface[{p.x, p.y, p.z}] |= arrays.kinds[t] == TriangleKind::surface;
            }
        for (std::size_t v = 0; v < arrays.positions.size(); ++v) {
            const Vec3f& p = arrays.positions[v];
            const test::Place place{p.x, p.y, p.z};
            if (!is_on_surface[place]) continue;
            for (std::size_t axis = 0; axis < 3; ++axis) EXPECT_NEAR(places.values[3 * v + axis], place[axis], 1e-5f);
        }
        EXPECT_STREQ(piece->material(0).name, "moss");
        EXPECT_STREQ(piece->material(2).name, "cap");
    }
}

TEST_P(LargeFractureTest, SmallPiecesAreJoinedToTheirNeighbours)
{
    const Object whole = test::object_of(test::shape("asteroid", kLarge), GetParam());
    FractureOptions options;
    options.cells = 60;
    options.pattern = FracturePattern::impact;
    Fracture many = kerf::fracture(whole, options);
    options.least_volume = whole.mass_properties().volume / 50.0;
    Fracture few = kerf::fracture(whole, options);
    test::expect_right(whole, few);
    EXPECT_LT(few.count(), many.count());
    for (std::size_t i = 0; const Object* const piece = few.piece(i); ++i)
        EXPECT_GE(piece->mass_properties().volume, options.least_volume);
    Fracture other = kerf::fracture(test::object_of(test::shape("asteroid", kLarge), "linear"), options);
    EXPECT_TRUE(surfaces_of(few) == surfaces_of(other));
}

TEST_P(LargeFractureTest, PiecesShareBuffersWithOneAnotherAtMost)
{
    const Object whole = test::object_of(test::shape("asteroid", kLarge), GetParam());
    const std::string before = test::bytes_of(*whole.mesh());
    FractureOptions options;
    options.cells = 10;
    Fracture fracture = kerf::fracture(whole, options);
    ASSERT_EQ(fracture.status(), Status::done);
    ASSERT_GT(fracture.count(), 1u);
    for (std::size_t i = 0; Object* const piece = fracture.piece(i); ++i) {
        EXPECT_FALSE(piece->shares_buffers_with(whole));
        EXPECT_EQ(piece->shares_buffers_with(*fracture.piece((i + 1) % fracture.count())), is_half_edge(GetParam()));
    }
    Object& first = *fracture.piece(0);
    const std::string piece = test::bytes_of(*first.mesh());
    EXPECT_EQ(first.detach(), Status::done);
    EXPECT_FALSE(first.shares_buffers_with(*fracture.piece(1)));
    EXPECT_EQ(test::bytes_of(*first.mesh()), piece);
    EXPECT_EQ(test::bytes_of(*whole.mesh()), before) << "it stays as it is";
}

TEST_P(LargeFractureTest, PiecesCanBeCutAndBrokenAgain)
{
    const Object whole = test::object_of(test::shape("asteroid", 4 * kLarge), GetParam());
    FractureOptions options;
    options.cells = 3;
    Fracture first = kerf::fracture(whole, options);
    ASSERT_EQ(first.status(), Status::done);
    for (std::size_t i = 0; Object* const piece = first.piece(i); ++i) {
        options.seed = i;
        options.cells = 10;
        Fracture second = kerf::fracture(*piece, options);
        test::expect_full(*piece, second);
        const Box box = piece->bounds();
        const Point middle(0.5 * (box.lo.x + box.hi.x), 0.5 * (box.lo.y + box.hi.y), 0.5 * (box.lo.z + box.hi.z));
        const double volume = piece->mass_properties().volume;
        Cut cut = kerf::cut(std::move(*piece), *Plane::at(middle, Normal(1, 2, 3)));
        ASSERT_EQ(cut.status, Status::done);
        double sum = 0.0;
        for (const Side side : {Side::positive, Side::negative})
            for (std::size_t h = 0; const Object* const half = cut.piece(side, h); ++h) {
                sum += half->mass_properties().volume;
                EXPECT_TRUE(test::Triangles(*half).closed);
            }
        EXPECT_NEAR(sum, volume, 1e-6 * volume);
        if (test::kBrief) return;
    }
}

TEST_P(LargeFractureTest, TheSameSeedGivesTheSameBytes)
{
    const Object whole = test::object_of(test::shape("torus", kLarge), GetParam());
    const auto bytes = [&] {
        FractureOptions options;
        options.cells = 25;
        Fracture fracture = kerf::fracture(whole, options);
        std::string all;
        for (std::size_t i = 0; const Object* const piece = fracture.piece(i); ++i)
            all += test::bytes_of(*piece->mesh());
        return all;
    };
    EXPECT_TRUE(bytes() == bytes());
}

TEST_P(LargeFractureTest, CanBeStoppedAtAnyTime)
{
    const Object whole = test::object_of(test::shape("asteroid", kLarge), GetParam());
    for (const double stop : {0.05, 0.2, 0.3, 0.45, 0.8}) {
        double until = stop;
        FractureOptions options;
        options.cells = 10;
        options.user = &until;
        options.progress = [](void* user, double share) { return share < *static_cast<const double*>(user); };
        EXPECT_EQ(kerf::fracture(whole, options).status(), Status::cancelled) << stop;
    }
    EXPECT_EQ(whole.mass_properties().is_of_solid, true);
}

TEST_P(LargeFractureTest, SaysHowFarItIsAllTheTime)
{
    std::vector<double> shares;
    FractureOptions options;
    options.cells = 100;
    options.user = &shares;
    options.progress = [](void* user, double share) {
        static_cast<std::vector<double>*>(user)->push_back(share);
        return true;
    };
    Fracture fracture = kerf::fracture(test::object_of(test::shape("asteroid", kLarge), GetParam()), options);
    ASSERT_EQ(fracture.status(), Status::done);
    EXPECT_TRUE(std::ranges::is_sorted(shares));
    constexpr double kMostBetween = 0.21;
    for (std::size_t i = 1; i < shares.size(); ++i) EXPECT_LE(shares[i] - shares[i - 1], kMostBetween) << shares[i];
}

}  // namespace
}  // namespace kerf
