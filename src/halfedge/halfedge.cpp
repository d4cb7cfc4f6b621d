#include "halfedge/halfedge.h"

#include "halfedge/cut/workspace_pool.h"
#include "halfedge/fragment.h"

namespace kerf::core::halfedge {

namespace {

class HalfedgeBackend final : public Backend
{
public:
    HalfedgeBackend(const char* name, CapQuality quality) : name_(name), quality_(quality) {}

    std::string name() const override { return name_; }

private:
    std::unique_ptr<Cuttable> make(ProvenMesh&& mesh, const PrepareOptions& options) const override
    {
        return make_beside(mesh, options);
    }

    std::unique_ptr<Cuttable> make_beside(const ProvenMesh& mesh, const PrepareOptions& options) const override
    {
        auto shared = std::make_shared<SharedUniverse>(options.listener, quality_);
        const std::vector<ShellRoot> shells = prepare_universe(mesh, shared->universe, options);
        make_room_for_cut(mesh->triangles.size());
        return std::make_unique<Fragment>(std::move(shared), shells, mesh->materials.size());
    }

    const char* name_;
    CapQuality quality_;
};

}  // namespace

std::unique_ptr<Backend> make_back_end()
{
    return std::make_unique<HalfedgeBackend>("halfedge", CapQuality::fast);
}

std::unique_ptr<Backend> make_back_end_with_cgal()
{
    return std::make_unique<HalfedgeBackend>("halfedge/cgal", CapQuality::delaunay);
}

}  // namespace kerf::core::halfedge
