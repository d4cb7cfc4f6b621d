#include "halfedge/halfedge.h"

#include "halfedge/fragment.h"

namespace kerf::halfedge {

namespace {

class HalfedgeBackend final : public Backend
{
public:
    std::string name() const override { return "halfedge"; }

private:
    std::unique_ptr<Cuttable> make(IndexedMesh mesh) const override
    {
        const std::size_t material_count = mesh.materials.size();
        return std::make_unique<Fragment>(prepare_universe(std::move(mesh)), material_count);
    }
};

}  // namespace

std::unique_ptr<Backend> make_backend()
{
    return std::make_unique<HalfedgeBackend>();
}

}  // namespace kerf::halfedge
