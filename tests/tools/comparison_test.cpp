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

#include <kerf/back_ends.h>

#include "back_ends/back_ends.h"
#include "baseline/baseline.h"
#include "baseline/report_back_ends.h"
#include "common/cutting/back_end_helpers.h"
#include "common/shapes/shapes.h"
#include "support/public_mesh.h"
#include "tools/open_edges.h"
#include "tools/section_facts.h"

// The comparison is given back ends that lie, each in one way, and must name the lie.

namespace kerf::tools {
namespace {

/// One way to spoil the mesh of a fragment.
using Spoil = std::function<void(core::IndexedMesh&)>;

/// Cuts as the baseline does, but the fragments' meshes are spoiled.
class LyingObject final : public core::Cuttable
{
public:
    LyingObject(std::unique_ptr<core::Cuttable> honest, Spoil spoil, bool was_cut)
        : honest_(std::move(honest)), spoil_(std::move(spoil)), was_cut_(was_cut)
    {
    }

    std::unique_ptr<core::Cuttable> clone() const override
    {
        return std::make_unique<LyingObject>(honest_->clone(), spoil_, was_cut_);
    }
    std::uint64_t triangle_count() const override { return honest_->triangle_count(); }
    core::Box bounds() const override { return honest_->bounds(); }
    core::DrawView draw_view() const override { return honest_->draw_view(); }
    void mark_uploaded(const core::DrawView& view) override { honest_->mark_uploaded(view); }
    core::MassProperties mass_properties() const override { return honest_->mass_properties(); }
    std::array<glm::vec3, core::kSupportDirections> support_points() const override
    {
        return honest_->support_points();
    }
    std::span<const core::Vertex> used_vertices(std::vector<core::Vertex>& room) const override
    {
        return honest_->used_vertices(room);
    }
    std::span<const core::SectionLoop> section_loops() const override { return honest_->section_loops(); }
    core::IndexedMesh to_indexed_mesh() const override
    {
        core::IndexedMesh mesh = honest_->to_indexed_mesh();
        if (was_cut_) spoil_(mesh);
        return mesh;
    }

    double noise() const override { return honest_->noise(); }
    void set_noise(double noise) override { honest_->set_noise(noise); }
    std::span<const core::Material> materials() const override { return honest_->materials(); }
    std::uint32_t add_material(const core::Material& material) override { return honest_->add_material(material); }

private:
    void find_section(const core::Plane& plane, core::PlaneSection& section) const override
    {
        core::section(*honest_, plane, section);
    }
    core::CutResult cut_by(const core::Plane& plane, const core::CutOptions& options) override
    {
        core::CutResult result = core::cut(std::move(honest_), plane, options);
        if (result.object) honest_ = std::move(result.object);
        for (auto* side : {&result.positive, &result.negative})
            for (auto& fragment : *side) fragment = std::make_unique<LyingObject>(std::move(fragment), spoil_, true);
        return result;
    }

    std::uint64_t buffers() const noexcept override { return serial_; }

    std::unique_ptr<core::Cuttable> honest_;
    Spoil spoil_;
    bool was_cut_;
    const std::uint64_t serial_ = core::new_buffers_serial();
};

class LyingBackend final : public core::Backend
{
public:
    LyingBackend(std::string name, Spoil spoil) : name_(std::move(name)), spoil_(std::move(spoil)) {}
    std::string name() const override { return name_; }

private:
    std::unique_ptr<core::Cuttable> make(core::ProvenMesh&& mesh, const core::PrepareOptions&) const override
    {
        return std::make_unique<LyingObject>(core::baseline::make_back_end()->prepare(std::move(mesh)).object, spoil_,
                                             false);
    }

