#include "maker/triangulate.h"

#include <glm/geometric.hpp>
#include <limits>
#include <sstream>
#include <stdexcept>

#include "maker/poly_mesh.h"

namespace kerf::maker {
namespace {

constexpr double kForbidden = std::numeric_limits<double>::infinity();

/// Below this share of an equilateral triangle's shape a triangle counts as degenerate: three corners on one side of
/// a split edge give about 1e-16, the slimmest wanted one (the fan of a 32-gon) 1e-2.
constexpr double kLeastShape = 1e-6;

/// Squared perimeter over area towards `up`: smallest for an equilateral triangle.
double cost(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& up)
{
    const double area = glm::dot(glm::cross(b - a, c - a), up);
    const double around = glm::length(b - a) + glm::length(c - b) + glm::length(a - c);
    return area > kLeastShape * around * around ? around * around / area : kForbidden;
}

}  // namespace

std::vector<std::array<int, 3>> triangulate(const std::vector<glm::dvec3>& polygon)
{
    const std::size_t n = polygon.size();
    const glm::dvec3 up = glm::normalize(newell(polygon));
    std::vector<double> best(n * n, 0.0);  // of the part between corners i and j, i < j
    std::vector<std::size_t> apex(n * n, 0);
    for (std::size_t span = 2; span < n; ++span) {
        for (std::size_t i = 0; i + span < n; ++i) {
            const std::size_t j = i + span;
            best[i * n + j] = kForbidden;
            for (std::size_t k = i + 1; k < j; ++k) {
                const double total = best[i * n + k] + best[k * n + j] + cost(polygon[i], polygon[k], polygon[j], up);
                if (total >= best[i * n + j]) continue;
                best[i * n + j] = total;
                apex[i * n + j] = k;
            }
        }
    }
    if (best[n - 1] == kForbidden) {
        std::ostringstream message;
        message << "triangulate: a polygon crosses itself:";
        for (const glm::dvec3& p : polygon) message << " (" << p.x << ' ' << p.y << ' ' << p.z << ')';
        throw std::logic_error(message.str());
    }

    std::vector<std::array<int, 3>> triangles;
    std::vector<std::array<std::size_t, 2>> open{{0, n - 1}};
    while (!open.empty()) {
        const auto [i, j] = open.back();
        open.pop_back();
        if (j - i < 2) continue;
        const std::size_t k = apex[i * n + j];
        triangles.push_back({int(i), int(k), int(j)});
        open.push_back({i, k});
        open.push_back({k, j});
    }
    return triangles;
}

}  // namespace kerf::maker
