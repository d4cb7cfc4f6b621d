// The frozen fruit from outside: a lump of ice, a convex body with flat facets and bevelled edges.

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <optional>
#include <utility>

#include "maker/fruit/fruit.h"

namespace kerf::maker {
namespace {

/// What lies below a plane: dot(normal, p) <= distance.
struct HalfSpace
{
    glm::dvec3 normal;  ///< unit
    double distance;
};

/// The large facets: a box that nobody measured, with corners and edges knocked off.
/// shaders/fruit_frozen.glsl knows these numbers.
constexpr std::array<std::array<double, 4>, 18> kFacets{{
    {1.00, 0.07, 0.05, 0.50},
    {-1.00, 0.05, -0.08, 0.52},
    {0.05, 1.00, -0.06, 0.55},
    {-0.06, -1.00, 0.05, 0.54},
    {-0.05, 0.06, 1.00, 0.49},
    {0.07, -0.05, -1.00, 0.50},
    {1.00, 1.00, 0.90, 0.70},
    {-0.90, 1.00, 1.10, 0.77},
    {1.00, 0.80, -1.00, 0.78},
    {-1.00, 1.10, -0.90, 0.69},
    {0.90, -1.10, 1.00, 0.76},
    {-1.00, -1.00, 0.80, 0.69},
    {1.10, -0.90, -1.00, 0.68},
    {-0.90, -1.00, -1.10, 0.79},
    {0.25, 1.00, 0.90, 0.655},
    {-1.00, 0.15, 0.90, 0.64},
    {1.00, -0.95, -0.10, 0.665},
    {-0.90, 0.10, -1.00, 0.66},
}};

constexpr double kBevel = 0.048;    ///< width of the bevels
constexpr double kSegment = 0.075;  ///< of an edge, about
constexpr double kSame = 1e-7;      ///< points that are nearer than that are one

std::vector<HalfSpace> large_facets()
{
    std::vector<HalfSpace> spaces;
    for (const auto& [x, y, z, distance] : kFacets) spaces.push_back({glm::normalize(glm::dvec3{x, y, z}), distance});
    return spaces;
}

using Polygon = std::vector<glm::dvec3>;

/// A polygon's part below a plane (Sutherland and Hodgman, 1974).
Polygon clipped(const Polygon& polygon, const HalfSpace& space)
{
    Polygon kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec3 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        const double above_a = glm::dot(space.normal, a) - space.distance;
        const double above_b = glm::dot(space.normal, b) - space.distance;
        if (above_a <= 0.0) kept.push_back(a);
        if ((above_a < 0.0 && above_b > 0.0) || (above_a > 0.0 && above_b < 0.0))
            kept.push_back(a + (b - a) * (above_a / (above_a - above_b)));
    }
    return kept;
}

/// The facet of a convex body that lies in the k-th plane, counter-clockwise seen from outside; empty if there is none.
Polygon facet_of(const std::vector<HalfSpace>& spaces, std::size_t k)
{
    const glm::dvec3 n = spaces[k].normal;
    const glm::dvec3 x = glm::normalize(glm::cross(std::abs(n.y) < 0.9 ? glm::dvec3{0, 1, 0} : glm::dvec3{1, 0, 0}, n));
    const glm::dvec3 y = glm::cross(n, x), middle = spaces[k].distance * n;
    Polygon polygon{middle - x - y, middle + x - y, middle + x + y, middle - x + y};
    for (std::size_t other = 0; other < spaces.size(); ++other)
        if (other != k) polygon = clipped(polygon, spaces[other]);
    return polygon;
}

/// The longest edge of a polygon that lies in a plane.
std::optional<std::array<glm::dvec3, 2>> edge_in(const Polygon& polygon, const HalfSpace& space)
{
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const std::array<glm::dvec3, 2> edge{polygon[i], polygon[(i + 1) % polygon.size()]};
        const auto is_in = [&](const glm::dvec3& p) {
            return std::abs(glm::dot(space.normal, p) - space.distance) < kSame;
        };
        if (glm::distance(edge[0], edge[1]) > kBevel && is_in(edge[0]) && is_in(edge[1])) return edge;
    }
    return std::nullopt;
}

