#include "common/fracture/cell_finder.h"

#include <algorithm>
#include <cmath>

#include "common/mesh/index.h"

namespace kerf::core {

namespace {

/// The rounded squared distance of a point has an error of at most five times 2^-53 of it: one of each difference, which
/// counts twice in its square, one of the square and two of the sums. That of a corner of the box has as many, and of
/// what is compared with it three more. Rounded up, for each of the two sites.
constexpr double kHalfUnit = 0x1p-53, kHalfUnitsOfDistance = 16.0;

/// Of the farthest place of a box, squared.
double most_squared_distance(const Box& box, const glm::dvec3& site)
{
    double sum = 0.0;
    for (int axis = 0; axis < 3; ++axis) {
        const double away =
            std::max(std::abs(double(box.lo[axis]) - site[axis]), std::abs(double(box.hi[axis]) - site[axis]));
        sum += away * away;
    }
    return sum;
}

}  // namespace

std::uint32_t CellFinder::cell_of(const glm::vec3& point)
{
    double least = squared_distance_to_site(point, diagram_.sites[cell_]);
    for (bool has_moved = true; has_moved;) {
        has_moved = false;
        for (const std::uint32_t other : diagram_.neighbours[cell_]) {
            const double distance = squared_distance_to_site(point, diagram_.sites[other]);
            if (distance > least || (distance == least && other > cell_)) continue;
            least = distance;
            cell_ = other;
            has_moved = true;
            break;
        }
    }
    return cell_;
}

std::uint32_t CellFinder::cell_of(const Box& box)
{
    const std::uint32_t cell = cell_of(glm::vec3(box.centre()));
    const glm::dvec3& site = diagram_.sites[cell];
    const double most = most_squared_distance(box, site);
    for (const std::uint32_t other : diagram_.neighbours[cell]) {
        const glm::dvec3& beyond = diagram_.sites[other];
        // The difference of both is linear: it is least at the corner that lies farthest towards the other site.
        glm::vec3 corner;
        for (int axis = 0; axis < 3; ++axis) corner[axis] = beyond[axis] > site[axis] ? box.hi[axis] : box.lo[axis];
        const double lead = squared_distance_to_site(corner, beyond) - squared_distance_to_site(corner, site);
        if (!(lead > kHalfUnitsOfDistance * kHalfUnit * (most + most_squared_distance(box, beyond)))) return kNone;
    }
    return cell;
}

}  // namespace kerf::core
