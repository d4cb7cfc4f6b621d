// What a fracture looks at grows as the borders of cells do, and the pieces are sound.

#include "halfedge/handover/handover.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "common/fracture/cell_finder.h"
#include "common/fracture/take_apart_by_subtrees.h"
#include "common/shapes/shapes.h"
#include "halfedge/consistency.h"
#include "halfedge/halfedge.h"
#include "support/fixtures.h"

namespace kerf::core::halfedge {
namespace {

std::unique_ptr<Cuttable> object_from(IndexedMesh mesh)
{
    return std::move(make_back_end()->prepare(std::move(mesh)).object);
}

/// Counts what is found.
class CountingSearch final : public TriangleSearch
{
public:
    explicit CountingSearch(const TriangleSearch& counted) : counted_(counted) {}

    Box bounds() const override { return counted_.bounds(); }
    void find(const std::function<bool(const Box&)>& is_wanted,
              const std::function<void(std::span<const Corners>)>& visit) const override
    {
        counted_.find(is_wanted, [&](std::span<const Corners> found) {
            triangles += found.size();
            visit(found);
        });
    }

    mutable std::size_t triangles = 0;

private:
    const TriangleSearch& counted_;
};

std::vector<glm::dvec3> some_sites(const TriangleSearch& object, std::uint32_t count)
{
    SitesWanted wanted;
    wanted.count = count;
    wanted.seed = 4;
    return make_sites(object, wanted);
}

struct Looked
{
    double triangles = 0.0, for_sites = 0.0, at_borders = 0.0;
};

Looked look_at(std::uint64_t triangles)
{
    const auto object = object_from(test::repaired(shapes::asteroid(triangles, 1)))->breakable();
    const CountingSearch counting(*object);
    const std::vector<glm::dvec3> sites = some_sites(counting, 12);
    const CellDiagram diagram = *make_cell_diagram(sites, object->bounds());
    CellFinder finder(diagram);
    object->divide(sites.size(), [&](const Box& box) { return finder.cell_of(box); });
    std::uint64_t whole = 0;
    for (std::uint32_t cell = 0; cell < sites.size(); ++cell) whole += object->whole_of(cell).triangles;
    EXPECT_EQ(whole + object->border().triangles.size(), object->triangle_count());
    return {double(object->triangle_count()), double(counting.triangles), double(object->border().triangles.size())};
}

TEST(Handover, LooksAtAsManyTrianglesAsBordersPass)
{
    // Of n triangles some sqrt(n) lie along a border, and lines meet as many leaves whatever n is, once there are enough.
    constexpr double kExponent = 0.56, kMoreForLines = 1.5;
    const Looked small = look_at(25'000), medium = look_at(200'000), large = look_at(800'000);
    const double decades = std::log(large.triangles / small.triangles);
    EXPECT_LE(std::log(large.at_borders / small.at_borders) / decades, kExponent);
    EXPECT_LE(large.for_sites, kMoreForLines * medium.for_sites);
    EXPECT_LT(large.at_borders + large.for_sites, 0.2 * large.triangles);
}

/// All cells that are handed over, taken apart into some.
std::vector<std::unique_ptr<Cuttable>> handed_over(const Cuttable& object, std::uint32_t cells)
{
    const auto breakable = object.breakable();
    const std::vector<glm::dvec3> sites = some_sites(*breakable, cells);
    breakable->border().materials.push_back({"cap", {}, {}});
    const InsideLook look{static_cast<std::uint32_t>(breakable->border().materials.size() - 1), 1.0};
    auto taken = take_apart_by_subtrees(*breakable, sites, 0.0, look);
    EXPECT_TRUE(taken.has_value());
    std::vector<std::unique_ptr<Cuttable>> objects;
    for (auto& made : taken->objects)
        if (made != nullptr) objects.push_back(std::move(made));
    return objects;
}

TEST(Handover, PiecesAndTheirHalvesAreSound)
{
    for (const char* name : {"asteroid", "torus", "sphere_in_sphere"}) {
        const auto object = object_from(test::repaired(*shapes::make(name, 25'000, 1)));
        for (const std::uint32_t cells : {12u, 60u, 300u}) {
            SCOPED_TRACE(std::string(name) + ", " + std::to_string(cells));
            auto pieces = handed_over(*object, cells);
            EXPECT_GE(pieces.size(), cells / 2);
            EXPECT_EQ(faults(*object), "");
            for (std::size_t i = 0; i < pieces.size(); i += 1 + pieces.size() / 12) {
                ASSERT_EQ(faults(*pieces[i]), "");
                EXPECT_FALSE(pieces[i]->shares_buffers_with(*object));
                const glm::dvec3 middle = pieces[i]->bounds().centre();
                const CutResult halves = cut(std::move(pieces[i]), *Plane::through(middle, {1, 2, 3}));
                ASSERT_EQ(halves.status, Status::done);
                for (const auto* side : {&halves.positive, &halves.negative})
                    for (const auto& half : *side) ASSERT_EQ(faults(*half), "");
            }
        }
    }
}

TEST(Handover, PiecesOfPiecesAreSound)
{
    const auto object = object_from(test::repaired(shapes::asteroid(150'000, 1)));
    // A fragment that is a small part of what it shares.
    auto pieces = handed_over(*object, 5);
    ASSERT_GE(pieces.size(), 2u);
    ASSERT_GT(pieces[1]->triangle_count(), 20'000u);
    for (const auto& piece : handed_over(*pieces[1], 20)) ASSERT_EQ(faults(*piece), "");
}

TEST(Handover, SmallObjectsAreBrokenAsMeshes)
{
    EXPECT_EQ(object_from(test::repaired(shapes::asteroid(5000, 1)))->breakable(), nullptr);
}

}  // namespace
}  // namespace kerf::core::halfedge
