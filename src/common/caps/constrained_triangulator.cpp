#include "common/caps/constrained_triangulator.h"

#include <atomic>

#include "common/caps/nested_triangulator.h"

// Without CGAL sections are closed with patience, however they wind and nest. Those that cross themselves go to the ways
// after these, which close them, cover too much, and say so.

namespace kerf::core {

namespace {

class RefusingRouteFinder final : public RouteFinder
{
public:
    bool find(std::span<const glm::dvec2>, std::span<const std::array<Index, 2>>, std::size_t, std::size_t,
              EdgeRoutes&) override
    {
        return false;
    }
};

constexpr ConstrainedWays kWithoutCgal{make_patient_triangulator, []() -> std::unique_ptr<RouteFinder> {
                                           return std::make_unique<RefusingRouteFinder>();
                                       }};

/// Initialised before any code runs, so that libraries may put theirs in place while the program starts.
constinit std::atomic<const ConstrainedWays*> ways_in_use = &kWithoutCgal;

}  // namespace

void use_constrained_ways(const ConstrainedWays* ways) noexcept
{
    ways_in_use.store(ways != nullptr ? ways : &kWithoutCgal, std::memory_order_release);
}

bool has_constrained_ways() noexcept
{
    return ways_in_use.load(std::memory_order_acquire) != &kWithoutCgal;
}

std::unique_ptr<CapTriangulator> make_constrained_triangulator()
{
    return ways_in_use.load(std::memory_order_acquire)->make_triangulator();
}

std::unique_ptr<RouteFinder> make_route_finder()
{
    return ways_in_use.load(std::memory_order_acquire)->make_route_finder();
}

}  // namespace kerf::core
