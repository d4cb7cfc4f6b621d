#include "common/mesh/support_points.h"

#include <algorithm>
#include <limits>

#include "common/mesh/four_floats.h"
#include "common/mesh/position_order.h"

namespace kerf::core {
namespace {

constexpr std::size_t kLines = kSupportDirections / 2;  // directions come in opposite pairs
constexpr std::size_t kAxes = 3;                        // the first of them

// Found by a search that minimised the largest angle between any direction in space and the nearest of these: 24.54
// degrees. (The corners of an icosahedron and a dodecahedron together, which leave the axes out, reach 22.7.)
constexpr std::array<glm::vec3, kLines> kLineDirections{{
    {1.0f, 0.0f, 0.0f},
    {0.0f, 1.0f, 0.0f},
    {0.0f, 0.0f, 1.0f},
    {0.418671489f, 0.294008076f, 0.859228373f},
    {-0.21835801f, 0.748075843f, 0.626659632f},
    {-0.382950604f, -0.429968208f, 0.817603886f},
    {0.431882799f, -0.45826748f, 0.776832104f},
    {0.312537163f, 0.842063367f, 0.439601839f},
    {0.56255275f, -0.821948171f, 0.0890818164f},
    {-0.682842553f, -0.697121382f, 0.218512759f},
    {0.842989326f, -0.254600883f, 0.473864347f},
    {-0.325548172f, 0.336817443f, 0.883500099f},
    {0.850625157f, 0.392501056f, 0.349828154f},
    {-0.832963943f, -0.0582319982f, 0.550254524f},
    {-0.823564887f, 0.488650531f, 0.288030475f},
    {0.00485841371f, -0.845402062f, 0.5341084f},
}};

float least_of(Four a)
{
    return std::min(std::min(a[0], a[1]), std::min(a[2], a[3]));
}

// 128 positions, coordinate by coordinate: the sums over a block stay in registers, and a search of a block for the
// vertex that made the maximum is cheap.
struct Block
{
    static constexpr std::size_t kVertices = 128, kGroups = kVertices / kLanes;
    std::array<Four, kGroups> x, y, z;

    void fill(std::span<const Vertex> vertices)
    {
        std::size_t i = 0;
        for (; i + kLanes <= vertices.size(); i += kLanes) {
            const glm::vec3 &a = vertices[i].position, &b = vertices[i + 1].position;
            const glm::vec3 &c = vertices[i + 2].position, &d = vertices[i + 3].position;
            x[i / kLanes] = Four{a.x, b.x, c.x, d.x};
            y[i / kLanes] = Four{a.y, b.y, c.y, d.y};
            z[i / kLanes] = Four{a.z, b.z, c.z, d.z};
        }
        // Fill up with the last vertex: it changes no maximum.
        for (; i < kVertices; ++i) {
            const glm::vec3& p = vertices[std::min(i, vertices.size() - 1)].position;
            x[i / kLanes][i % kLanes] = p.x;
            y[i / kLanes][i % kLanes] = p.y;
            z[i / kLanes][i % kLanes] = p.z;
        }
    }

    // Smallest and largest of `value(group)` over the block.
    template <class Value>
    static std::array<float, 2> range(Value value)
    {
        // Two of each, because a maximum takes longer than the next one needs to start.
        Four low0 = value(0), high0 = low0, low1 = value(1), high1 = low1;
        for (std::size_t g = 2; g < kGroups; g += 2) {
            const Four v0 = value(g), v1 = value(g + 1);
            low0 = smaller(low0, v0);
            low1 = smaller(low1, v1);
            high0 = larger(high0, v0);
            high1 = larger(high1, v1);
        }
        const Four low = smaller(low0, low1), high = larger(high0, high1);
        return {least_of(low), -least_of(-high)};
    }
};

struct Extreme
{
    float value = -std::numeric_limits<float>::infinity();
    glm::vec3 position{0.0f};

    // Searches a block whose largest `value_of(group)` is `block_value`. Among the vertices that reach it, the
    // lexicographically smallest is found coordinate by coordinate, without a branch that depends on one vertex: on a
    // flat side thousands of vertices reach the same value.
    template <class Value>
    void look(const Block& block, float block_value, Value value_of)
    {
        if (block_value < value) return;
        const bool tie = block_value == value;
        value = block_value;
        const auto least = [](const std::array<Four, Block::kGroups>& coordinate, auto is_candidate) {
            constexpr float kInfinity = std::numeric_limits<float>::infinity();
            const Four infinity{kInfinity, kInfinity, kInfinity, kInfinity};
            Four low = infinity;
            for (std::size_t g = 0; g < Block::kGroups; ++g) {
                low = smaller(low, is_candidate(g) ? coordinate[g] : infinity);
            }
            return least_of(low);
        };
        const Four wanted = Four{} + value;
        glm::vec3 p(0.0f);
        p.x = least(block.x, [&](std::size_t g) { return value_of(g) == wanted; });
        if (tie && p.x > position.x) return;
        p.y = least(block.y, [&](std::size_t g) { return (value_of(g) == wanted) & (block.x[g] == Four{} + p.x); });
        p.z = least(block.z, [&](std::size_t g) {
            return (value_of(g) == wanted) & (block.x[g] == Four{} + p.x) & (block.y[g] == Four{} + p.y);
        });
        if (!tie || lexicographically_less(p, position)) position = p;
    }
};

}  // namespace

const std::array<glm::vec3, kSupportDirections>& support_directions()
{
    static const std::array<glm::vec3, kSupportDirections> directions = [] {
        std::array<glm::vec3, kSupportDirections> all;
        for (std::size_t i = 0; i < kLines; ++i) {
            all[i] = kLineDirections[i];
            all[i + kLines] = glm::vec3(0.0f) - kLineDirections[i];
        }
        return all;
    }();
    return directions;
}

std::array<glm::vec3, kSupportDirections> support_points(std::span<const Vertex> vertices)
{
    const std::array<glm::vec3, kSupportDirections>& directions = support_directions();
    std::array<Extreme, kSupportDirections> extremes;
    Block block;
    for (std::size_t first = 0; first < vertices.size(); first += Block::kVertices) {
        block.fill(vertices.subspan(first, std::min(Block::kVertices, vertices.size() - first)));
        const auto look = [&](std::size_t i, auto value_of) {
            const auto [low, high] = Block::range(value_of);
            extremes[i].look(block, high, value_of);
            // Rounding is symmetric, so the value along -d is the negative of the value along d.
            extremes[i + kLines].look(block, -low, [&](std::size_t g) { return -value_of(g); });
        };
        // Along an axis the support value is the coordinate: 1 * x + 0 * y + 0 * z is x.
        look(0, [&](std::size_t g) { return block.x[g]; });
        look(1, [&](std::size_t g) { return block.y[g]; });
        look(2, [&](std::size_t g) { return block.z[g]; });
        for (std::size_t i = kAxes; i < kLines; ++i) {
            const glm::vec3& d = directions[i];
            look(i, [&](std::size_t g) { return (d.x * block.x[g] + d.y * block.y[g]) + d.z * block.z[g]; });
        }
    }
    std::array<glm::vec3, kSupportDirections> points;
    for (std::size_t i = 0; i < kSupportDirections; ++i) points[i] = extremes[i].position;
    return points;
}

}  // namespace kerf::core
