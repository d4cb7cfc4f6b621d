#include "tools/comparison.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>
#include <stdexcept>
#include <utility>

#include <kerf/cut.h>
#include "common/support/stopwatch.h"
#include "tools/mesh_measures.h"
#include "tools/open_edges.h"
#include "tools/section_facts.h"
#include "tools/text.h"

namespace kerf::tools {

namespace {

/// Planes that are tried when they miss a piece.
constexpr std::uint64_t kTries = 4;

/// How far from the plane, in units in the last place of the mesh's largest coordinate, a piece may reach
/// (docs/floating-point.md: plane noise).
constexpr double kNoiseInUnits = 4.0;

/// One unit in the last place of the largest coordinate, mesh units.
double unit_of(const Bounds& bounds)
{
    float largest = 0.0f;
    for (int axis = 0; axis < 3; ++axis)
        largest = std::max({largest, std::abs(bounds.lo[axis]), std::abs(bounds.hi[axis])});
    const float above = std::nextafter(largest, std::numeric_limits<float>::infinity());
    return std::isinf(above) ? double(largest) - double(std::nextafter(largest, 0.0f))
                             : double(above) - double(largest);
}

constexpr std::array kBothSides{Side::positive, Side::negative};

/// The positive and the negative piece of one back end.
struct Halves
{
    Cut result;
    std::array<FlatMesh, 2> mesh;

    Object& fragment(std::size_t side) { return *result.one(kBothSides[side]); }
};

bool is_cut(const Cut& result)
{
    return ok(result.status);
}

/// An independent copy. @throws std::runtime_error
Object copy_of(const Object& object)
{
    Result<Object> copy = object.clone();
    if (!copy) throw std::runtime_error("there is not enough memory to compare the back ends");
    return *std::move(copy);
}

class Comparison
{
public:
    Comparison(const ComparisonOptions& options, const std::function<void(const ComparisonRow&)>& take_row,
               ComparedMesh& summary, double unit, std::uint32_t first_cap_material)
        : options_(options), take_row_(take_row), summary_(summary), unit_(unit), first_cap_(first_cap_material)
    {
    }

    /// One cut of the whole by plane `number`, and of its pieces.
    void run(const Object& baseline, const Object& halfedge, const SurfaceKeys& surface, double volume,
             std::uint64_t number)
    {
        ComparisonRow row;
        row.number = number;
        row.plane = choose_plane(surface, options_.mix, number, options_.seed);
        descend(row, copy_of(baseline), copy_of(halfedge), volume);
    }

private:
    /// The cut that `row` names, and those of its pieces. Gives objects that the plane misses back.
    std::array<Object, 2> descend(ComparisonRow row, Object baseline, Object halfedge, double volume)
    {
        // Pieces of a piece hang together by the caps of earlier cuts as well, which are each back end's own.
        std::array<Object, 2> whole;
        if (row.piece.empty()) whole = {copy_of(baseline), copy_of(halfedge)};
        Halves a = cut_once(std::move(baseline), row, row.baseline);
        Halves b = cut_once(std::move(halfedge), row, row.halfedge);
        judge(row, a, b, volume);
        if (row.piece.empty() && row.was_cut() && row.surfaces_equal()) judge_pieces(row, std::move(whole));
        ++summary_.rows;
        if (!row.failures.empty()) ++summary_.failed_rows;
        take_row_(row);
        if (!is_cut(a.result) && !is_cut(b.result)) return {std::move(a.result.object), std::move(b.result.object)};

        const bool go_on = is_cut(a.result) && is_cut(b.result) && row.surfaces_equal();
        if (go_on && row.piece.size() + 1 < options_.depth)
            for (std::size_t side = 0; side < 2; ++side) cut_piece(row, a, b, side);
        return {};
    }

    void cut_piece(const ComparisonRow& whole, Halves& a, Halves& b, std::size_t side)
    {
        const SurfaceKeys surface(a.mesh[side]);
        if (surface.sorted().empty()) return;
        const double volume = volume_of(a.mesh[side]);
        Object baseline = std::move(a.fragment(side)), halfedge = std::move(b.fragment(side));
        ComparisonRow row;
        row.number = whole.number;
        row.earlier_caps_fit = whole.earlier_caps_fit && whole.fan_fits && whole.cap_fits;
        row.earlier_normals = whole.earlier_normals;
        row.earlier_normals.push_back(to_glm(whole.plane.plane.normal()));
        row.piece = whole.piece + (side == 0 ? '+' : '-');
        // A path of +- as a binary number tells pieces apart; so do tries.
        std::uint64_t place = 1;
        for (const char c : row.piece) place = 2 * place + (c == '+' ? 1 : 0);
        const std::uint64_t seed = options_.seed + whole.number * 0x9e3779b97f4a7c15ull;
        for (std::uint64_t attempt = 0; attempt < kTries && baseline && halfedge; ++attempt) {
            row.plane = choose_plane(surface, options_.mix, whole.number + place + attempt, seed + (place << 8));
            auto back = descend(row, std::move(baseline), std::move(halfedge), volume);
            baseline = std::move(back[0]);
            halfedge = std::move(back[1]);
        }
    }

