#include "linear/linear.h"

#include <utility>

#include "linear/fragment_object.h"
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
        RightCaps caps;
        const std::optional<Side> missed = missed_by_bounds(fragment(), plane);
        return to_result(
            missed ? missed_slices(fragment(), *missed) : RemapSlicer(fragment(), plane, options, caps).run(),
            [&](Fragment&& part) { return std::make_unique<LinearObject>(std::move(part), listener()); });
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