/// A plane for each edge between two facets that takes off a strip of width kBevel.
std::vector<HalfSpace> bevels_of(const std::vector<HalfSpace>& facets)
{
    std::vector<HalfSpace> bevels;
    for (std::size_t a = 0; a < facets.size(); ++a) {
        const Polygon polygon = facet_of(facets, a);
        for (std::size_t b = a + 1; b < facets.size(); ++b) {
            const auto edge = edge_in(polygon, facets[b]);
            if (!edge) continue;
            const glm::dvec3 normal = glm::normalize(facets[a].normal + facets[b].normal);
            // The planes meet at twice this angle.
            const double half = std::acos(glm::dot(normal, facets[a].normal));
            bevels.push_back({normal, glm::dot(normal, (*edge)[0]) - 0.5 * kBevel * std::tan(half)});
        }
    }
    return bevels;
}

/// Facets with shared points, divided into triangles of about one size.
class Lump
{
public:
    /// @param inner_rings  around the middle, each a share of the size of the one before
    void add(const Polygon& polygon, int smoothing, const std::vector<double>& inner_rings)
    {
        std::vector<int> corners;
        for (const glm::dvec3& p : polygon) {
            const int point = shared(p);
            if (corners.empty() || (corners.back() != point && corners.front() != point)) corners.push_back(point);
        }
        std::vector<int> rim;
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const std::vector<int> part = divided(corners[i], corners[(i + 1) % corners.size()]);
            rim.insert(rim.end(), part.begin(), part.end() - 1);
        }
        glm::dvec3 middle{0.0};
        for (const int p : corners) middle += mesh_.points[std::size_t(p)] / double(corners.size());
        for (const double share : inner_rings) {
            std::vector<int> inner;
            for (const int p : rim) {
                const glm::dvec3 place = mesh_.points[std::size_t(p)];
                inner.push_back(mesh_.add_point(middle + share * (place - middle)));
            }
            for (std::size_t i = 0; i < rim.size(); ++i) {
                const std::size_t next = (i + 1) % rim.size();
                mesh_.add_facet({rim[i], rim[next], inner[next], inner[i]}, "frozen", {}, smoothing);
            }
            rim = std::move(inner);
        }
        const int apex = mesh_.add_point(middle);
        for (std::size_t i = 0; i < rim.size(); ++i)
            mesh_.add_facet({rim[i], rim[(i + 1) % rim.size()], apex}, "frozen", {}, smoothing);
    }

    PolyMesh take() { return std::move(mesh_); }

private:
    int shared(const glm::dvec3& place)
    {
        for (const int corner : corners_)
            if (glm::distance(mesh_.points[std::size_t(corner)], place) < kSame) return corner;
        corners_.push_back(mesh_.add_point(place));
        return corners_.back();
    }

    /// The points of an edge from a to b, both among them; the same ones for both facets.
    std::vector<int> divided(int a, int b)
    {
        const auto [found, is_new] = edges_.try_emplace({std::min(a, b), std::max(a, b)});
        if (is_new) {
            const glm::dvec3 from = mesh_.points[std::size_t(found->first.first)];
            const glm::dvec3 to = mesh_.points[std::size_t(found->first.second)];
            const int parts = std::max(1, int(std::lround(glm::distance(from, to) / kSegment)));
            found->second.push_back(found->first.first);
            for (int i = 1; i < parts; ++i)
                found->second.push_back(mesh_.add_point(from + (to - from) * (double(i) / parts)));
            found->second.push_back(found->first.second);
        }
        std::vector<int> points = found->second;
        if (a > b) std::reverse(points.begin(), points.end());
        return points;
    }

    PolyMesh mesh_;
    std::vector<int> corners_;
    std::map<std::pair<int, int>, std::vector<int>> edges_;
};

}  // namespace

PolyMesh make_frozen()
{
    std::vector<HalfSpace> spaces = large_facets();
    const std::size_t large = spaces.size();
    const std::vector<HalfSpace> bevels = bevels_of(spaces);
    spaces.insert(spaces.end(), bevels.begin(), bevels.end());
    Lump lump;
    for (std::size_t k = 0; k < spaces.size(); ++k) {
        const Polygon polygon = facet_of(spaces, k);
        if (polygon.size() >= 3)
            lump.add(polygon, int(k) + 1, k < large ? std::vector{0.72, 0.65} : std::vector<double>());
    }
    return lump.take();
}

}  // namespace kerf::maker
