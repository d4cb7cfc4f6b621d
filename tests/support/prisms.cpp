#include "support/prisms.h"

#include <cmath>
#include <numbers>

#include "support/fixtures.h"

namespace kerf::core::test {

IndexedMesh prism_over(const Polygon& polygon)
{
    TriangleSoup soup;
    const auto n = static_cast<std::uint32_t>(polygon.size());
    glm::dvec2 mean{0};
    for (const glm::dvec2& p : polygon) mean += p / double(n);
    const auto add = [&](const glm::dvec2& p, float y) {
        soup.vertices.push_back({glm::vec3(p.x, y, p.y) + 0.0f, {0, 1, 0}, {0, 0}});
    };
    for (const float y : {-1.0f, 1.0f})
        for (const glm::dvec2& p : polygon) add(p, y);
    // Off the middle, so that no triangle of the ends is one of the sides.
    add(mean + glm::dvec2(0.0123, 0.0071), -1.0f);
    add(mean + glm::dvec2(0.0123, 0.0071), 1.0f);
    for (std::uint32_t i = 0; i < n; ++i) {
        const std::uint32_t j = (i + 1) % n;
        for (const Triangle& t : {Triangle{i, i + n, j + n}, {i, j + n, j}, {2 * n, i, j}, {2 * n + 1, j + n, i + n}})
            soup.triangles.push_back(t);
    }
    return repaired(std::move(soup));
}

Polygon star(std::uint32_t points, std::uint32_t turns)
{
    Polygon polygon;
    for (std::uint32_t i = 0; i < points; ++i) {
        const double angle = 2 * std::numbers::pi * turns * i / points;
        polygon.emplace_back(std::cos(angle), std::sin(angle));
    }
    return polygon;
}

}  // namespace kerf::core::test