    Halves cut_once(Object object, const ComparisonRow& row, BackEndRow& facts)
    {
        CutOptions options;
        options.cap_material = first_cap_ + static_cast<std::uint32_t>(row.piece.size());
        Halves halves;
        core::Stopwatch watch;
        halves.result = cut(std::move(object), row.plane.plane, options);
        facts.ms = watch.lap();
        facts.status = halves.result.status;
        facts.says_caps_exceed = halves.result.caps_exceed_section;
        facts.crossing = halves.result.statistics().crossing_triangles;
        if (facts.status == Status::out_of_memory)
            throw std::runtime_error("there is not enough memory to compare the back ends");
        if (!is_cut(halves.result)) return halves;
        for (std::size_t side = 0; side < 2; ++side) {
            const FlatMesh& mesh = halves.mesh[side] = flat(halves.fragment(side));
            facts.triangles[side] = mesh.triangles.size();
            facts.open_edges += open_edges(mesh);
            facts.degenerate_triangles += degenerate_triangles(mesh);
            facts.lost_numbers += vertices_without_number(mesh);
            facts.cap_area[side] = cap_area_of(mesh, options.cap_material, to_glm(row.plane.plane.normal()));
            facts.overhang = std::max(facts.overhang, overhang_of(mesh, row.plane.plane, side == 0 ? 1.0 : -1.0));
        }
        return halves;
    }

    /// Everything that the meshes of both back ends say, and what of it must not be. `volume` is the object's.
    void judge(ComparisonRow& row, Halves& a, Halves& b, double volume)
    {
        const auto fail = [&](std::string clause) { row.failures.push_back(std::move(clause)); };
        // With a cap that covers what it should not, a piece has another shape: further planes may meet it elsewhere.
        if (row.baseline.status != row.halfedge.status && row.earlier_caps_fit && !only_a_sliver_is_cut(row, a, b))
            fail("status " + std::string(outcome_name(row.baseline.status)) + " and " +
                 std::string(outcome_name(row.halfedge.status)));
        if (!is_cut(a.result) || !is_cut(b.result)) return;
        // Caps of earlier cuts cross, too, and are other triangles in each back end.
        if (row.piece.empty() && row.baseline.crossing != row.halfedge.crossing)
            fail(grouped(row.baseline.crossing) + " and " + grouped(row.halfedge.crossing) + " crossing triangles");

        for (std::size_t side = 0; side < 2; ++side) {
            row.surface[side] = compare_surfaces(SurfaceKeys(a.mesh[side]), SurfaceKeys(b.mesh[side]));
            const SurfaceDifference& difference = row.surface[side];
            const std::string name = side == 0 ? "positive" : "negative";
            if (difference.other_layout)
                fail("streams or materials differ, " + name + " side");
            else if (!difference.none())
                fail("surface differs, " + name + " side: " + grouped(difference.only_first) +
                     " triangles of baseline, " + grouped(difference.only_second) + " of halfedge");
        }
        judge_section(row, a, b);
        row.outline = flat_loops(outlines_of(b.fragment(0)), to_glm(row.plane.plane.normal()));
        look_at_cap(row, row.baseline, a.mesh[1], row.fan_fits);
        look_at_cap(row, row.halfedge, b.mesh[1], row.cap_fits);
        judge_back_end(row, "baseline", row.baseline, a, volume);
        judge_back_end(row, "halfedge", row.halfedge, b, volume);
    }

    /// Takes the sides apart and compares their pieces.
    void judge_pieces(ComparisonRow& row, std::array<Object, 2> objects)
    {
        const auto a = pieces_of(std::move(objects[0]), row.plane.plane),
                   b = pieces_of(std::move(objects[1]), row.plane.plane);
        row.pieces_equal = are_alike(a[0], b[0]) && are_alike(a[1], b[1]);
        if (!row.pieces_equal)
            row.failures.push_back("pieces differ: " + std::to_string(a[0].size()) + " and " +
                                   std::to_string(a[1].size()) + " of baseline, " + std::to_string(b[0].size()) +
                                   " and " + std::to_string(b[1].size()) + " of halfedge, or others");
    }

