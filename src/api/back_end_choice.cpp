#include "api/back_end_choice.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <vector>

namespace kerf {

namespace {

/// So many triangles at least, evenly spread, or all.
template <class Function>
void for_each_looked(const core::IndexedMesh& mesh, std::size_t least, Function&& function)
{
    const std::size_t step = std::max<std::size_t>(mesh.triangles.size() / least, 1);
    for (std::size_t t = 0; t < mesh.triangles.size(); t += step) function(mesh.triangles[t]);
}

/// About how many triangles a plane through the middle crosses: the mean of the planes across the three axes.
double crossing_triangles(const core::IndexedMesh& mesh)
{
    constexpr std::size_t kLooked = 512;
    const auto corner = [&](std::uint32_t v) { return mesh.vertices[v].position; };
    glm::vec3 lo(std::numeric_limits<float>::infinity()), hi = -lo;
    std::size_t looked = 0, crossing = 0;
    for_each_looked(mesh, kLooked, [&](const core::Triangle& t) {
        for (const std::uint32_t v : t) {
            lo = glm::min(lo, corner(v));
            hi = glm::max(hi, corner(v));
        }
        ++looked;
    });
    const glm::vec3 middle = 0.5f * lo + 0.5f * hi;
    for_each_looked(mesh, kLooked, [&](const core::Triangle& t) {
        for (int axis = 0; axis < 3; ++axis) {
            const float a = corner(t[0])[axis], b = corner(t[1])[axis], c = corner(t[2])[axis];
            if (std::min({a, b, c}) < middle[axis] && std::max({a, b, c}) > middle[axis]) ++crossing;
        }
    });
    return double(crossing) / 3.0 / double(looked) * double(mesh.triangles.size());
}

}  // namespace

// What a linear cut costs more than a half-edge one follows the vertices, which it copies and looks at for hulls. It is
// less where a plane crosses far more triangles than of a round shape, because both back ends cost the section. Fitted to
// asteroids from 1 k to 4 M triangles, to the report's models and to the meshes of bench/real_meshes.h; times are
// nanoseconds, of which only the ratios matter. With 1, 2, 5, 10, 20, 50, 100 or 1000 cuts the choice costs at most 1.1
// times the better of both there (kerf_bench --benchmark_filter=^Automatic/).
bool preparing_pays(const core::IndexedMesh& mesh, std::uint32_t cuts)
{
    constexpr double kSaved = 12'000.0, kSavedForVertex = 20.0, kLostForCrossing = 250.0;
    constexpr double kPrepare = 3'000.0, kPrepareTriangle = 60.0;
    constexpr double kRound = 4.0;  // times the root of the triangles: no round shape is crossed in more
    const auto triangles = double(mesh.triangles.size());
    const double round = kSaved + kSavedForVertex * double(mesh.vertices.size());
    const double needed = kPrepare + kPrepareTriangle * triangles;
    if (double(cuts) * round <= needed) return false;
    const double beyond_round = std::max(0.0, crossing_triangles(mesh) - kRound * std::sqrt(triangles));
    return double(cuts) * (round - kLostForCrossing * beyond_round) > needed;
}

// Preparing costs some 80 ns a triangle. Beside a sweep it saves some 100 ns for each triangle that a plane crosses:
// measured on asteroids of 10 k to 4 M triangles, and on `folded`, where a plane crosses half of them (kerf_bench
// --benchmark_filter='^(Stack|RealStack)/').
bool preparing_pays(const core::IndexedMesh& mesh, const glm::dvec3& normal, std::span<const double> heights)
{
    constexpr std::size_t kLooked = 4096, kFew = 2;  // so few planes save too little to ask
    constexpr double kCrossedForEach = 0.8;
    if (heights.size() <= kFew) return false;
    std::vector<double> sorted(heights.begin(), heights.end());
    std::ranges::sort(sorted);
    double looked = 0.0, crossed = 0.0;
    for_each_looked(mesh, kLooked, [&](const core::Triangle& t) {
        std::array<double, 3> height{};
        for (std::size_t i = 0; i < 3; ++i) height[i] = glm::dot(normal, glm::dvec3(mesh.vertices[t[i]].position));
        const auto [lowest, highest] = std::ranges::minmax(height);
        crossed += double(std::ranges::upper_bound(sorted, highest) - std::ranges::lower_bound(sorted, lowest));
        looked += 1.0;
    });
    return crossed > kCrossedForEach * looked;
}

}  // namespace kerf
