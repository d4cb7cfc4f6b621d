// Properties of cut(), over random shapes, places and planes, for every back end.

#include <gtest/gtest.h>

#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <numeric>

#include "common/cutting/cut.h"
#include "common/shapes/shapes.h"
#include "support/backends.h"
#include "support/fixtures.h"
#include "support/random_case.h"
#include "support/referee.h"

namespace kerf::core {
namespace {

using test::any_case;
using test::below;
using test::Case;
using test::make_case;
using test::Random;
using test::some_plane;

using Fragments = std::vector<std::unique_ptr<Cuttable>>;

class CutProperties : public testing::TestWithParam<test::NamedBackend>
{
protected:
    std::unique_ptr<Cuttable> prepare(const IndexedMesh& mesh) const
    {
        PrepareResult result = backend_->prepare(mesh);
        RC_ASSERT(result.status == Status::done);
        return std::move(result.object);
    }

    CutResult cut_of(const Case& c, const CutOptions& options = {}) const
    {
        return cut(prepare(c.mesh), c.plane, options);
    }

    std::unique_ptr<Backend> backend_ = GetParam().make();
};

INSTANTIATE_TEST_SUITE_P(All, CutProperties, testing::ValuesIn(test::backends()),
                         [](const auto& back_end) { return back_end.param.name; });

std::vector<std::vector<std::uint32_t>> bytes_of(const Fragments& fragments)
{
    std::vector<std::vector<std::uint32_t>> result;
    for (const auto& f : fragments) result.push_back(referee::bytes_of(f->to_indexed_mesh()));
    return result;
}

/// Closed, without collapsed triangles, and on its side of the plane.
void assert_sound(const Fragments& fragments, const Plane& plane, bool is_positive, double noise)
{
    for (const auto& fragment : fragments) {
        const IndexedMesh mesh = fragment->to_indexed_mesh();
        RC_ASSERT(check(mesh) == "");
        RC_ASSERT(!mesh.triangles.empty());
        RC_ASSERT(referee::open_edges(mesh) == 0u);
        RC_ASSERT(referee::open_edges_by_position(mesh) == 0u);
        RC_ASSERT(referee::triangles_with_equal_corners(mesh) == 0u);
        RC_ASSERT(referee::overhang(mesh, plane, is_positive) <= noise);
    }
}

TEST_P(CutProperties, SidesAreClosedAndAddUp)
{
    EXPECT_TRUE(rc::check([this] {
        const Case c = any_case();
        RC_LOG() << "case: " << c.name << " seed " << c.seed;
        const CutResult result = cut_of(c);
        RC_CLASSIFY(result.status == Status::missed, "missed");
        if (result.status == Status::missed) return;
        RC_ASSERT(result.status == Status::done);
        assert_sound(result.positive, c.plane, true, c.noise());
        assert_sound(result.negative, c.plane, false, c.noise());
        const double area = referee::area(c.mesh);
        const double volume = referee::volume(c.mesh);
        RC_ASSERT(std::abs(referee::volume(result.positive) + referee::volume(result.negative) - volume) <=
                  referee::kSumTolerance * std::abs(volume) + c.noise() * area);
        double surface = 0;
        for (const Fragments* side : {&result.positive, &result.negative})
            for (const auto& f : *side) surface += referee::area(f->to_indexed_mesh(), TriangleKind::surface);
        RC_ASSERT(std::abs(surface - area) <= referee::kSumTolerance * area);
    }));
}

/// Sum of the triangles' area vectors of one kind, along the plane's normal.
double area_along(const Fragments& fragments, const Plane& plane, TriangleKind kind)
{
    double twice = 0;
    for (const auto& fragment : fragments) {
        const IndexedMesh mesh = fragment->to_indexed_mesh();
        for (const TriangleGroup& group : mesh.groups) {
            if (group.kind != kind) continue;
            for (std::uint32_t t = group.first; t < group.first + group.count; ++t) {
                const auto at = [&](std::size_t i) { return glm::dvec3(mesh.vertices[mesh.triangles[t][i]].position); };
                twice += glm::dot(glm::cross(at(1) - at(0), at(2) - at(0)), plane.normal);
            }
        }
    }
    return twice / 2;
}

double cap_area(const Fragments& fragments)
{
    double sum = 0;
    for (const auto& f : fragments) sum += referee::area(f->to_indexed_mesh(), TriangleKind::cap);
    return sum;
}

/// What bounds the section is the rim of the surface: by the divergence theorem the surface of a side says how large
/// the section is, whatever closes it.
TEST_P(CutProperties, CapsCoverTheSectionOnce)
{
    EXPECT_TRUE(rc::check([this] {
        const Case c = any_case();
        RC_LOG() << "case: " << c.name << " seed " << c.seed;
        CutOptions options;
        options.split_components = below(2) == 1;
        const CutResult result = cut_of(c, options);
        if (result.status == Status::missed) return;
        const double slack = referee::kSumTolerance * referee::area(c.mesh);
        const double covered = result.section_area;
        RC_ASSERT(covered >= -slack);
        for (const bool is_positive : {false, true}) {
            const Fragments& side = is_positive ? result.positive : result.negative;
            const double outward = is_positive ? -1 : 1;
            RC_ASSERT(std::abs(outward * area_along(side, c.plane, TriangleKind::surface) + covered) <= slack);
            RC_ASSERT(std::abs(outward * area_along(side, c.plane, TriangleKind::cap) - covered) <= slack);
            // The baseline's fan overlaps where the section is not star-shaped, and is never smaller.
            if (GetParam().name == "halfedge")
                RC_ASSERT(std::abs(cap_area(side) - covered) <= slack);
            else
                RC_ASSERT(cap_area(side) >= covered - slack);
        }
        RC_ASSERT(!(result.caps_exceed_section && GetParam().name == "halfedge"));
    }));
}

TEST_P(CutProperties, SidesAreTheSameForEveryBackEnd)
{
    const auto first = test::backends().front().make();
    EXPECT_TRUE(rc::check([&, this] {
        const Case c = any_case();
        RC_LOG() << "case: " << c.name << " seed " << c.seed;
        CutOptions options;
        options.build_caps = below(4) != 0;
        const CutResult expected = cut(std::move(first->prepare(c.mesh).object), c.plane, options);
        const CutResult result = cut_of(c, options);
        RC_ASSERT(result.status == expected.status);
        RC_ASSERT(std::abs(result.section_area - expected.section_area) <= 1e-9 * (1 + referee::area(c.mesh)));
        RC_ASSERT(result.statistics.crossing_surface == expected.statistics.crossing_surface);
        RC_ASSERT(referee::canonical_surface(result.positive) == referee::canonical_surface(expected.positive));
        RC_ASSERT(referee::canonical_surface(result.negative) == referee::canonical_surface(expected.negative));
    }));
}

/// A motion rounds each vertex anew: what is promised is that nothing changes but by that much. Where a plane goes
/// through vertices they may change sides, and with them the whole of a face in the plane, but no volume.
TEST_P(CutProperties, AMotionOfMeshAndPlaneChangesNoVolume)
{
    EXPECT_TRUE(rc::check([this] {
        const Case c = any_case();
        RC_LOG() << "case: " << c.name << " seed " << c.seed;
        Random random(c.seed + 1);
        const test::Motion motion = test::any_motion(random);
        Case moved = c;
        test::move(moved.mesh, motion);
        moved.plane.normal = glm::normalize(motion.turned(c.plane.normal));
        moved.plane.offset = c.plane.offset + glm::dot(moved.plane.normal, motion.offset);

        const CutResult one = cut_of(c), other = cut_of(moved);
        const double volume = referee::volume(c.mesh), area = referee::area(c.mesh);
        const double slack = referee::kSumTolerance * std::abs(volume) + 2 * (c.noise() + moved.noise()) * area;
        // What a plane misses lies on one side of it, or within its noise.
        const auto volume_behind = [](const CutResult& result, const Case& of) {
            if (result.status != Status::missed) return referee::volume(result.negative);
            return of.plane.signed_distance(glm::vec3(of.mesh.bounds().centre())) < 0 ? referee::volume(of.mesh) : 0.0;
        };
        RC_ASSERT(std::abs(volume_behind(one, c) - volume_behind(other, moved)) <= slack);
    }));
}

TEST_P(CutProperties, FlippingThePlaneSwapsTheSides)
{
    EXPECT_TRUE(rc::check([this] {
        Case c = any_case();
        RC_LOG() << "case: " << c.name << " seed " << c.seed;
        const CutResult one = cut_of(c);
        c.plane = c.plane.flipped();
        const CutResult other = cut_of(c);
        RC_ASSERT(one.status == other.status);
        RC_ASSERT(referee::canonical_surface(one.positive) == referee::canonical_surface(other.negative));
        RC_ASSERT(referee::canonical_surface(one.negative) == referee::canonical_surface(other.positive));
        RC_ASSERT(std::abs(one.section_area - other.section_area) <= 1e-9 * (1 + referee::area(c.mesh)));
    }));
}

TEST_P(CutProperties, TheSameCutGivesTheSameBytes)
{
    EXPECT_TRUE(rc::check([this] {
        const Case c = any_case();
        RC_LOG() << "case: " << c.name << " seed " << c.seed;
        CutOptions options;
        options.split_components = below(2) == 1;
        const auto object = prepare(c.mesh);
        const CutResult one = cut(object->clone(), c.plane, options), other = cut_of(c, options);
        RC_ASSERT(bytes_of(one.positive) == bytes_of(other.positive));
        RC_ASSERT(bytes_of(one.negative) == bytes_of(other.negative));
    }));
}

TEST_P(CutProperties, FragmentsMissThePlaneThatMadeThem)
{
    EXPECT_TRUE(rc::check([this] {
        const Case c = any_case();
        RC_LOG() << "case: " << c.name << " seed " << c.seed;
        CutResult result = cut_of(c);
        for (Fragments* side : {&result.positive, &result.negative})
            for (auto& fragment : *side) RC_ASSERT(cut(std::move(fragment), c.plane).status == Status::missed);
    }));
}

TEST_P(CutProperties, ScaleByAPowerOfTwoChangesNothingButTheScale)
{
    EXPECT_TRUE(rc::check([this] {
        const Case c = any_case();
        RC_LOG() << "case: " << c.name << " seed " << c.seed;
        Case scaled = c;
        // Larger only: a coordinate that should be 0 but for rounding may have no smaller float to go to.
        const int exponent = static_cast<int>(below(41));
        const float scale = std::ldexp(1.0f, exponent);
        for (Vertex& v : scaled.mesh.vertices) v.position *= scale;
        scaled.plane.offset *= double(scale);

        const CutResult one = cut_of(c), other = cut_of(scaled);
        RC_ASSERT(one.status == other.status);
        RC_ASSERT(one.section_area * double(scale) * double(scale) == other.section_area);
        for (const auto& [a, b] : {std::pair{&one.positive, &other.positive}, {&one.negative, &other.negative}}) {
            RC_ASSERT(a->size() == b->size());
            for (std::size_t i = 0; i < a->size(); ++i) {
                const IndexedMesh p = (*a)[i]->to_indexed_mesh(), q = (*b)[i]->to_indexed_mesh();
                RC_ASSERT(p.triangles == q.triangles);
                RC_ASSERT(p.points == q.points);
                RC_ASSERT(p.sources == q.sources);
                for (std::size_t v = 0; v < p.vertices.size(); ++v) {
                    RC_ASSERT(p.vertices[v].position * scale == q.vertices[v].position);
                    RC_ASSERT(p.vertices[v].normal == q.vertices[v].normal);
                }
            }
        }
    }));
}

TEST_P(CutProperties, FragmentsOfAChainOfCutsAddUpToTheWhole)
{
    EXPECT_TRUE(rc::check([this] {
        const Case c = any_case();
        RC_LOG() << "case: " << c.name << " seed " << c.seed;
        Random random(c.seed);
        CutOptions options;
        options.split_components = below(2) == 1;
        Fragments objects;
        objects.push_back(prepare(c.mesh));
        for (int generation = 0; generation < 3; ++generation) {
            // One plane for all: caps of earlier cuts decide nothing, and planes through vertices meet several objects.
            const Plane plane = some_plane(
                generation == 0 ? c.mesh
                                : objects[below(static_cast<std::uint32_t>(objects.size()))]->to_indexed_mesh(),
                random);
            Fragments next;
            for (auto& object : objects) {
                CutResult result = cut(std::move(object), plane, options);
                RC_ASSERT(result.status == Status::done || result.status == Status::missed);
                assert_sound(result.positive, plane, true, c.noise());
                assert_sound(result.negative, plane, false, c.noise());
                if (result.object) next.push_back(std::move(result.object));
                for (Fragments* side : {&result.positive, &result.negative})
                    std::move(side->begin(), side->end(), std::back_inserter(next));
            }
            objects = std::move(next);
            const double volume = referee::volume(c.mesh);
            RC_ASSERT(std::abs(referee::volume(objects) - volume) <=
                      referee::kSumTolerance * std::abs(volume) + c.noise() * referee::area(c.mesh));
        }
    }));
}

// Pieces
// ---------------------------------------------------------------------------------------------------------------

/// What hangs together by edges on one side of a plane.
struct EdgeComponent
{
    std::vector<referee::SurfaceTriangle> surface;
    bool is_flat = true;  ///< no vertex lies beyond the noise of the plane
};

/// A mesh taken apart by flooding over shared edges: pairs of point ids, however many triangles meet at them. A referee
/// of its own: an ordered map of edges and relabelling until nothing changes.
std::vector<EdgeComponent> edge_components(const IndexedMesh& mesh, const Plane& plane, double noise)
{
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::size_t>> at_edge;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint32_t a = mesh.points[mesh.triangles[t][i]], b = mesh.points[mesh.triangles[t][(i + 1) % 3]];
            at_edge[std::minmax(a, b)].push_back(t);
        }
    std::vector<std::size_t> label(mesh.triangles.size());
    std::iota(label.begin(), label.end(), std::size_t(0));
    for (bool changed = true; changed;) {
        changed = false;
        for (const auto& [edge, triangles] : at_edge) {
            std::size_t least = label[triangles.front()];
            for (const std::size_t t : triangles) least = std::min(least, label[t]);
            for (const std::size_t t : triangles) {
                changed |= label[t] != least;
                label[t] = least;
            }
        }
    }
    std::map<std::size_t, IndexedMesh> parts;
    std::map<std::size_t, EdgeComponent> components;
    for (const TriangleGroup& group : mesh.groups)
        for (std::uint32_t t = group.first; t < group.first + group.count; ++t) {
            IndexedMesh& part = parts[label[t]];
            if (part.vertices.empty()) {
                part.vertices = mesh.vertices;
                part.points = mesh.points;
                part.streams = mesh.streams;
                part.materials = mesh.materials;
            }
            part.groups.push_back(
                {static_cast<std::uint32_t>(part.triangles.size()), 1, group.material, group.solid, group.kind});
            part.triangles.push_back(mesh.triangles[t]);
            part.sources.push_back(mesh.sources[t]);
            for (const std::uint32_t v : mesh.triangles[t])
                if (std::abs(plane.signed_distance(mesh.vertices[v].position)) > noise)
                    components[label[t]].is_flat = false;
        }
    std::vector<EdgeComponent> result;
    for (const auto& [root, part] : parts) {
        components[root].surface = referee::canonical_surface(part);
        result.push_back(components[root]);
    }
    return result;
}

std::vector<std::vector<referee::SurfaceTriangle>> surfaces_of(const Fragments& pieces)
{
    std::vector<std::vector<referee::SurfaceTriangle>> result;
    for (const auto& piece : pieces) result.push_back(referee::canonical_surface(piece->to_indexed_mesh()));
    std::sort(result.begin(), result.end());
    return result;
}

bool contains(const std::vector<referee::SurfaceTriangle>& whole, const std::vector<referee::SurfaceTriangle>& part)
{
    return std::includes(whole.begin(), whole.end(), part.begin(), part.end());
}

/// Each piece holds one component; those that are flat are no pieces, but stay with one.
void assert_pieces_are_components(const Fragments& pieces, const IndexedMesh& side, const Case& c)
{
    const auto homes = surfaces_of(pieces);
    std::vector<std::size_t> held(homes.size(), 0);
    std::size_t count = 0;
    for (const EdgeComponent& component : edge_components(side, c.plane, c.noise())) {
        count += component.surface.size();
        const auto home =
            std::find_if(homes.begin(), homes.end(), [&](const auto& h) { return contains(h, component.surface); });
        RC_ASSERT(home != homes.end());
        if (!component.is_flat) ++held[static_cast<std::size_t>(home - homes.begin())];
    }
    RC_ASSERT(held == std::vector<std::size_t>(homes.size(), 1));
    for (const auto& home : homes) count -= home.size();
    RC_ASSERT(count == 0u);
}

CutOptions in_pieces()
{
    CutOptions options;
    options.split_components = true;
    return options;
}

CutOptions without_caps()
{
    CutOptions options;
    options.build_caps = false;
    return options;
}

TEST_P(CutProperties, PiecesWithoutHolesAreWhatHangsTogetherByEdges)
{
    // Shapes in which no plane has a section with holes, so that pieces are exactly what flooding finds.
    const std::vector<std::string> names{"comb", "cone", "cylinder", "icosphere", "l_step", "two_legs"};
    EXPECT_TRUE(rc::check([&, this] {
        const std::string& name = names[below(static_cast<std::uint32_t>(names.size()))];
        const std::uint64_t seed = *rc::gen::resize(rc::kNominalSize, rc::gen::arbitrary<std::uint64_t>());
        const Case c = make_case(name, test::repaired(*shapes::make(name, 12 + below(150), seed)), seed);
        RC_LOG() << "case: " << c.name << " seed " << c.seed;
        const CutResult pieces = cut_of(c, in_pieces()), sides = cut_of(c, without_caps());
        RC_ASSERT(pieces.status == sides.status);
        if (sides.status == Status::missed) return;
        RC_CLASSIFY(pieces.positive.size() + pieces.negative.size() > 2, "fell apart");
        assert_pieces_are_components(pieces.positive, sides.positive.front()->to_indexed_mesh(), c);
        assert_pieces_are_components(pieces.negative, sides.negative.front()->to_indexed_mesh(), c);
    }));
}

TEST_P(CutProperties, PiecesAreClosedAndKeepTogetherWhatHangsTogether)
{
    EXPECT_TRUE(rc::check([this] {
        const Case c = any_case();
        RC_LOG() << "case: " << c.name << " seed " << c.seed;
        const CutResult pieces = cut_of(c, in_pieces()), sides = cut_of(c, without_caps());
        RC_ASSERT(pieces.status == sides.status);
        if (sides.status == Status::missed) return;
        assert_sound(pieces.positive, c.plane, true, c.noise());
        assert_sound(pieces.negative, c.plane, false, c.noise());
        const double volume = referee::volume(c.mesh);
        RC_ASSERT(std::abs(referee::volume(pieces.positive) + referee::volume(pieces.negative) - volume) <=
                  referee::kSumTolerance * std::abs(volume) + c.noise() * referee::area(c.mesh));
        for (const auto& [whole, parts] :
             {std::pair{&sides.positive, &pieces.positive}, {&sides.negative, &pieces.negative}}) {
            const auto homes = surfaces_of(*parts);
            for (const auto& component : edge_components(whole->front()->to_indexed_mesh(), c.plane, c.noise()))
                RC_ASSERT(std::any_of(homes.begin(), homes.end(),
                                      [&](const auto& home) { return contains(home, component.surface); }));
        }
    }));
}

TEST_P(CutProperties, PiecesAreTheSameForEveryBackEnd)
{
    const auto first = test::backends().front().make();
    EXPECT_TRUE(rc::check([&, this] {
        const Case c = any_case();
        RC_LOG() << "case: " << c.name << " seed " << c.seed;
        // The pieces of pieces as well: both cut the same mesh, caps included.
        Random random(c.seed);
        std::vector<IndexedMesh> meshes{c.mesh};
        Plane plane = c.plane;
        for (int generation = 0; generation < 3; ++generation) {
            const std::size_t chosen = below(static_cast<std::uint32_t>(meshes.size()));
            const IndexedMesh mesh = meshes[chosen];
            // A cap that runs along an edge of the surface, or meets it in a point, is for the back end that made it.
            if (!prove(mesh).error.empty()) return;
            if (generation > 0) plane = some_plane(mesh, random);
            const CutResult expected = cut(std::move(first->prepare(mesh).object), plane, in_pieces());
            const CutResult result = cut(prepare(mesh), plane, in_pieces());
            RC_ASSERT(result.status == expected.status);
            if (result.status == Status::missed) return;
            RC_ASSERT(surfaces_of(result.positive) == surfaces_of(expected.positive));
            RC_ASSERT(surfaces_of(result.negative) == surfaces_of(expected.negative));
            meshes.clear();
            for (const Fragments* side : {&result.positive, &result.negative})
                for (const auto& piece : *side) meshes.push_back(piece->to_indexed_mesh());
        }
    }));
}

}  // namespace
}  // namespace kerf::core
