#include "baseline/baseline.h"

#include "baseline/report_costs.h"
#include "baseline/slice.h"
#include "common/support/stopwatch.h"
#include "linear/fragment_object.h"

namespace kerf::core::baseline {

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

class BaselineCuttable final : public linear::FragmentObject
{
public:
    BaselineCuttable(Fragment&& fragment, const BufferListener& listener, Method method, const ReportCosts& costs = {})
        : FragmentObject(std::move(fragment), listener), method_(method), costs_(costs)
    {
    }

    /// Of the cut that made it.
    const ReportCosts& costs() const { return costs_; }

    std::unique_ptr<Cuttable> clone() const override
    {
        return std::make_unique<BaselineCuttable>(Fragment(fragment()), listener(), method_);
    }

private:
    CutResult cut_by(const Plane& plane, const CutOptions& options) override
    {
        Slices slices = slice(fragment(), plane, options, method_.lookup);
        ReportCosts costs{slices.vertex_comparisons, 0.0};
        if (method_.rewrite_pivots) costs.pivot_ms = rewrite_all(slices.positive) + rewrite_all(slices.negative);
        return linear::to_result(std::move(slices), [&](Fragment&& part) {
            return std::make_unique<BaselineCuttable>(std::move(part), listener(), method_, costs);
        });
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

    Method method_;
    ReportCosts costs_;
};

class BaselineBackend final : public Backend
{
public:
    explicit BaselineBackend(Method method) : method_(method) {}

    std::string name() const override { return "baseline/" + std::string(name_of(method_.lookup)); }

private:
    std::unique_ptr<Cuttable> make(ProvenMesh&& mesh, const PrepareOptions& options) const override
    {
        return std::make_unique<BaselineCuttable>(linear::fragment_of(std::move(mesh)), options.listener, method_);
    }

    Method method_;
};

}  // namespace

ReportCosts report_costs(const CutResult& result)
{
    const auto& some = result.positive.empty() ? result.negative : result.positive;
    return some.empty() ? ReportCosts{} : report_costs(*some.front());
}

ReportCosts report_costs(const Cuttable& fragment)
{
    const auto* const own = dynamic_cast<const BaselineCuttable*>(&fragment);
    return own != nullptr ? own->costs() : ReportCosts{};
}

std::unique_ptr<Backend> make_back_end(VertexLookup lookup, bool rewrite_pivots)
{
    if (lookup > VertexLookup::remap) lookup = VertexLookup::hash;
    return std::make_unique<BaselineBackend>(Method{lookup, rewrite_pivots});
}

}  // namespace kerf::core::baseline
