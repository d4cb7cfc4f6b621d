#include "common/repair/solids.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

#include "common/geometry/containment.h"
#include "common/geometry/line_hits.h"
#include "common/geometry/ray_crossing.h"
#include "common/mesh/index.h"
#include "common/mesh/mass_moments.h"
#include "common/mesh/mass_properties.h"
#include "common/mesh/plane.h"
#include "common/mesh/plane_noise.h"

namespace kerf::core {

namespace {

class SolidFinder
{
public:
    SolidFinder(const LinkedSurface& surface, const Shells& shells, std::span<const glm::vec3> positions)
        : surface_(surface), shells_(shells), positions_(positions), samples_(shells.shells.size())
    {
    }

    Solids run()
    {
        const std::size_t count = shells_.shells.size();
        std::vector<std::uint32_t> container(count, kNoContainer);
        if (count > 1) {
            sort_triangles();
            std::vector<ContainableShape> items;
            items.reserve(count);
            for (const ConnectedShell& shell : shells_.shells)
                items.push_back({shell.box, std::abs(shell.volume6), shell.closed && shell.volume6 != 0.0, true});
            container = smallest_containers(
                items, [&](auto outer, auto candidates, auto lies_in) { decide(outer, candidates, lies_in); });
        }
        return group(container);
    }

private:
    static constexpr std::size_t kSamples = 3;  ///< odd, so that they always have a majority

    void sort_triangles()
    {
        first_.assign(shells_.shells.size() + 1, 0);
        for (std::size_t s = 0; s < shells_.shells.size(); ++s)
            first_[s + 1] = first_[s] + shells_.shells[s].triangle_count;
        triangles_.resize(surface_.corners.size());
        std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
        for (std::uint32_t t = 0; t < triangles_.size(); ++t) triangles_[next[shells_.shell[t]]++] = t;
    }

    std::span<const std::uint32_t> triangles_of(std::uint32_t shell) const
    {
        return std::span(triangles_).subspan(first_[shell], first_[shell + 1] - first_[shell]);
    }

    std::array<glm::vec3, 3> corners_of(std::uint32_t triangle) const
    {
        const auto& [a, b, c] = surface_.corners[triangle];
        return {positions_[a], positions_[b], positions_[c]};
    }

    void decide(std::uint32_t outer, std::span<const std::uint32_t> candidates, std::span<std::uint8_t> lies_in)
    {
        std::vector<WindingSample> samples;
        for (std::uint32_t i = 0; i < candidates.size(); ++i) {
            auto& own = samples_[candidates[i]];
            if (own.empty()) own = choose_samples(candidates[i]);
            for (const glm::vec3& position : own) samples.push_back({position, i});
        }
        // A ray along the shortest side of the outer shell has the fewest chances to meet it: along a comb it would
        // meet every tooth.
        const glm::dvec3 size = glm::dvec3(shells_.shells[outer].box.hi) - glm::dvec3(shells_.shells[outer].box.lo);
        const int axis = size.x <= size.y && size.x <= size.z ? 0 : (size.y <= size.z ? 1 : 2);
        WindingNumbers windings(samples);
        for (const std::uint32_t t : triangles_of(outer)) {
            const auto [a, b, c] = corners_of(t);
            Box reach;
            reach.add(a);
            reach.add(b);
            reach.add(c);
            reach.lo[axis] = -std::numeric_limits<float>::infinity();
            windings.add(reach, [&, a = a, b = b, c = c](const glm::vec3& p) {
                return ray_crossing({p, axis, true}, a, b, c);
            });
        }
        windings.vote(lies_in);
    }

    /// Sample points of a shell. Those of a closed shell lie deep inside, so it may touch the shell around it. Those of
    /// an open shell, or of one without an inside, are the middles of some triangles, whose corners may touch it.
    std::vector<glm::vec3> choose_samples(std::uint32_t shell) const
    {
        const std::span<const std::uint32_t> triangles = triangles_of(shell);
        std::vector<glm::vec3> samples;
        if (shells_.shells[shell].closed)
            for (std::size_t part = 0; part < kSamples; ++part) add_inside(triangles, part, samples);
        if (samples.empty())
            for (std::size_t part = 0; part < kSamples; ++part) {
                const auto [a, b, c] = corners_of(triangles[triangles.size() * part / kSamples]);
                samples.push_back(middle_of(a, b, c));
            }
        return samples;
    }

    static glm::vec3 middle_of(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c)
    {
        return glm::vec3((a + b + c) / 3.0);
    }