    /// The pieces of the positive and of the negative side.
    std::array<std::vector<FlatMesh>, 2> pieces_of(Object object, const Plane& plane) const
    {
        CutOptions options;
        options.components = true;
        options.cap_material = first_cap_;
        Cut result = cut(std::move(object), plane, options);
        if (result.status == Status::out_of_memory)
            throw std::runtime_error("there is not enough memory to compare the back ends");
        std::array<std::vector<FlatMesh>, 2> pieces;
        for (std::size_t side = 0; side < 2; ++side)
            for (std::size_t i = 0; const Object* piece = result.piece(kBothSides[side], i); ++i)
                pieces[side].push_back(flat(*piece));
        return pieces;
    }

    /// Whether the pieces have the same surface triangles, in whatever order they come.
    static bool are_alike(const std::vector<FlatMesh>& first, const std::vector<FlatMesh>& second)
    {
        if (first.size() != second.size()) return false;
        const auto sorted_keys = [](const std::vector<FlatMesh>& pieces) {
            std::vector<SurfaceKeys> keys(pieces.begin(), pieces.end());
            std::sort(keys.begin(), keys.end(), [](const SurfaceKeys& a, const SurfaceKeys& b) {
                return std::lexicographical_compare(
                    a.sorted().begin(), a.sorted().end(), b.sorted().begin(), b.sorted().end(),
                    [](const SurfaceKeys::Key& p, const SurfaceKeys::Key& q) { return p.hash < q.hash; });
            });
            return keys;
        };
        const std::vector<SurfaceKeys> a = sorted_keys(first), b = sorted_keys(second);
        for (std::size_t i = 0; i < a.size(); ++i)
            if (!compare_surfaces(a[i], b[i]).none()) return false;
        return true;
    }

    /// What is said of caps, not judged. Those of both fragments are alike.
    void look_at_cap(const ComparisonRow& row, BackEndRow& facts, const FlatMesh& negative, bool fits)
    {
        const auto material = first_cap_ + static_cast<std::uint32_t>(row.piece.size());
        facts.cap = flat_cap(negative, material, to_glm(row.plane.plane.normal()));
        facts.least_angle = least_angle(facts.cap);
        if (!fits) facts.overlap = overlap_area(facts.cap);
    }

    /// Where earlier caps meet in a thin edge they have other triangles in each back end. One may so keep a splinter
    /// beyond the plane that is no thicker than what cut points are rounded to, and the other nothing.
    bool only_a_sliver_is_cut(const ComparisonRow& row, const Halves& a, const Halves& b) const
    {
        const bool one_missed = is_cut(a.result) != is_cut(b.result) &&
                                (row.baseline.status == Status::missed || row.halfedge.status == Status::missed);
        if (row.piece.empty() || !one_missed) return false;
        const Halves& halves = is_cut(a.result) ? a : b;
        return std::any_of(halves.mesh.begin(), halves.mesh.end(), [&](const FlatMesh& side) {
            return std::abs(volume_of(side)) <= kNoiseInUnits * unit_ * area_of(side);
        });
    }

