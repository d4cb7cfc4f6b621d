#include "baseline/baseline.h"

#include "baseline/fragment.h"
#include "baseline/report_costs.h"
#include "baseline/slice.h"
#include "common/cutting/back_end_helpers.h"
#include "common/mesh/mass_moments.h"
#include "common/mesh/plane_noise.h"
#include "common/mesh/support_points.h"
#include "common/support/stopwatch.h"

namespace kerf::baseline {

std::string_view name_of(VertexLookup lookup)
{
    switch (lookup) {
        case VertexLookup::scan:
            return "scan";
        case VertexLookup::two_bucket_hash:
            return "two_bucket_hash";
        case VertexLookup::hash:
            return "hash";
        case VertexLookup::remap:
            return "remap";
    }
    return "unknown";
}

namespace {

struct Method
{
    VertexLookup lookup;
    bool rewrite_pivots;
};

class BaselineCuttable final : public Cuttable
{
public:
    BaselineCuttable(Fragment&& fragment, Method method, const ReportCosts& costs = {})
        : fragment_(std::move(fragment)), method_(method), costs_(costs)
    {
    }

    /// Of the cut that made it.
    const ReportCosts& costs() const { return costs_; }

    std::unique_ptr<Cuttable> clone() const override
    {
        auto copy = std::make_unique<BaselineCuttable>(Fragment(fragment_), method_);
        return copy;
    }

    std::uint64_t triangle_count() const override { return fragment_.mesh.triangles.size(); }
    Box bounds() const override { return fragment_.bounds; }

    DrawView draw_view() const override
    {
        const IndexedMesh& mesh = fragment_.mesh;
        DrawView view;
        view.buffers = serial_;
        view.vertices = mesh.vertices;
        static_assert(sizeof(Triangle) == 3 * sizeof(std::uint32_t));
        view.indices = {reinterpret_cast<const std::uint32_t*>(mesh.triangles.data()), mesh.triangles.size() * 3};
        view.materials = mesh.materials;
        for (const TriangleGroup& group : mesh.groups)
            view.ranges.push_back({3 * group.first, 3 * group.count, group.material, group.kind});
        merge_ranges(view.ranges);
        if (!is_uploaded_) {
            view.new_vertex_bytes.push_back({0, view.vertices.size_bytes()});
            view.new_index_bytes.push_back({0, view.indices.size_bytes()});
        }
        return view;
    }

    void mark_uploaded() override { is_uploaded_ = true; }

    MassProperties mass_properties() const override
    {
        const glm::dvec3 reference = mass_reference(fragment_.bounds);
        return mass_moments(fragment_.mesh.vertices, fragment_.mesh.triangles, reference).properties(reference);
    }

    std::array<glm::vec3, kSupportDirections> support_points() const override
    {
        return kerf::support_points(fragment_.mesh.vertices);
    }
    std::span<const Vertex> used_vertices(std::vector<Vertex>&) const override { return fragment_.mesh.vertices; }

    std::span<const SectionLoop> section_loops() const override { return fragment_.section; }
    IndexedMesh to_indexed_mesh() const override { return fragment_.mesh; }

private:
    CutResult cut_by(const Plane& plane, const CutOptions& options) override
    {
        Slices slices = slice(fragment_, plane, options, method_.lookup);
        CutResult result;
        result.status = slices.status;
        result.side_of_object = slices.side_of_object;
        result.section_area = slices.section_area;
        result.caps_exceed_section = slices.caps_exceed_section;
        result.statistics = slices.statistics;
        if (slices.status == Status::missed) return result;

        ReportCosts costs{slices.vertex_comparisons, 0.0};
        if (method_.rewrite_pivots) costs.pivot_ms = rewrite_all(slices.positive) + rewrite_all(slices.negative);
        const auto hand_over = [&](std::vector<Fragment>& from, std::vector<std::unique_ptr<Cuttable>>& to) {
            for (Fragment& fragment : from)
                to.push_back(std::make_unique<BaselineCuttable>(std::move(fragment), method_, costs));
        };
        hand_over(slices.positive, result.positive);
        hand_over(slices.negative, result.negative);
        return result;
    }

    /// Runs the report's loop over the vertices of all fragments; what it writes is thrown away. Milliseconds.
    static double rewrite_all(const std::vector<Fragment>& fragments)
    {
        Stopwatch watch;
        for (const Fragment& fragment : fragments) {
            Buffer<Vertex> scratch;
            rewrite_around_pivot(fragment.mesh, scratch);
        }
        return watch.lap();
    }

    std::uint64_t buffers() const noexcept override { return serial_; }

    Fragment fragment_;
    Method method_;
    ReportCosts costs_;
    const std::uint64_t serial_ = new_buffers_serial();
    bool is_uploaded_ = false;
};

class BaselineBackend final : public Backend
{
public:
    explicit BaselineBackend(Method method) : method_(method) {}

    std::string name() const override { return "baseline/" + std::string(name_of(method_.lookup)); }

private:
    std::unique_ptr<Cuttable> make(ProvenMesh&& mesh) const override
    {
        Fragment fragment;
        fragment.mesh = *std::move(mesh);
        fragment.bounds = fragment.mesh.bounds();
        fragment.noise = plane_noise(fragment.bounds.largest_coordinate());
        return std::make_unique<BaselineCuttable>(std::move(fragment), method_);
    }

    Method method_;
};

}  // namespace

ReportCosts report_costs(const CutResult& result)
{
    const auto& some = result.positive.empty() ? result.negative : result.positive;
    if (some.empty()) return {};
    const auto* const fragment = dynamic_cast<const BaselineCuttable*>(some.front().get());
    return fragment ? fragment->costs() : ReportCosts{};
}

std::unique_ptr<Backend> make_back_end(VertexLookup lookup, bool rewrite_pivots)
{
    if (lookup > VertexLookup::remap) lookup = VertexLookup::hash;
    return std::make_unique<BaselineBackend>(Method{lookup, rewrite_pivots});
}

}  // namespace kerf::baseline
