#include "tools/comparison.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <limits>
#include <random>
#include <utility>

#include "baseline/baseline.h"
#include "common/cutting/back_end_helpers.h"
#include "common/repair/repair.h"
#include "common/shapes/shapes.h"
#include "halfedge/halfedge.h"
#include "tools/open_edges.h"
#include "tools/section_facts.h"

// The comparison is given back ends that lie, each in one way, and must name the lie.

namespace kerf::tools {
namespace {

/// One way to spoil the mesh of a fragment.
using Spoil = std::function<void(IndexedMesh&)>;

/// Cuts as the baseline does, but the fragments' meshes are spoiled.
class LyingObject final : public Cuttable
{
public:
    LyingObject(std::unique_ptr<Cuttable> honest, Spoil spoil, bool was_cut)
        : honest_(std::move(honest)), spoil_(std::move(spoil)), was_cut_(was_cut)
    {
    }

    std::unique_ptr<Cuttable> clone() const override
    {
        return std::make_unique<LyingObject>(honest_->clone(), spoil_, was_cut_);
    }
    std::uint64_t triangle_count() const override { return honest_->triangle_count(); }
    Box bounds() const override { return honest_->bounds(); }
    DrawView draw_view() const override { return honest_->draw_view(); }
    void mark_uploaded(const DrawView& view) override { honest_->mark_uploaded(view); }
    MassProperties mass_properties() const override { return honest_->mass_properties(); }
    std::array<glm::vec3, kSupportDirections> support_points() const override { return honest_->support_points(); }
    std::span<const Vertex> used_vertices(std::vector<Vertex>& room) const override
    {
        return honest_->used_vertices(room);
    }
    std::span<const SectionLoop> section_loops() const override { return honest_->section_loops(); }
    IndexedMesh to_indexed_mesh() const override
    {
        IndexedMesh mesh = honest_->to_indexed_mesh();
        if (was_cut_) spoil_(mesh);
        return mesh;
    }

    std::span<const Material> materials() const override { return honest_->materials(); }
    std::uint32_t add_material(const Material& material) override { return honest_->add_material(material); }

private:
    CutResult cut_by(const Plane& plane, const CutOptions& options) override
    {
        CutResult result = cut(std::move(honest_), plane, options);
        if (result.object) honest_ = std::move(result.object);
        for (auto* side : {&result.positive, &result.negative})
            for (auto& fragment : *side) fragment = std::make_unique<LyingObject>(std::move(fragment), spoil_, true);
        return result;
    }

    std::uint64_t buffers() const noexcept override { return serial_; }

    std::unique_ptr<Cuttable> honest_;
    Spoil spoil_;
    bool was_cut_;
    const std::uint64_t serial_ = new_buffers_serial();
};

class LyingBackend final : public Backend
{
public:
    explicit LyingBackend(Spoil spoil) : spoil_(std::move(spoil)) {}
    std::string name() const override { return "liar"; }

private:
    std::unique_ptr<Cuttable> make(ProvenMesh&& mesh, const PrepareOptions&) const override
    {
        return std::make_unique<LyingObject>(baseline::make_back_end()->prepare(std::move(mesh)).object, spoil_, false);
    }

    Spoil spoil_;
};

ProvenMesh repaired(TriangleSoup soup)
{
    return repair(std::move(soup)).mesh;
}

struct Outcome
{
    ComparedMesh mesh;
    std::vector<ComparisonRow> rows;

