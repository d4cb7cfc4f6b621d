#include "common/proxy/convex_hull.h"

#include <LinearMath/btConvexHullComputer.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <limits>
#include <new>
#include <numeric>
#include <stdexcept>

#include "common/mesh/box.h"
#include "common/mesh/is_finite.h"
#include "common/mesh/tolerances.h"

namespace kerf::core {
namespace {

// Twice the signed area of (a, b, c).
double doubled_area(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c)
{
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// The extreme points of a flat set, counter-clockwise in the projection along the axis in which it is largest.
std::vector<std::uint32_t> flat_hull(std::span<const glm::vec3> points)
{
    std::vector<std::uint32_t> order(points.size());
    std::iota(order.begin(), order.end(), 0u);
    std::vector<std::uint32_t> best;
    double largest_area = -1.0, largest_extent = -1.0;
    for (int axis = 0; axis < 3; ++axis) {
        const auto project = [&](std::uint32_t i) {
            return glm::dvec2(double(points[i][(axis + 1) % 3]), double(points[i][(axis + 2) % 3]));
        };
        std::sort(order.begin(), order.end(), [&](std::uint32_t i, std::uint32_t j) {
            const glm::dvec2 a = project(i), b = project(j);
            if (a.x != b.x) return a.x < b.x;
            if (a.y != b.y) return a.y < b.y;
            return i < j;
        });
        // The lower chain from left to right, then the upper one back.
        std::vector<std::uint32_t> chain;
        const auto extend = [&](std::uint32_t i, std::size_t keep) {
            while (chain.size() > keep &&
                   doubled_area(project(chain[chain.size() - 2]), project(chain.back()), project(i)) <= 0.0) {
                chain.pop_back();
            }
            if (chain.empty() || project(chain.back()) != project(i)) chain.push_back(i);
        };
        for (const std::uint32_t i : order) extend(i, 1);
        const std::size_t lower = chain.size();
        for (auto i = order.rbegin(); i != order.rend(); ++i) extend(*i, lower);
        // The upper chain ends where the lower one began, perhaps with the index of a duplicate.
        if (chain.size() > 1 && project(chain.back()) == project(chain.front())) chain.pop_back();

        double area = 0.0;
        for (std::size_t i = 2; i < chain.size(); ++i) {
            area += doubled_area(project(chain[0]), project(chain[i - 1]), project(chain[i]));
        }
        const double extent = glm::length(project(order.back()) - project(order.front()));
        if (area > largest_area || (area == largest_area && extent > largest_extent)) {
            largest_area = area;
            largest_extent = extent;
            best = std::move(chain);
        }
    }
    return best;
}

// True if the lattice cannot tell the hull's inside from rounding. All extents are made equal first, as the lattice
// does.
bool is_flat(const ConvexHull& hull, std::span<const glm::vec3> points, const Box& box)
{
    if (hull.corners.size() < 4 || hull.faces.size() < 4) return true;
    const glm::dvec3 extent = glm::dvec3(box.hi) - glm::dvec3(box.lo);
    if (extent.x == 0.0 || extent.y == 0.0 || extent.z == 0.0) return true;
    const auto corner = [&](std::uint32_t i) {
        return (glm::dvec3(points[hull.corners[i]]) - glm::dvec3(box.lo)) / extent;
    };
    double volume6 = 0.0, area2 = 0.0;
    for (const Triangle& t : hull.faces) {
        const glm::dvec3 a = corner(t[0]), b = corner(t[1]), c = corner(t[2]);
        volume6 += glm::dot(a, glm::cross(b, c));
        area2 += glm::length(glm::cross(b - a, c - a));
    }
    // A flat pyramid of thickness t has the volume t * base / 3 and the area 2 * base; other bodies are thicker for
    // the same quotient.
    return !(2.0 * volume6 / area2 > kThinnestInSteps / kHullLattice);
}

// Scales the points by a power of two, which takes the largest coordinate to between 1 and 2: Bullet accepts no
// coordinates over 1e30. Exact except for coordinates that are less than 2^-126 of the largest one.
std::vector<glm::vec3> to_common_size(std::span<const glm::vec3> points, const Box& box)
{
    float largest = 0.0f;
    for (int axis = 0; axis < 3; ++axis) largest = std::max({largest, std::abs(box.lo[axis]), std::abs(box.hi[axis])});
    const double factor = largest > 0.0f ? std::ldexp(1.0, -std::ilogb(largest)) : 1.0;
    std::vector<glm::vec3> scaled;
    scaled.reserve(points.size());
    for (const glm::vec3& p : points) scaled.emplace_back(glm::dvec3(p) * factor);
    return scaled;
}

// Throws std::bad_alloc if there is no memory for a hull of so many points: Bullet takes its memory without a look at
// whether it was given any, and its allocator belongs to the whole program. Another thread may take what was there.
void expect_memory_for(std::size_t points)
{
    // btConvexHullComputer.cpp: for each point a vertex of 128 bytes, six half-edges of 48, three places in lists.
    constexpr std::size_t kBytesAPoint = 512, kBytesInAnyCase = std::size_t(1) << 16;
    ::operator delete(::operator new(kBytesInAnyCase + kBytesAPoint * points));
}

// The hull of the finite points, if some are not.
ConvexHull hull_of_finite(std::span<const glm::vec3> points)
{
    std::vector<glm::vec3> finite;
    std::vector<std::uint32_t> index;
    for (std::uint32_t i = 0; i < points.size(); ++i) {
        if (!is_finite(points[i])) continue;
        finite.push_back(points[i]);
        index.push_back(i);
    }
    ConvexHull hull = convex_hull(finite);
    for (std::uint32_t& corner : hull.corners) corner = index[corner];
    return hull;
}

}  // namespace

ConvexHull convex_hull(std::span<const glm::vec3> points)
{
    ConvexHull hull;
    if (points.empty()) return hull;
    if (points.size() > std::size_t{std::numeric_limits<int>::max()}) throw std::length_error("points of a hull");
    if (!std::all_of(points.begin(), points.end(), is_finite<float>)) return hull_of_finite(points);
    Box box;
    for (const glm::vec3& p : points) box.add(p);

    const std::vector<glm::vec3> scaled = to_common_size(points, box);
    expect_memory_for(scaled.size());
    btConvexHullComputer computer;
    computer.compute(&scaled.front().x, int(sizeof(glm::vec3)), int(scaled.size()), btScalar(0), btScalar(0));
    for (int i = 0; i < computer.original_vertex_index.size(); ++i) {
        hull.corners.push_back(std::uint32_t(computer.original_vertex_index[i]));
    }
    for (int i = 0; i < computer.faces.size(); ++i) {
        const btConvexHullComputer::Edge* const first = &computer.edges[computer.faces[i]];
        const auto apex = std::uint32_t(first->getSourceVertex());
        for (const btConvexHullComputer::Edge* edge = first->getNextEdgeOfFace();
             std::uint32_t(edge->getTargetVertex()) != apex; edge = edge->getNextEdgeOfFace()) {
            hull.faces.push_back(
                {apex, std::uint32_t(edge->getSourceVertex()), std::uint32_t(edge->getTargetVertex())});
        }
    }
    if (is_flat(hull, points, box)) return {flat_hull(points), {}};
    return hull;
}

}  // namespace kerf::core