    /// Adds the middle of the longest stretch of inside on a line along x. The line goes through the one of every third
    /// triangle that faces it most. Adds nothing if there is no inside.
    void add_inside(std::span<const std::uint32_t> triangles, std::size_t part, std::vector<glm::vec3>& samples) const
    {
        double best = 0.0;
        glm::vec3 origin{0.0f};
        for (std::size_t i = part; i < triangles.size(); i += kSamples) {
            const auto [a, b, c] = corners_of(triangles[i]);
            const double facing = std::abs(normal_along_x(a, b, c));
            if (facing <= best) continue;
            best = facing;
            origin = middle_of(a, b, c);
        }
        if (best == 0.0) return;

        std::vector<LineHit> hits;
        const PlanarPoint o{origin.y, origin.z};
        for (const std::uint32_t t : triangles) {
            const auto [a, b, c] = corners_of(t);
            const int turns = edge_crossing(o, {a.y, a.z}, {b.y, b.z}) + edge_crossing(o, {b.y, b.z}, {c.y, c.z}) +
                              edge_crossing(o, {c.y, c.z}, {a.y, a.z});
            if (turns != 0) hits.push_back({x_on_plane(origin, a, b, c), turns});
        }
        if (const std::optional<double> x = middle_of_longest_inside(hits)) {
            origin.x = static_cast<float>(*x);
            samples.push_back(origin);
        }
    }

    static double normal_along_x(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c)
    {
        return (b.y - a.y) * (c.z - a.z) - (b.z - a.z) * (c.y - a.y);
    }

    /// Where the line along x through `origin` meets the triangle's plane, kept within the triangle's range.
    static double x_on_plane(const glm::dvec3& origin, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c)
    {
        const glm::dvec3 e = b - a, f = c - a;
        const glm::dvec3 n{e.y * f.z - e.z * f.y, e.z * f.x - e.x * f.z, e.x * f.y - e.y * f.x};
        const auto [lo, hi] = std::minmax({a.x, b.x, c.x});
        if (n.x == 0.0) return (lo + hi) / 2;
        const double x = a.x - (n.y * (origin.y - a.y) + n.z * (origin.z - a.z)) / n.x;
        return std::clamp(x, lo, hi);
    }

    /// Derives orientation and solids from containment.
    Solids group(std::span<const std::uint32_t> container) const
    {
        const std::size_t count = container.size();
        Solids solids;
        solids.flip.assign(count, 0);
        solids.solid.assign(count, kNone);

        Box box;
        for (const ConnectedShell& shell : shells_.shells) box.add(shell.box);
        const double noise = plane_noise(box.largest_coordinate());
        // A container is never smaller than its contents: containers come first in this order.
        std::vector<std::uint32_t> outside_in(count), owner(count);
        std::iota(outside_in.begin(), outside_in.end(), 0u);
        const auto size = [&](std::uint32_t s) { return std::abs(shells_.shells[s].volume6); };
        std::sort(outside_in.begin(), outside_in.end(),
                  [&](std::uint32_t a, std::uint32_t b) { return size(a) != size(b) ? size(a) > size(b) : a < b; });
        for (const std::uint32_t s : outside_in) {
            const ConnectedShell& shell = shells_.shells[s];
            const std::uint32_t around = container[s];
            solids.flip[s] = around == kNoContainer ? shell.volume6 < 0.0 : solids.flip[around];
            const double volume = solids.flip[s] ? -shell.volume6 : shell.volume6;
            // A plane that contains a shell without volume separates its two sides, which then fill a hole of the cap.
            const bool is_cavity = shell.closed && around != kNoContainer &&
                                   (volume < 0.0 || has_no_volume(shell.volume6, shell.box, noise));
            owner[s] = is_cavity ? owner[around] : s;
        }
        std::uint32_t solid_count = 0;
        for (std::uint32_t s = 0; s < count; ++s) {
            std::uint32_t& solid = solids.solid[owner[s]];
            if (solid == kNone) solid = solid_count++;
            solids.solid[s] = solid;
        }
        return solids;
    }

    const LinkedSurface& surface_;
    const Shells& shells_;
    std::span<const glm::vec3> positions_;
    std::vector<std::uint32_t> first_;      ///< of each shell in triangles_
    std::vector<std::uint32_t> triangles_;  ///< by shell
    std::vector<std::vector<glm::vec3>> samples_;
};

}  // namespace

Solids find_solids(const LinkedSurface& surface, const Shells& shells, std::span<const glm::vec3> positions)
{
    return SolidFinder(surface, shells, positions).run();
}

}  // namespace kerf::core