    /// Rows with a failure that says `clause`.
    std::size_t rows_that_say(const std::string& clause) const
    {
        std::size_t count = 0;
        for (const ComparisonRow& row : rows)
            for (const std::string& failure : row.failures)
                if (failure.find(clause) != std::string::npos) {
                    ++count;
                    break;
                }
        return count;
    }
    std::size_t cuts() const
    {
        std::size_t count = 0;
        for (const ComparisonRow& row : rows) count += row.was_cut() ? 1u : 0u;
        return count;
    }
};

Outcome compare_with(const Spoil& spoil, TriangleSoup soup, std::uint64_t depth = 1)
{
    ComparisonOptions options;
    options.planes = 12;
    options.depth = depth;
    Outcome outcome;
    outcome.mesh =
        compare_mesh(repaired(std::move(soup)), *baseline::make_back_end(baseline::VertexLookup::remap),
                     LyingBackend(spoil), options, [&](const ComparisonRow& row) { outcome.rows.push_back(row); });
    return outcome;
}

/// A ball: its sections are convex, so that the baseline's fans are right.
TriangleSoup ball()
{
    return shapes::icosphere(1.0f, 6);
}

void flip_last_bit(float& value)
{
    value = std::bit_cast<float>(std::bit_cast<std::uint32_t>(value) ^ 1u);
}

TriangleGroup& cap_of(IndexedMesh& mesh)
{
    for (TriangleGroup& group : mesh.groups)
        if (group.kind == TriangleKind::cap) return group;
    ADD_FAILURE() << "there is no cap";
    return mesh.groups.front();
}

TEST(Comparison, FindsNothingWhereThereIsNothing)
{
    const Outcome outcome = compare_with([](IndexedMesh&) {}, ball(), 3);
    EXPECT_TRUE(outcome.mesh.closed);
    EXPECT_TRUE(outcome.mesh.failures.empty());
    EXPECT_EQ(outcome.mesh.rows, outcome.rows.size());
    EXPECT_GT(outcome.cuts(), 36u);
    for (const ComparisonRow& row : outcome.rows) EXPECT_TRUE(row.failures.empty()) << row.failures.front();
}

TEST(Comparison, FindsOneBitOfOneAttribute)
{
    for (const Spoil& spoil : {Spoil([](IndexedMesh& m) { flip_last_bit(m.vertices[m.triangles[0][0]].uv.x); }),
                               Spoil([](IndexedMesh& m) { flip_last_bit(m.vertices[m.triangles[0][1]].normal.y); }),
                               Spoil([](IndexedMesh& m) { flip_last_bit(m.vertices[m.triangles[0][2]].position.z); }),
                               Spoil([](IndexedMesh& m) { m.sources[0] += 1; })}) {
        const Outcome outcome = compare_with(spoil, ball());
        EXPECT_EQ(outcome.rows_that_say("surface differs, positive side"), outcome.cuts());
        EXPECT_EQ(outcome.rows_that_say("surface differs, negative side"), outcome.cuts());
        for (const ComparisonRow& row : outcome.rows) EXPECT_EQ(row.surfaces_equal(), !row.was_cut());
    }
}

TEST(Comparison, FindsAMissingCapTriangle)
{
    const Outcome outcome = compare_with(
        [](IndexedMesh& m) {
            ASSERT_EQ(&cap_of(m), &m.groups.back());
            m.groups.back().count -= 1;
            m.triangles.pop_back();
            m.sources.pop_back();
        },
        ball());
    EXPECT_EQ(outcome.rows_that_say("halfedge has 6 open edges"), outcome.cuts());
    EXPECT_EQ(outcome.rows_that_say("half-edge cap area off by"), outcome.cuts());
    EXPECT_EQ(outcome.rows_that_say("surface differs"), 0u);
}

TEST(Comparison, FindsACapThatOverlapsItself)
{
    // The fan's centre outside the section: closed, of the right volume, and wrong.
    const Outcome outcome = compare_with(
        [](IndexedMesh& m) {
            const TriangleGroup& cap = cap_of(m);
            const Triangle &s = m.triangles[cap.first], &t = m.triangles[cap.first + 1];
            for (const std::uint32_t v : s) {
                if (std::find(t.begin(), t.end(), v) == t.end()) continue;
                // The centre is the vertex of all triangles, the other shared one is on the rim.
                bool is_centre = true;
                for (std::uint32_t i = 0; i < cap.count; ++i) {
                    const Triangle& u = m.triangles[cap.first + i];
                    is_centre = is_centre && std::find(u.begin(), u.end(), v) != u.end();
                }
                if (!is_centre) continue;
                const glm::vec3 rim = m.vertices[s[0] == v ? s[1] : s[0]].position;
                m.vertices[v].position += 3.0f * (rim - m.vertices[v].position);
            }
        },
        ball());
    EXPECT_EQ(outcome.rows_that_say("half-edge cap area off by"), outcome.cuts());
    EXPECT_EQ(outcome.rows_that_say("open edge"), 0u);
    EXPECT_EQ(outcome.rows_that_say("surface differs"), 0u);
}

TEST(Comparison, FindsAUvThatIsNoNumber)
{
    const Outcome outcome = compare_with(
        [](IndexedMesh& m) {
            m.vertices[m.triangles[cap_of(m).first][0]].uv.y = std::numeric_limits<float>::infinity();
        },
        ball());
    EXPECT_EQ(outcome.rows_that_say("halfedge has 2 vertices with a number that is not finite"), outcome.cuts());
    EXPECT_EQ(outcome.rows_that_say("surface differs"), 0u);
}

TEST(Comparison, FindsNothingInABoxOfTheLargestFloats)
{
    TriangleSoup box = shapes::box({2, 2, 2}, {1, 1, 1});
    for (Vertex& v : box.vertices) v.position *= std::numeric_limits<float>::max();
    const Outcome outcome = compare_with([](IndexedMesh&) {}, box);
    EXPECT_GT(outcome.cuts(), 0u);
    for (const ComparisonRow& row : outcome.rows)
        EXPECT_TRUE(row.failures.empty()) << row.piece << ": " << row.failures.front();
}

TEST(Comparison, FindsEqualCornersWrongSidesAndWrongVolumes)
{
    const Outcome equal = compare_with(
        [](IndexedMesh& m) { m.vertices[m.triangles[0][0]].position = m.vertices[m.triangles[0][1]].position; },
        ball());
    EXPECT_EQ(equal.rows_that_say("with equal corners"), equal.cuts());
    const Outcome far = compare_with([](IndexedMesh& m) { m.vertices[m.triangles[0][0]].position *= -3.0f; }, ball());
    EXPECT_GT(far.rows_that_say("is on the wrong side by"), 0u);
    const Outcome volume = compare_with(
        [](IndexedMesh& m) {
            for (Vertex& v : m.vertices) v.position *= 1.0f + 0x1p-18f;
        },
        ball());
    EXPECT_EQ(volume.rows_that_say("halfedge has a volume error of"), volume.cuts());
}

TEST(Comparison, SaysWhereTheFanIsWrongAndByHowMuch)
{
    // A pipe across: a ring of two loops. The fan covers the outer disc and the inner one twice over.
    ComparisonOptions options;
    options.planes = 1;
    options.first_plane = 2;
    std::vector<ComparisonRow> rows;
    const std::unique_ptr<Backend> baseline = baseline::make_back_end();
    compare_mesh(repaired(shapes::pipe(1.0f, 0.5f, 2.0f, 64, 3)), *baseline, *baseline, options,
                 [&](const ComparisonRow& row) { rows.push_back(row); });
    ASSERT_EQ(rows.size(), 1u);
    EXPECT_EQ(rows[0].loops, 2u);
    EXPECT_FALSE(rows[0].fan_fits);
    EXPECT_NEAR(rows[0].baseline.cap_excess / rows[0].section_area, 2.0 * 0.25 / 0.75, 1e-6);
    EXPECT_FALSE(rows[0].section_intersects_itself);
}

TEST(ComparisonPlanes, DependOnTheSurfaceAndTheSeedOnly)
{
    const IndexedMesh mesh = *repaired(shapes::torus(1.0f, 0.4f, 20, 12));
    IndexedMesh turned = mesh;
    for (Triangle& t : turned.triangles) t = {t[1], t[2], t[0]};
    const SurfaceKeys a(mesh), b(turned);
    std::size_t through_vertices = 0, other_seed_agrees = 0;
    for (std::uint64_t i = 0; i < 64; ++i) {
        const ChosenPlane p = choose_plane(a, PlaneMix::nasty, i, 3), q = choose_plane(b, PlaneMix::nasty, i, 3);
        EXPECT_EQ(p.kind, q.kind);
        EXPECT_EQ(p.plane.normal, q.plane.normal);
        EXPECT_EQ(p.plane.offset, q.plane.offset);
        EXPECT_TRUE(p.plane.valid());
        bool meets_vertex = false;
        for (const Vertex& v : mesh.vertices)
            meets_vertex = meets_vertex || std::abs(p.plane.signed_distance(v.position)) < 1e-12;
        if (meets_vertex) ++through_vertices;
        const ChosenPlane other = choose_plane(a, PlaneMix::nasty, i, 4);
        if (i >= 4 && other.plane.offset == p.plane.offset) ++other_seed_agrees;
        EXPECT_EQ(choose_plane(a, PlaneMix::random, i, 3).kind, "random");
    }
    EXPECT_GT(through_vertices, 40u);
    EXPECT_LT(other_seed_agrees, 8u);
}

SectionLoop loop(std::initializer_list<glm::vec2> points)
{
    SectionLoop made;
    for (const glm::vec2& p : points) made.points.emplace_back(p, 0.5f);
    return made;
}

TEST(SectionFacts, MeasureAreaAndLength)
{
    const std::vector<SectionLoop> ring{loop({{0, 0}, {4, 0}, {4, 4}, {0, 4}}), loop({{1, 1}, {1, 2}, {2, 2}, {2, 1}})};
    const SectionFacts facts = measure_section(ring, {0, 0, 1});
    EXPECT_DOUBLE_EQ(facts.area, 15.0);
    EXPECT_DOUBLE_EQ(facts.length, 20.0);
    EXPECT_EQ(facts.loops, 2u);
    EXPECT_DOUBLE_EQ(measure_section(ring, {0, 0, -1}).area, -15.0);
}

TEST(SectionFacts, TellWhatWindsBackwardsOrTwice)
{
    const glm::dvec3 up{0, 0, 1};
    const SectionLoop square = loop({{0, 0}, {4, 0}, {4, 4}, {0, 4}}), hole = loop({{1, 1}, {1, 2}, {2, 2}, {2, 1}}),
                      shifted = loop({{3, 3}, {7, 3}, {7, 7}, {3, 7}}), bow = loop({{0, 0}, {2, 2}, {2, 0}, {0, 2}});
    const auto facts = [&](const std::vector<SectionLoop>& loops) {
        return measure_winding(steps_of(loops), up).value();
    };
    EXPECT_NEAR(facts({square, hole}).backward, 0.0, 1e-12);
    EXPECT_NEAR(facts({square, hole}).multiple, 0.0, 1e-12);
    EXPECT_NEAR(facts({hole}).backward, 1.0, 1e-12);
    EXPECT_NEAR(facts({square, shifted}).multiple, 1.0, 1e-12);
    EXPECT_NEAR(facts({bow}).backward, 1.0, 1e-12);
    // A slanted plane: areas are those in the plane.
    SectionLoop slanted = hole;
    for (glm::vec3& p : slanted.points) p.z = p.x;
    EXPECT_NEAR(measure_winding(steps_of(std::vector{slanted}), glm::normalize(glm::dvec3(-1, 0, 1)))->backward,
                std::sqrt(2.0), 1e-12);
}

/// {n / 2}: every edge crosses nearly every other one.
SectionLoop star(int points)
{
    SectionLoop made;
    const int step = points / 2;
    for (int i = 0; i < points; ++i) {
        const double angle = 2 * std::acos(-1.0) * i * step / points;
        made.points.emplace_back(std::cos(angle), std::sin(angle), 0.0);
    }
    return made;
}

TEST(SectionFacts, GiveUpWhereEdgesCrossTooOften)
{
    const glm::dvec3 up{0, 0, 1};
    EXPECT_TRUE(measure_winding(steps_of(std::vector{star(101)}), up).has_value());
    EXPECT_FALSE(measure_winding(steps_of(std::vector{star(2001)}), up).has_value());
}

/// A closed prism over a loop at y = 0.
TriangleSoup prism(const SectionLoop& loop)
{
    TriangleSoup soup;
    const auto n = static_cast<std::uint32_t>(loop.points.size());
    for (const float y : {-1.0f, 1.0f})
        for (const glm::vec3& p : loop.points) soup.vertices.push_back({{p.x, y, p.y}, {0, 1, 0}, {0, 0}});
    for (const float y : {-1.0f, 1.0f}) soup.vertices.push_back({{0, y, 0}, {0, 1, 0}, {0, 0}});
    for (std::uint32_t i = 0; i < n; ++i) {
        const std::uint32_t j = (i + 1) % n;
        for (const Triangle& t : {Triangle{i, i + n, j + n}, {i, j + n, j}, {2 * n, i, j}, {2 * n + 1, j + n, i + n}})
            soup.triangles.push_back(t);
    }
    return soup;
}

// Solids are capped one by one. Taken together, as they once were, the loops of these wind around everything once or
// twice, and a right cap was called wrong.
TEST(SectionsOfSolids, ShowWhatWindsBackwardsWithinAnother)
{
    TriangleSoup soup = prism(loop({{-4, -4}, {-4, 4}, {4, 4}, {4, -4}}));
    // A bow tie of lobes with areas 2 and 0.5.
    const TriangleSoup tie = prism(loop({{-2, -1}, {-2, 1}, {1, -0.5f}, {1, 0.5f}}));
    const auto first = static_cast<std::uint32_t>(soup.vertices.size());
    soup.vertices.insert(soup.vertices.end(), tie.vertices.begin(), tie.vertices.end());
    for (const auto& [a, b, c] : tie.triangles) soup.triangles.push_back({a + first, b + first, c + first});

    CutOptions options;
    options.cap_material = 1;
    IndexedMesh mesh = *repaired(std::move(soup));
    mesh.materials.resize(2);
    const glm::dvec3 up{0, 1, 0};
    const CutResult result = cut(baseline::make_back_end()->prepare(mesh).object, Plane{up, 0.0}, options);
    ASSERT_EQ(result.status, Status::done);
    EXPECT_NEAR(measure_winding(steps_of(result.negative.front()->section_loops()), up)->backward, 0.0, 1e-9);
    const auto sections = sections_of_solids(result.negative.front()->to_indexed_mesh(), 1);
    ASSERT_EQ(sections.size(), 2u);
    EXPECT_NEAR(measure_winding(sections[0], up)->backward + measure_winding(sections[1], up)->backward, 0.5, 1e-6);
}

// Loops of open shells, too, are covered solid by solid: two that run along one another in opposite directions cancel
// in the section, and each has a cap.
TEST(Comparison, FindsNothingInOpenSoupsWhoseLoopsCancel)
{
    const auto baseline = baseline::make_back_end(), halfedge = halfedge::make_back_end();
    ComparisonOptions options;
    options.planes = 4;
    std::size_t cuts = 0, cancelling = 0;
    for (std::uint32_t seed = 0; seed < 1000; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        std::mt19937 random(seed);
        TriangleSoup soup;
        for (const glm::vec3& p : {glm::vec3(0, 0, 0), glm::vec3(1, 0, 0), glm::vec3(0, 1, 0), glm::vec3(0, 0, 1)})
            soup.vertices.push_back({p, glm::vec3(0, 0, 1), glm::vec2(0.0f)});
        for (auto i = 3 + random() % 7; i > 0; --i) {
            std::array<std::uint32_t, 4> points{0, 1, 2, 3};
            std::shuffle(points.begin(), points.end(), random);
            soup.triangles.push_back({points[0], points[1], points[2]});
        }
        const ProvenMesh mesh = repaired(std::move(soup));
        if (mesh->triangles.empty()) continue;
        compare_mesh(mesh, *baseline, *halfedge, options, [&](const ComparisonRow& row) {
            cuts += row.was_cut();
            cancelling += row.was_cut() && row.loops > 1 && row.section_area == 0.0 && row.halfedge.cap_area[0] > 0.0;
            EXPECT_TRUE(row.failures.empty()) << row.failures.front();
        });
    }
    EXPECT_GT(cuts, 1000u);
    EXPECT_GT(cancelling, 5u);
}

TEST(Comparison, SaysWhatItCouldNotJudge)
{
    // The caps cover too much, and whether they must is more than it can tell.
    ComparisonOptions options;
    options.planes = 1;
    options.first_plane = 1;
    std::vector<ComparisonRow> rows;
    const auto spoil = [](IndexedMesh& m) { m.vertices[m.triangles[cap_of(m).first][0]].position.x += 3.0f; };
    const std::unique_ptr<Backend> baseline = baseline::make_back_end();
    compare_mesh(repaired(prism(star(2001))), *baseline, LyingBackend(spoil), options,
                 [&](const ComparisonRow& row) { rows.push_back(row); });
    ASSERT_EQ(rows.size(), 1u);
    ASSERT_TRUE(rows[0].was_cut());
    EXPECT_FALSE(rows[0].cap_fits);
    EXPECT_FALSE(rows[0].section_is_judged);
}

TEST(Comparison, VolumesThatCancelAreJudgedByTheSurface)
{
    // Two balls in one another, inside and outside: no volume to be relative to.
    TriangleSoup soup = ball();
    const std::size_t count = soup.triangles.size();
    const auto vertices = static_cast<std::uint32_t>(soup.vertices.size());
    for (std::uint32_t v = 0; v < vertices; ++v) soup.vertices.push_back(Vertex(soup.vertices[v]));
    for (std::size_t t = 0; t < count; ++t) {
        const auto [a, b, c] = soup.triangles[t];
        soup.triangles.push_back({a + vertices, c + vertices, b + vertices});
    }
    const ProvenMesh mesh = repaired(std::move(soup));
    ComparisonOptions options;
    options.planes = 12;
    const std::unique_ptr<Backend> baseline = baseline::make_back_end();
    Outcome outcome;
    const ComparedMesh compared = compare_mesh(mesh, *baseline, *baseline, options,
                                               [&](const ComparisonRow& row) { outcome.rows.push_back(row); });
    EXPECT_GT(outcome.cuts(), 8u);
    EXPECT_EQ(outcome.rows_that_say("volume error"), 0u);
    EXPECT_TRUE(compared.closed);
    EXPECT_LT(std::abs(compared.volume), 1e-9);
    EXPECT_GT(compared.judged_volume, 0.1);
}

TEST(Comparison, SaysThatRepairOpenedTheMesh)
{
    TriangleSoup sheet = ball();
    sheet.triangles.pop_back();
    const ProvenMesh mesh = repaired(std::move(sheet));
    const std::unique_ptr<Backend> baseline = baseline::make_back_end();
    const auto failures_of = [&](bool was_closed) {
        ComparisonOptions options;
        options.planes = 1;
        options.was_closed = was_closed;
        return compare_mesh(mesh, *baseline, *baseline, options, [](const ComparisonRow&) {}).failures;
    };
    EXPECT_EQ(failures_of(true),
              std::vector<std::string>{"was closed before it was repaired and has 3 open edges now"});
    EXPECT_TRUE(failures_of(false).empty());
}

TEST(Comparison, FindsAWarningThatIsMissing)
{
    // The fan's centre outside the section, and nothing said of it.
    const Outcome outcome = compare_with(
        [](IndexedMesh& m) { m.vertices[m.triangles[cap_of(m).first][0]].position += glm::vec3(9.0f, 9.0f, 9.0f); },
        ball());
    EXPECT_GT(outcome.rows_that_say("halfedge does not say that its caps exceed the section by"), 0u);
}

TEST(OpenEdges, AreEdgesWithoutAReverse)
{
    IndexedMesh mesh = *repaired(shapes::icosphere(1.0f, 3));
    EXPECT_EQ(open_edges(mesh), 0u);
    const Triangle last = mesh.triangles.back();
    mesh.triangles.pop_back();
    EXPECT_EQ(open_edges(mesh), 3u);
    mesh.triangles.push_back({last[0], last[2], last[1]});
    EXPECT_EQ(open_edges(mesh), 6u);
}

}  // namespace
}  // namespace kerf::tools