    void judge_section(ComparisonRow& row, Halves& a, Halves& b)
    {
        const glm::dvec3 normal = to_glm(row.plane.plane.normal());
        const std::vector<Outline> loops = outlines_of(b.fragment(0));
        const SectionFacts section = measure_section(loops, normal),
                           other = measure_section(outlines_of(a.fragment(0)), normal);
        row.section_area = section.area;
        row.loops = section.loops;
        row.open_chains = section.open_chains;

        // Corners of caps are off the plane by up to a unit in the last place: slivers along the outline may be turned.
        const double tolerance = std::max(kAgreement * std::abs(section.area), unit_ * section.length);
        const auto expect_area = [&](const char* whose, double said, double area, double allowed) {
            if (!(std::abs(said - area) <= allowed))
                row.failures.push_back(std::string(whose) + " section area " + rounded(said) + " instead of " +
                                       rounded(area));
        };
        expect_area("baseline's stated", a.result.section_area, other.area, std::max(tolerance, unit_ * other.length));
        expect_area("halfedge's stated", b.result.section_area, section.area, tolerance);
        // Caps of earlier cuts are off their planes by a unit, differently in each back end: that moves the line where
        // this plane meets them by a unit over the sine of the angle.
        double sine = 1.0;
        for (const glm::dvec3& earlier : row.earlier_normals)
            sine = std::min(sine, glm::length(glm::cross(earlier, normal)));
        // Parallel planes meet in no line; what lies between them is no thicker than rounding.
        if (row.piece.empty()) {
            // The outline is the same in each back end, and divided alike.
            expect_area("baseline's", a.result.section_area, b.result.section_area, 0.0);
            if (section.loops != other.loops || section.open_chains != other.open_chains)
                row.failures.push_back(counted(other.loops, "loop") + " and " + counted(other.open_chains, "chain") +
                                       " of baseline, " + counted(section.loops, "loop") + " and " +
                                       counted(section.open_chains, "chain") + " of halfedge");
        } else if (row.earlier_caps_fit && sine > 0.0) {
            expect_area("baseline's", other.area, section.area,
                        tolerance + 2.0 * unit_ * std::max(section.length, other.length) / sine);
        }

        double target = section.area;
        const auto measure_caps = [&] {
            for (BackEndRow* facts : {&row.baseline, &row.halfedge}) {
                facts->cap_excess = 0.0;
                for (const double cap : facts->cap_area)
                    if (std::abs(cap - target) > std::abs(facts->cap_excess)) facts->cap_excess = cap - target;
            }
            row.fan_fits = std::abs(row.baseline.cap_excess) <= tolerance;
            row.cap_fits = std::abs(row.halfedge.cap_excess) <= tolerance;
        };
        measure_caps();
        judge_warning(row, "baseline", row.baseline, other);
        judge_warning(row, "halfedge", row.halfedge, section);
        if (!row.cap_fits) {
            // Where loops wind backwards, around holes of an open mesh, caps cover that, too.
            const std::optional<WindingFacts> winding = winding_of_solids(row, b.mesh[1], loops);
            row.section_is_judged = winding.has_value();
            if (winding) {
                row.section_intersects_itself = winding->backward > tolerance || winding->multiple > tolerance;
                target += 2.0 * winding->backward;
                measure_caps();
            }
        }
        row.covered_area = target;
        row.judged_area = tolerance / kAgreement;
        row.section_is_speck = std::abs(target) <= tolerance;
        // An edge is led over a point that is as near as rounding moves points: what that costs the result must say,
        // but for what is close to the limit.
        const double units = row.halfedge.says_caps_exceed ? kNoiseInUnits : 2.0;
        const bool is_rounding = std::abs(row.halfedge.cap_excess) <= units * unit_ * section.length;
        if (!row.cap_fits && !is_rounding && row.section_is_judged && !row.section_intersects_itself)
            row.failures.push_back("half-edge cap area off by " + rounded(row.halfedge.cap_excess));
        const double apart = std::abs(row.baseline.cap_excess - row.halfedge.cap_excess);
        if (options_.caps_alike && row.earlier_caps_fit && apart > tolerance && !is_rounding)
            row.failures.push_back("cap areas differ by " + rounded(apart));
    }

    /// Solids are capped one by one, and so they wind around: what one of them does backwards can lie in another.
    /// Nothing where that takes too many looks.
    std::optional<WindingFacts> winding_of_solids(const ComparisonRow& row, const FlatMesh& negative,
                                                  std::span<const Outline> loops) const
    {
        std::vector<std::vector<SectionStep>> sections =
            sections_of_solids(negative, first_cap_ + static_cast<std::uint32_t>(row.piece.size()));
        if (!summary_.closed) {
            // What bounds an open surface need not be its section. No solid has all of a loop where a part vanished.
            auto kept = keep_loops(sections, loops);
            sections = kept ? std::move(*kept) : std::vector<std::vector<SectionStep>>{steps_of(loops)};
        }
        WindingFacts sum;
        for (const std::vector<SectionStep>& section : sections) {
            const std::optional<WindingFacts> winding = measure_winding(section, to_glm(row.plane.plane.normal()));
            if (!winding) return std::nullopt;
            sum.backward += winding->backward;
            sum.multiple += winding->multiple;
        }
        return sum;
    }

    /// A result must say that its caps cover more than its section where they do, and nowhere else; either is right
    /// close to the limit.
    void judge_warning(ComparisonRow& row, const std::string& name, const BackEndRow& facts,
                       const SectionFacts& section) const
    {
        const double tolerance = std::max(kAgreement * std::abs(section.area), unit_ * section.length);
        const auto [least, most] = std::minmax(facts.cap_area[0], facts.cap_area[1]);
        if (facts.says_caps_exceed && most - section.area < 0.5 * tolerance)
            row.failures.push_back(name + " says that its caps exceed the section, by " + rounded(most - section.area));
        if (!facts.says_caps_exceed && least - section.area > 2.0 * tolerance)
            row.failures.push_back(name + " does not say that its caps exceed the section by " +
                                   rounded(least - section.area));
    }

