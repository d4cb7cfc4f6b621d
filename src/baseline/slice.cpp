#include "baseline/slice.h"

#include <algorithm>

#include "baseline/fan.h"
#include "baseline/vertex_lookup.h"
#include "linear/partial_cut.h"
#include "linear/remap_slicer.h"
#include "linear/slicing_steps.h"

namespace kerf::core::baseline {

using namespace linear;

namespace {

/// The report's way: each vertex of each triangle is looked up.
template <class Lookup>
class LookupSlicer : public linear::Slicer<LookupSlicer<Lookup>>
{
    using Base = linear::Slicer<LookupSlicer<Lookup>>;
    using Base::builders_, Base::classes_, Base::crossings_, Base::mesh_;

public:
    using Base::Base;

    void classify_vertices()
    {
        classes_.classify(this->whole_, this->plane_, [](std::uint32_t, std::uint8_t) {});
    }

    void distribute(std::uint32_t g)
    {
        const TriangleGroup& group = mesh_.groups[g];
        for (std::uint32_t i = group.first; i < group.first + group.count; ++i) {
            const std::uint8_t c = this->class_of(mesh_.triangles[i]);
            if (c == kCrossing)
                crossings_.triangles.push_back({i, g, 0, 0, {}});
            else
                this->add_untouched(i, c == kBelow ? Side::negative : Side::positive);
        }
    }

    void expect_cut_points(std::size_t) {}

    Lookup& lookup(Side side) { return lookups_[side]; }

private:
    BySide<Lookup> lookups_{Lookup(builders_[Side::negative]), Lookup(builders_[Side::positive])};
};

}  // namespace

Slices slice(const Fragment& whole, const Plane& plane, const CutOptions& options, VertexLookup lookup)
{
    if (const std::optional<Side> side = missed_by_bounds(whole, plane)) return missed_slices(whole, *side);
    FanClosing fan;
    if (options.only)
        return cut_only(whole, plane, options, fan, [&](const Fragment& fragment, const CutOptions& asked) {
            return slice(fragment, plane, asked, lookup);
        });
    switch (lookup) {
        case VertexLookup::scan:
            return LookupSlicer<ScanLookup>(whole, plane, options, fan).run();
        case VertexLookup::two_bucket_hash:
            return LookupSlicer<DictionaryLookup<TwoValuedHash>>(whole, plane, options, fan).run();
        case VertexLookup::hash:
            return LookupSlicer<DictionaryLookup<ProperHash>>(whole, plane, options, fan).run();
        case VertexLookup::remap:
            return RemapSlicer(whole, plane, options, fan).run();
    }
    return {};
}

}  // namespace kerf::core::baseline
