#include "linear/linear.h"

#include <utility>

#include "linear/fragment_object.h"
#include "linear/partial_cut.h"
#include "linear/remap_slicer.h"
#include "linear/right_caps.h"

namespace kerf::core::linear {

namespace {

class LinearObject final : public FragmentObject
{
public:
    using FragmentObject::FragmentObject;

    std::unique_ptr<Cuttable> clone() const override
    {
        return std::make_unique<LinearObject>(Fragment(fragment()), listener());
    }

private:
    CutResult cut_by(const Plane& plane, const CutOptions& options) override
    {
        return to_result(slice(plane, options),
                         [&](Fragment&& part) { return std::make_unique<LinearObject>(std::move(part), listener()); });
    }

    Slices slice(const Plane& plane, const CutOptions& options) const
    {
        if (const std::optional<Side> side = missed_by_bounds(fragment(), plane))
            return missed_slices(fragment(), *side);
        RightCaps caps;
        if (!options.only) return RemapSlicer(fragment(), plane, options, caps).run();
        return cut_only(fragment(), plane, options, caps, [&](const Fragment& whole, const CutOptions& asked) {
            RightCaps of_whole;
            return RemapSlicer(whole, plane, asked, of_whole).run();
        });
    }
};

class LinearBackend final : public Backend
{
public:
    std::string name() const override { return "linear"; }

private:
    std::unique_ptr<Cuttable> make(ProvenMesh&& mesh, const PrepareOptions& options) const override
    {
        return std::make_unique<LinearObject>(std::move(mesh), options.listener);
    }
};

}  // namespace

std::unique_ptr<Backend> make_back_end()
{
    return std::make_unique<LinearBackend>();
}

}  // namespace kerf::core::linear