    void judge_back_end(ComparisonRow& row, const std::string& name, BackEndRow& facts, Halves& halves, double volume)
    {
        const auto fail = [&](const std::string& clause) { row.failures.push_back(name + " " + clause); };
        if (facts.degenerate_triangles > 0)
            fail("has " + counted(facts.degenerate_triangles, "triangle") + " with equal corners");
        if (facts.lost_numbers > 0)
            fail("has " + (facts.lost_numbers == 1 ? "1 vertex" : grouped(facts.lost_numbers) + " vertices") +
                 " with a number that is not finite");
        if (!(facts.overhang <= kNoiseInUnits * unit_)) fail("is on the wrong side by " + rounded(facts.overhang));
        if (!summary_.closed) return;
        if (facts.open_edges > 0) fail("has " + counted(facts.open_edges, "open edge"));
        const double scale = summary_.judged_volume;
        double sum = 0.0;
        for (std::size_t side = 0; side < 2; ++side) {
            const double part = volume_of(halves.mesh[side]);
            sum += part;
            const double said = halves.fragment(side).mass_properties().volume;
            facts.volume_error = std::max(facts.volume_error, std::abs(said - part) / scale);
        }
        facts.volume_error = std::max(facts.volume_error, std::abs(sum - volume) / scale);
        if (!(facts.volume_error <= kAgreement)) fail("has a volume error of " + rounded(facts.volume_error));
    }

    const ComparisonOptions& options_;
    const std::function<void(const ComparisonRow&)>& take_row_;
    ComparedMesh& summary_;
    double unit_;              ///< unit in the last place of the largest coordinate, mesh units
    std::uint32_t first_cap_;  ///< material of the first cut's cap; every further cut in a row has the next one
};

Object prepared(const std::string& back_end, const Mesh& mesh, std::uint64_t cap_materials, double& ms)
{
    PrepareOptions options;
    options.back_end_name = back_end.c_str();
    core::Stopwatch watch;
    Result<Object> object = prepare(mesh, options);
    ms = watch.lap();
    if (!object) throw std::runtime_error(back_end + ": " + object.reason());
    // A material of its own for the caps of each cut in a row, so that a cut's own caps can be told from older ones.
    for (std::uint64_t i = 0; i < cap_materials; ++i)
        if (object->add_material({("cap of cut " + std::to_string(i + 1)).c_str()}) == kNone)
            throw std::runtime_error("there is not enough memory to compare the back ends");
    return *std::move(object);
}

}  // namespace

ComparedMesh compare_mesh(const Mesh& given, const std::string& baseline, const std::string& halfedge,
                          const ComparisonOptions& options, const std::function<void(const ComparisonRow&)>& take_row)
{
    const std::uint64_t depth = std::max<std::uint64_t>(options.depth, 1);
    FlatMesh mesh = flat(given);

    ComparedMesh summary;
    summary.triangles = mesh.triangles.size();
    const std::uint64_t open = open_edges(mesh);
    summary.closed = open == 0;
    if (options.was_closed && open > 0)
        summary.failures.push_back("was closed before it was repaired and has " + counted(open, "open edge") + " now");
    summary.volume = volume_of(mesh);
    const Object a = prepared(baseline, given, depth, summary.baseline_prepare_ms),
                 b = prepared(halfedge, given, depth, summary.halfedge_prepare_ms);

    for (std::size_t i = mesh.materials.size(); i < a.material_count(); ++i)
        mesh.materials.push_back({a.material(i).name, {1.0f, 1.0f, 1.0f, 1.0f}, {}});
    const SurfaceKeys surface(mesh);
    for (const auto& [name, object] : {std::pair{"baseline", &a}, {"halfedge", &b}}) {
        const FlatMesh copy = flat(*object);
        if (!compare_surfaces(surface, SurfaceKeys(copy)).none())
            summary.failures.push_back(std::string(name) + " changes the surface when it prepares");
    }
    const double unit = unit_of(mesh.bounds());
    summary.judged_volume = std::abs(summary.volume) + unit * area_of(mesh) / kAgreement;
    Comparison comparison(options, take_row, summary, unit, static_cast<std::uint32_t>(given.material_count()));
    for (std::uint64_t i = 0; i < options.planes; ++i)  // the last number may be the largest that there is
        comparison.run(a, b, surface, summary.volume, options.first_plane + i);
    return summary;
}

}  // namespace kerf::tools
