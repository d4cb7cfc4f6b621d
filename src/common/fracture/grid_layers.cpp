#include "common/fracture/grid_layers.h"

#include <algorithm>
#include <cmath>
#include <glm/vec3.hpp>
#include <vector>

namespace kerf::core {

namespace {

constexpr double kMostBoxes = 1e5;

double number_of(const Layers& layers)
{
    return double(layers[0]) * double(layers[1]) * double(layers[2]);
}

class Grid
{
public:
    Grid(const Box& box, const InsideSample& sample)
        : lo_(box.lo), size_(glm::dvec3(box.hi) - glm::dvec3(box.lo)), sample_(sample)
    {
    }

    double longest_side() const { return std::max({size_.x, size_.y, size_.z}); }

    /// With boxes whose sides are this long, or a little longer.
    Layers of_side(double side) const
    {
        Layers layers{};
        for (int axis = 0; axis < 3; ++axis)
            layers[std::size_t(axis)] =
                static_cast<std::uint32_t>(std::clamp(std::floor(size_[axis] / side), 1.0, kMostBoxes));
        return layers;
    }

    /// With one layer more where boxes are longest.
    Layers divided(Layers layers) const
    {
        const auto length = [&](int axis) { return size_[axis] / double(layers[std::size_t(axis)]); };
        const int longest = std::max({0, 1, 2}, [&](int a, int b) { return length(a) < length(b); });
        ++layers[std::size_t(longest)];
        return layers;
    }

    /// How many boxes hold a part of the solid. At most kMostBoxes.
    std::size_t filled(const Layers& layers) const
    {
        std::vector<bool> is_filled(static_cast<std::size_t>(number_of(layers)), false);
        const auto place = [&](double coordinate, int axis) {
            const double layer = (coordinate - lo_[axis]) / size_[axis] * double(layers[std::size_t(axis)]);
            return static_cast<std::size_t>(std::clamp(layer, 0.0, double(layers[std::size_t(axis)] - 1)));
        };
        sample_.for_each_run([&](const glm::dvec3& from, int along, double length) {
            std::array<std::size_t, 3> box{place(from.x, 0), place(from.y, 1), place(from.z, 2)};
            const std::size_t last = place(from[along] + length, along);
            for (std::size_t& layer = box[std::size_t(along)]; layer <= last; ++layer)
                is_filled[(box[2] * layers[1] + box[1]) * layers[0] + box[0]] = true;
        });
        return static_cast<std::size_t>(std::ranges::count(is_filled, true));
    }

private:
    glm::dvec3 lo_, size_;
    const InsideSample& sample_;
};

}  // namespace

Layers layers_for(const Box& box, const InsideSample& sample, std::size_t wanted)
{
    const Grid grid(box, sample);
    // The coarsest grid of cubes that has as many as are wanted, found by halving, and the one before. Of a scattered solid a
    // much finer one has no more.
    double coarse = grid.longest_side(), fine = coarse / kMostBoxes;
    constexpr int kRounds = 60;
    for (int round = 0; round < kRounds; ++round) {
        const double side = 0.5 * (coarse + fine);
        const Layers layers = grid.of_side(side);
        (number_of(layers) <= kMostBoxes && grid.filled(layers) < wanted ? coarse : fine) = side;
    }
    // The next one may have eight times as many: what lies between, axis by axis.
    Layers best = grid.of_side(coarse), next = best;
    const auto miss = [&](const Layers& layers) { return std::abs(double(grid.filled(layers)) - double(wanted)); };
    for (int axis = 0; axis < 3; ++axis) {
        next = grid.divided(next);
        if (number_of(next) <= kMostBoxes && miss(next) <= miss(best)) best = next;
    }
    return best;
}

}  // namespace kerf::core
