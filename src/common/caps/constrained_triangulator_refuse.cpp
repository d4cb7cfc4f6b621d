#include "common/caps/constrained_triangulator.h"

// In builds without CGAL: sections with holes go to the ways after these, which close them, cover too much, and say so.

namespace kerf::core {

namespace {

class RefusingTriangulator final : public CapTriangulator
{
public:
    bool triangulate(const CapOutline&, CapMesh&) override { return false; }
};

class RefusingRouteFinder final : public RouteFinder
{
public:
    bool find(std::span<const glm::dvec2>, std::span<const std::array<Index, 2>>, std::size_t, std::size_t,
              EdgeRoutes&) override
    {
        return false;
    }
};

}  // namespace

std::unique_ptr<CapTriangulator> make_constrained_triangulator()
{
    return std::make_unique<RefusingTriangulator>();
}

std::unique_ptr<RouteFinder> make_route_finder()
{
    return std::make_unique<RefusingRouteFinder>();
}

}  // namespace kerf::core
