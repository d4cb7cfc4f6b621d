#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "common/shapes/corner_grid.h"
#include "common/shapes/shapes.h"
#include "common/support/random.h"

namespace kerf::core::shapes {
namespace {

// A value in about [-1, 1] and its gradient.
struct Sample
{
    double value = 0.0;
    glm::dvec3 gradient{0.0};
};

// Smooth noise in space: random values on the integer lattice, joined by quintic polynomials, so that the gradient is
// continuous and exact. Only +, -, *, floor: the same bits on every machine. Method: Quilez, "Value noise derivatives".
class Noise
{
public:
    explicit Noise(std::uint64_t seed) : seed_(Random::mix(seed)) {}

    Sample operator()(const glm::dvec3& p) const
    {
        const glm::dvec3 floor{std::floor(p.x), std::floor(p.y), std::floor(p.z)};
        const glm::dvec3 t = p - floor;
        const glm::dvec3 s = t * t * t * (t * (t * 6.0 - 15.0) + 10.0);
        const glm::dvec3 ds = t * t * (t * (t - 2.0) + 1.0) * 30.0;
        const auto x = std::int64_t(floor.x), y = std::int64_t(floor.y), z = std::int64_t(floor.z);
        std::array<double, 8> v;
        for (unsigned i = 0; i < 8; ++i) v[i] = lattice(x + (i & 1), y + (i >> 1 & 1), z + (i >> 2));
        // v = k0 + k1 x + k2 y + k3 z + k4 xy + k5 yz + k6 zx + k7 xyz in the smoothed coordinates.
        const double k1 = v[1] - v[0], k2 = v[2] - v[0], k3 = v[4] - v[0];
        const double k4 = v[0] - v[1] - v[2] + v[3], k5 = v[0] - v[2] - v[4] + v[6], k6 = v[0] - v[1] - v[4] + v[5];
        const double k7 = v[1] + v[2] + v[4] + v[7] - v[0] - v[3] - v[5] - v[6];
        Sample result;
        result.value = v[0] + k1 * s.x + k2 * s.y + k3 * s.z + k4 * s.x * s.y + k5 * s.y * s.z + k6 * s.z * s.x +
                       k7 * s.x * s.y * s.z;
        result.gradient =
            ds * glm::dvec3(k1 + k4 * s.y + k6 * s.z + k7 * s.y * s.z, k2 + k5 * s.z + k4 * s.x + k7 * s.z * s.x,
                            k3 + k6 * s.x + k5 * s.y + k7 * s.x * s.y);
        return result;
    }

private:
    double lattice(std::int64_t x, std::int64_t y, std::int64_t z) const
    {
        const std::uint64_t word = seed_ + std::uint64_t(x) * 0x9E3779B97F4A7C15u +
                                   std::uint64_t(y) * 0xC2B2AE3D27D4EB4Fu + std::uint64_t(z) * 0x165667B19E3779F9u;
        return double(Random::mix(word) >> 11) * 0x1p-52 - 1.0;
    }

    std::uint64_t seed_;
};

// Cells of a box whose grid has about `triangles` triangles: the most equal counts that are within 1 %, if there are
// any.
glm::uvec3 cells_for(std::uint64_t triangles)
{
    const auto middle = std::int64_t(std::sqrt(double(triangles) / 12.0));
    glm::uvec3 best(1);
    double least = std::numeric_limits<double>::infinity();
    for (std::int64_t spread = 0; spread <= 5; ++spread) {
        for (std::int64_t a = std::max<std::int64_t>(1, middle - spread); a <= middle + 1; ++a) {
            for (std::int64_t b = a; b <= a + spread; ++b) {
                const std::int64_t c = a + spread;
                const double error = std::abs(4.0 * double(a * b + b * c + c * a) / double(triangles) - 1.0);
                if (error < least) {
                    least = error;
                    best = glm::uvec3(a, b, c);
                }
            }
        }
        if (least <= 0.01) break;
    }
    return best;
}

// From the cube to the unit sphere, nearly equal cells: x sqrt(1 - y^2/2 - z^2/2 + y^2 z^2/3). Only square roots, and
// the same bits for a point of the cube on whichever face it is found.
glm::dvec3 cube_to_sphere(const glm::dvec3& p)
{
    const glm::dvec3 q = p * p;
    const auto one = [](double x, double s, double t) { return x * std::sqrt(1.0 - 0.5 * (s + t) + s * t / 3.0); };
    return glm::normalize(glm::dvec3(one(p.x, q.y, q.z), one(p.y, q.z, q.x), one(p.z, q.x, q.y)));
}

}  // namespace

TriangleSoup asteroid(std::uint64_t triangles, std::uint64_t seed)
{
    // Each octave is twice as fine and a bit more than half as high: big lumps, small bumps, never a hole. The sum of
    // the heights stays below 1, so the radius stays positive.
    struct Octave
    {
        double frequency, height;
    };
    constexpr std::array kOctaves{Octave{1.3, 0.30}, Octave{2.7, 0.15}, Octave{5.3, 0.07}, Octave{10.9, 0.025},
                                  Octave{23.0, 0.006}};
    Random random(seed);
    struct Layer
    {
        Noise noise;
        glm::dvec3 shift;
    };
    std::vector<Layer> layers;
    for (std::size_t i = 0; i < kOctaves.size(); ++i) {
        const std::uint64_t noise_seed = random.next();
        const double x = random.unit(), y = random.unit(), z = random.unit();
        layers.push_back({Noise(noise_seed), glm::dvec3(x, y, z)});
    }

    const glm::uvec3 cells = cells_for(std::clamp<std::uint64_t>(triangles, 12, kMostTriangles));
    const auto quads =
        2 * (std::size_t(cells.x) * cells.y + std::size_t(cells.y) * cells.z + std::size_t(cells.z) * cells.x);
    TriangleSoup soup;
    soup.triangles.reserve(2 * quads);
    soup.vertices.reserve(quads + 4 * std::size_t(cells.x + cells.y + cells.z) + 6);
    add_box_grid(soup, cells, [&](const BoxPoint& point) {
        const glm::dvec3 direction = cube_to_sphere(point.cube);
        Sample radius{1.0, glm::dvec3(0.0)};
        for (std::size_t i = 0; i < kOctaves.size(); ++i) {
            const auto [frequency, height] = kOctaves[i];
            const Sample sample = layers[i].noise(direction * frequency + layers[i].shift);
            radius.value += height * sample.value;
            radius.gradient += height * frequency * sample.gradient;
        }
        // The surface is |p| = radius(p / |p|); its normal is the direction less the slope along the sphere.
        const glm::dvec3 slope = radius.gradient - direction * glm::dot(radius.gradient, direction);
        const glm::dvec2 tile(point.face % 3, point.face / 3);
        return make_vertex(direction * radius.value, direction * radius.value - slope,
                           (tile + point.face_uv) * glm::dvec2(1.0 / 3.0, 0.5));
    });
    return soup;
}

}  // namespace kerf::core::shapes