    std::string name_;
    Spoil spoil_;
};

/// Adds a back end that lies in this way. Returns its name.
std::string add_liar(const Spoil& spoil)
{
    static int count = 0;
    std::string name = "liar/" + std::to_string(++count);
    core::add_back_end({name, true, false, [=] { return std::make_unique<LyingBackend>(name, spoil); }});
    return name;
}

/// The name of the report's back end, which this program adds once.
const std::string& honest()
{
    static const std::string name = [] {
        add_report_back_ends();
        return "baseline/remap";
    }();
    return name;
}

struct Compared
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

Compared compare_with(const Spoil& spoil, const core::TriangleSoup& soup, std::uint64_t depth = 1)
{
    ComparisonOptions options;
    options.planes = 12;
    options.depth = depth;
    Compared outcome;
    outcome.mesh = compare_mesh(test::mesh_of(soup), honest(), add_liar(spoil), options,
                                [&](const ComparisonRow& row) { outcome.rows.push_back(row); });
    return outcome;
}

/// A ball: its sections are convex, so that the baseline's fans are right.
core::TriangleSoup ball()
{
    return core::shapes::icosphere(1.0f, 6);
}

void flip_last_bit(float& value)
{
    value = std::bit_cast<float>(std::bit_cast<std::uint32_t>(value) ^ 1u);
}

core::TriangleGroup& cap_of(core::IndexedMesh& mesh)
{
    for (core::TriangleGroup& group : mesh.groups)
        if (group.kind == core::TriangleKind::cap) return group;
    ADD_FAILURE() << "there is no cap";
    return mesh.groups.front();
}

TEST(Comparison, FindsNothingWhereThereIsNothing)
{
    const Compared outcome = compare_with([](core::IndexedMesh&) {}, ball(), 3);
    EXPECT_TRUE(outcome.mesh.closed);
    EXPECT_TRUE(outcome.mesh.failures.empty());
    EXPECT_EQ(outcome.mesh.rows, outcome.rows.size());
    EXPECT_GT(outcome.cuts(), 36u);
    for (const ComparisonRow& row : outcome.rows) EXPECT_TRUE(row.failures.empty()) << row.failures.front();
}

TEST(Comparison, FindsOneBitOfOneAttribute)
{
    for (const Spoil& spoil :
         {Spoil([](core::IndexedMesh& m) { flip_last_bit(m.vertices[m.triangles[0][0]].uv.x); }),
          Spoil([](core::IndexedMesh& m) { flip_last_bit(m.vertices[m.triangles[0][1]].normal.y); }),
          Spoil([](core::IndexedMesh& m) { flip_last_bit(m.vertices[m.triangles[0][2]].position.z); }),
          Spoil([](core::IndexedMesh& m) { m.sources[0] += 1; })}) {
        const Compared outcome = compare_with(spoil, ball());
        EXPECT_EQ(outcome.rows_that_say("surface differs, positive side"), outcome.cuts());
        EXPECT_EQ(outcome.rows_that_say("surface differs, negative side"), outcome.cuts());
        for (const ComparisonRow& row : outcome.rows) EXPECT_EQ(row.surfaces_equal(), !row.was_cut());
    }
}

TEST(Comparison, FindsAMissingCapTriangle)
{
    const Compared outcome = compare_with(
        [](core::IndexedMesh& m) {
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
    const Compared outcome = compare_with(
        [](core::IndexedMesh& m) {
            const core::TriangleGroup& cap = cap_of(m);
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
    const Compared outcome = compare_with(
        [](core::IndexedMesh& m) {
            m.vertices[m.triangles[cap_of(m).first][0]].uv.y = std::numeric_limits<float>::infinity();
        },
        ball());
    EXPECT_EQ(outcome.rows_that_say("halfedge has 2 vertices with a number that is not finite"), outcome.cuts());
    EXPECT_EQ(outcome.rows_that_say("surface differs"), 0u);
}

TEST(Comparison, FindsNothingInABoxOfTheLargestFloats)
{
    core::TriangleSoup box = core::shapes::box({2, 2, 2}, {1, 1, 1});
    for (core::Vertex& v : box.vertices) v.position *= std::numeric_limits<float>::max();
    const Compared outcome = compare_with([](core::IndexedMesh&) {}, box);
    EXPECT_GT(outcome.cuts(), 0u);
    for (const ComparisonRow& row : outcome.rows)
        EXPECT_TRUE(row.failures.empty()) << row.piece << ": " << row.failures.front();
}

TEST(Comparison, FindsEqualCornersWrongSidesAndWrongVolumes)
{
    const Compared equal = compare_with(
        [](core::IndexedMesh& m) { m.vertices[m.triangles[0][0]].position = m.vertices[m.triangles[0][1]].position; },
        ball());
    EXPECT_EQ(equal.rows_that_say("with equal corners"), equal.cuts());
    const Compared far =
        compare_with([](core::IndexedMesh& m) { m.vertices[m.triangles[0][0]].position *= -3.0f; }, ball());
    EXPECT_GT(far.rows_that_say("is on the wrong side by"), 0u);
    const Compared volume = compare_with(
        [](core::IndexedMesh& m) {
            for (core::Vertex& v : m.vertices) v.position *= 1.0f + 0x1p-18f;
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
    compare_mesh(test::mesh_of(core::shapes::pipe(1.0f, 0.5f, 2.0f, 64, 3)), honest(), honest(), options,
                 [&](const ComparisonRow& row) { rows.push_back(row); });
    ASSERT_EQ(rows.size(), 1u);
    EXPECT_EQ(rows[0].loops, 2u);
    EXPECT_FALSE(rows[0].fan_fits);
    EXPECT_NEAR(rows[0].baseline.cap_excess / rows[0].section_area, 2.0 * 0.25 / 0.75, 1e-6);
    EXPECT_FALSE(rows[0].section_intersects_itself);
}

TEST(ComparisonPlanes, DependOnTheSurfaceAndTheSeedOnly)
{
    const FlatMesh mesh = flat(test::mesh_of(core::shapes::torus(1.0f, 0.4f, 20, 12)));
    FlatMesh turned = mesh;
    for (Triangle& t : turned.triangles) t = {t[1], t[2], t[0]};
    const SurfaceKeys a(mesh), b(turned);
    std::size_t through_vertices = 0, other_seed_agrees = 0;
    for (std::uint64_t i = 0; i < 64; ++i) {
        const ChosenPlane p = choose_plane(a, PlaneMix::nasty, i, 3), q = choose_plane(b, PlaneMix::nasty, i, 3);
        EXPECT_EQ(p.kind, q.kind);
        EXPECT_EQ(p.plane, q.plane);
        bool meets_vertex = false;
        for (const Vertex& v : mesh.vertices)
            meets_vertex = meets_vertex || std::abs(p.plane.distance(v.position)) < 1e-12;
        if (meets_vertex) ++through_vertices;
        const ChosenPlane other = choose_plane(a, PlaneMix::nasty, i, 4);
        if (i >= 4 && other.plane.offset() == p.plane.offset()) ++other_seed_agrees;
        EXPECT_EQ(choose_plane(a, PlaneMix::random, i, 3).kind, "random");
    }
    EXPECT_GT(through_vertices, 40u);
    EXPECT_LT(other_seed_agrees, 8u);
}

Outline loop(std::initializer_list<glm::vec2> points)
{
    Outline made;
    for (const glm::vec2& p : points) made.points.emplace_back(p, 0.5f);
    return made;
}

TEST(SectionFacts, MeasureAreaAndLength)
{
    const std::vector<Outline> ring{loop({{0, 0}, {4, 0}, {4, 4}, {0, 4}}), loop({{1, 1}, {1, 2}, {2, 2}, {2, 1}})};
    const SectionFacts facts = measure_section(ring, {0, 0, 1});
    EXPECT_DOUBLE_EQ(facts.area, 15.0);
    EXPECT_DOUBLE_EQ(facts.length, 20.0);
    EXPECT_EQ(facts.loops, 2u);
    EXPECT_DOUBLE_EQ(measure_section(ring, {0, 0, -1}).area, -15.0);
}

TEST(SectionFacts, TellWhatWindsBackwardsOrTwice)
{
    const glm::dvec3 up{0, 0, 1};
    const Outline square = loop({{0, 0}, {4, 0}, {4, 4}, {0, 4}}), hole = loop({{1, 1}, {1, 2}, {2, 2}, {2, 1}}),
                  shifted = loop({{3, 3}, {7, 3}, {7, 7}, {3, 7}}), bow = loop({{0, 0}, {2, 2}, {2, 0}, {0, 2}});
    const auto facts = [&](const std::vector<Outline>& loops) { return measure_winding(steps_of(loops), up).value(); };
    EXPECT_NEAR(facts({square, hole}).backward, 0.0, 1e-12);
    EXPECT_NEAR(facts({square, hole}).multiple, 0.0, 1e-12);
    EXPECT_NEAR(facts({hole}).backward, 1.0, 1e-12);
    EXPECT_NEAR(facts({square, shifted}).multiple, 1.0, 1e-12);
    EXPECT_NEAR(facts({bow}).backward, 1.0, 1e-12);
    // A slanted plane: areas are those in the plane.
    Outline slanted = hole;
    for (glm::vec3& p : slanted.points) p.z = p.x;
    EXPECT_NEAR(measure_winding(steps_of(std::vector{slanted}), glm::normalize(glm::dvec3(-1, 0, 1)))->backward,
                std::sqrt(2.0), 1e-12);
}

/// {n / 2}: every edge crosses nearly every other one.
Outline star(int points)
{
    Outline made;
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
core::TriangleSoup prism(const Outline& loop)
{
    core::TriangleSoup soup;
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
    core::TriangleSoup soup = prism(loop({{-4, -4}, {-4, 4}, {4, 4}, {4, -4}}));
    // A bow tie of lobes with areas 2 and 0.5.
    const core::TriangleSoup tie = prism(loop({{-2, -1}, {-2, 1}, {1, -0.5f}, {1, 0.5f}}));
    const auto first = static_cast<std::uint32_t>(soup.vertices.size());
    soup.vertices.insert(soup.vertices.end(), tie.vertices.begin(), tie.vertices.end());
    for (const auto& [a, b, c] : tie.triangles) soup.triangles.push_back({a + first, b + first, c + first});

    Result<Object> object = prepare(test::mesh_of(soup));
    ASSERT_TRUE(object) << object.reason();
    kerf::CutOptions options;
    options.cap_material = object->add_material({"cap"});
    const glm::dvec3 up{0, 1, 0};
    Cut result = cut(*std::move(object), kerf::Plane::y(0.0).value(), options);
    ASSERT_EQ(result.status, kerf::Status::done);
    const Object& below = *result.one(kerf::Side::negative);
    EXPECT_NEAR(measure_winding(steps_of(outlines_of(below)), up)->backward, 0.0, 1e-9);
    const auto sections = sections_of_solids(flat(below), options.cap_material);
    ASSERT_EQ(sections.size(), 2u);
    EXPECT_NEAR(measure_winding(sections[0], up)->backward + measure_winding(sections[1], up)->backward, 0.5, 1e-6);
}

// Loops of open shells, too, are covered solid by solid: two that run along one another in opposite directions cancel
// in the section, and each has a cap.
TEST(Comparison, FindsNothingInOpenSoupsWhoseLoopsCancel)
{
    ComparisonOptions options;
    options.planes = 4;
    std::size_t cuts = 0, cancelling = 0;
    for (std::uint32_t seed = 0; seed < 1000; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        std::mt19937 random(seed);
        core::TriangleSoup soup;
        for (const glm::vec3& p : {glm::vec3(0, 0, 0), glm::vec3(1, 0, 0), glm::vec3(0, 1, 0), glm::vec3(0, 0, 1)})
            soup.vertices.push_back({p, glm::vec3(0, 0, 1), glm::vec2(0.0f)});
        for (auto i = 3 + random() % 7; i > 0; --i) {
            std::array<std::uint32_t, 4> points{0, 1, 2, 3};
            std::shuffle(points.begin(), points.end(), random);
            soup.triangles.push_back({points[0], points[1], points[2]});
        }
        const Mesh mesh = test::mesh_of(soup);
        compare_mesh(mesh, honest(), "halfedge", options, [&](const ComparisonRow& row) {
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
    const auto spoil = [](core::IndexedMesh& m) { m.vertices[m.triangles[cap_of(m).first][0]].position.x += 3.0f; };
    compare_mesh(test::mesh_of(prism(star(2001))), honest(), add_liar(spoil), options,
                 [&](const ComparisonRow& row) { rows.push_back(row); });
    ASSERT_EQ(rows.size(), 1u);
    ASSERT_TRUE(rows[0].was_cut());
    EXPECT_FALSE(rows[0].cap_fits);
    EXPECT_FALSE(rows[0].section_is_judged);
}

TEST(Comparison, VolumesThatCancelAreJudgedByTheSurface)
{
    // Two balls in one another, inside and outside: no volume to be relative to.
    core::TriangleSoup soup = ball();
    const std::size_t count = soup.triangles.size();
    const auto vertices = static_cast<std::uint32_t>(soup.vertices.size());
    for (std::uint32_t v = 0; v < vertices; ++v) soup.vertices.push_back(core::Vertex(soup.vertices[v]));
    for (std::size_t t = 0; t < count; ++t) {
        const auto [a, b, c] = soup.triangles[t];
        soup.triangles.push_back({a + vertices, c + vertices, b + vertices});
    }
    const Mesh mesh = test::mesh_of(soup);
    ComparisonOptions options;
    options.planes = 12;
    Compared outcome;
    const ComparedMesh compared =
        compare_mesh(mesh, honest(), honest(), options, [&](const ComparisonRow& row) { outcome.rows.push_back(row); });
    EXPECT_GT(outcome.cuts(), 8u);
    EXPECT_EQ(outcome.rows_that_say("volume error"), 0u);
    EXPECT_TRUE(compared.closed);
    EXPECT_LT(std::abs(compared.volume), 1e-9);
    EXPECT_GT(compared.judged_volume, 0.1);
}

TEST(Comparison, SaysThatRepairOpenedTheMesh)
{
    core::TriangleSoup sheet = ball();
    sheet.triangles.pop_back();
    const Mesh mesh = test::mesh_of(sheet);
    const auto failures_of = [&](bool was_closed) {
        ComparisonOptions options;
        options.planes = 1;
        options.was_closed = was_closed;
        return compare_mesh(mesh, honest(), honest(), options, [](const ComparisonRow&) {}).failures;
    };
    EXPECT_EQ(failures_of(true),
              std::vector<std::string>{"was closed before it was repaired and has 3 open edges now"});
    EXPECT_TRUE(failures_of(false).empty());
}

TEST(Comparison, FindsAWarningThatIsMissing)
{
    // The fan's centre outside the section, and nothing said of it.
    const Compared outcome = compare_with(
        [](core::IndexedMesh& m) {
            m.vertices[m.triangles[cap_of(m).first][0]].position += glm::vec3(9.0f, 9.0f, 9.0f);
        },
        ball());
    EXPECT_GT(outcome.rows_that_say("halfedge does not say that its caps exceed the section by"), 0u);
}

TEST(OpenEdges, AreEdgesWithoutAReverse)
{
    FlatMesh mesh = flat(test::mesh_of(core::shapes::icosphere(1.0f, 3)));
    EXPECT_EQ(open_edges(mesh), 0u);
    const Triangle last = mesh.triangles.back();
    mesh.triangles.pop_back();
    EXPECT_EQ(open_edges(mesh), 3u);
    mesh.triangles.push_back({last[0], last[2], last[1]});
    EXPECT_EQ(open_edges(mesh), 6u);
}

}  // namespace
}  // namespace kerf::tools
