#include "baseline/baseline.h"

#include "baseline/report_costs.h"
#include "baseline/slice.h"
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

class BaselineCuttable final : public linear::FragmentObject
{
public:
    BaselineCuttable(ProvenMesh&& mesh, const BufferListener& listener, VertexLookup lookup)
        : FragmentObject(std::move(mesh), listener), lookup_(lookup)
    {
    }

    BaselineCuttable(Fragment&& fragment, const BufferListener& listener, VertexLookup lookup,
                     const ReportCosts& costs = {})
        : FragmentObject(std::move(fragment), listener), lookup_(lookup), costs_(costs)
    {
    }

    /// Of the cut that made it.
    const ReportCosts& costs() const { return costs_; }

    std::unique_ptr<Cuttable> clone() const override
    {
        return std::make_unique<BaselineCuttable>(Fragment(fragment()), listener(), lookup_);
    }

private:
    CutResult cut_by(const Plane& plane, const CutOptions& options) override
    {
        Slices slices = slice(fragment(), plane, options, lookup_);
        const ReportCosts costs{slices.vertex_comparisons};
        return linear::to_result(std::move(slices), [&](Fragment&& part) {
            return std::make_unique<BaselineCuttable>(std::move(part), listener(), lookup_, costs);
        });
    }

    VertexLookup lookup_;
    ReportCosts costs_;
};

class BaselineBackend final : public Backend
{
public:
    explicit BaselineBackend(VertexLookup lookup) : lookup_(lookup) {}

    std::string name() const override { return "baseline/" + std::string(name_of(lookup_)); }

private:
    std::unique_ptr<Cuttable> make(ProvenMesh&& mesh, const PrepareOptions& options) const override
    {
        return std::make_unique<BaselineCuttable>(std::move(mesh), options.listener, lookup_);
    }

    VertexLookup lookup_;
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

std::unique_ptr<Backend> make_back_end(VertexLookup lookup)
{
    if (lookup > VertexLookup::remap) lookup = VertexLookup::hash;
    return std::make_unique<BaselineBackend>(lookup);
}

}  // namespace kerf::core::baseline
