#include "halfedge/halfedge.h"

#include "halfedge/fragment.h"

namespace kerf::halfedge {

namespace {

class HalfedgeBackend final : public Backend
{
public:
    std::string name() const override { return "halfedge"; }

private:
    std::unique_ptr<Cuttable> make(ProvenMesh mesh) const override
    {
        auto family = std::make_shared<Family>();
        const std::vector<ShellRoot> shells = prepare_universe(mesh, family->universe);
        family->make_room(mesh->triangles.size());
        return std::make_unique<Fragment>(std::move(family), shells, mesh->materials.size());
    }
};

}  // namespace

std::unique_ptr<Backend> make_backend()
{
    return std::make_unique<HalfedgeBackend>();
}

}  // namespace kerf::halfedge
