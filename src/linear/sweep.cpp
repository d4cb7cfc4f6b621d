#include "linear/sweep.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <vector>

#include "linear/outline.h"
#include "linear/slices.h"

namespace kerf::core::linear {

namespace {

class Sweep final : public StackSearch
{
public:
    Sweep(const Fragment& whole, const glm::dvec3& normal, std::span<const double> offsets,
          const ProgressOfStep& progress)
        : whole_(whole), normal_(normal), offsets_(offsets.begin(), offsets.end())
    {
        find_heights();
        progress.at(0.2);
        list_triangles(progress.part(0.2, 1.0));
    }

    void find(std::size_t number, PlaneSection& section) const override
    {
        const Plane plane{normal_, offsets_[number]};
        const auto misses = [&](Side side) { section.side_of_object = side; };
        if (const std::optional<Side> side = missed_by_bounds(whole_, plane)) return misses(*side);
        if (!(highest_ - plane.offset > whole_.noise)) return misses(Side::negative);
        if (!(lowest_ - plane.offset < -whole_.noise)) return misses(Side::positive);
        OutlineFinder& finder = OutlineFinder::of(section);
        SortedTriangles& sorted = finder.sorted();
        sorted.clear();
        const auto class_of = [&](std::uint32_t v) {
            const double d = heights_[v] - plane.offset;
            return static_cast<std::uint8_t>((d < 0.0 ? kBelow : kOn) | (d > 0.0 ? kAbove : kOn));
        };
        const std::uint32_t place = place_[number];
        for (std::uint64_t i = first_[place]; i < first_[place + 1]; ++i)
            sorted.add(whole_.mesh, plane, listed_[i].triangle, listed_[i].group, class_of);
        // Those that the plane does not meet are not listed.
        sorted.keeps[Side::positive] |= highest_bottom_ - plane.offset > 0.0;
        sorted.keeps[Side::negative] |= lowest_top_ - plane.offset < 0.0;
        section.triangles_touched = first_[place + 1] - first_[place];
        finder.finish(whole_.mesh, plane, section);
    }

private:
    /// A triangle that a plane meets.
    struct Listed
    {
        std::uint32_t triangle, group;
    };

    void find_heights()
    {
        const Buffer<Vertex>& vertices = whole_.mesh.vertices;
        heights_.resize(vertices.size());
        const Plane level{normal_, 0.0};
        // Less 0 changes no bit of a sum but the sign of zero, which no comparison sees.
        for (std::size_t v = 0; v < vertices.size(); ++v) heights_[v] = level.signed_distance(vertices[v].position);
        // Centres of earlier fans do not count (rule 4).
        std::vector<bool> counts(heights_.size(), true);
        for (const std::uint32_t v : whole_.fan_centres) counts[v] = false;
        for (std::size_t v = 0; v < heights_.size(); ++v) {
            if (!counts[v]) continue;
            lowest_ = std::min(lowest_, heights_[v]);
            highest_ = std::max(highest_, heights_[v]);
        }
    }

    /// Lists the triangles by planes, from the lowest plane to the highest, in the order in which a cut goes through them.
    void list_triangles(const ProgressOfStep& progress)
    {
        std::vector<std::uint32_t> by_height(offsets_.size());
        std::iota(by_height.begin(), by_height.end(), 0u);
        std::ranges::sort(by_height, {}, [&](std::uint32_t i) { return std::pair(offsets_[i], i); });
        std::vector<double> sorted;
        place_.resize(offsets_.size());
        for (const std::uint32_t i : by_height) {
            place_[i] = static_cast<std::uint32_t>(sorted.size());
            sorted.push_back(offsets_[i]);
        }
        // Each triangle with the places of the first plane that it meets and of the first one above it.
        struct Reach
        {
            Listed listed;
            std::uint32_t begin, end;
        };
        std::vector<Reach> reaches;
        first_.assign(offsets_.size() + 2, 0);
        constexpr std::size_t kBetweenQuestions = std::size_t(1) << 16;
        std::size_t seen = 0;
        for_each_triangle([&](const Listed& listed, double bottom, double top) {
            if (++seen % kBetweenQuestions == 0) progress.at(double(seen) / double(whole_.mesh.triangles.size()));
            const auto begin = std::ranges::lower_bound(sorted, bottom);
            const auto end = std::find_if(begin, sorted.end(), [&](double offset) { return offset > top; });
            if (begin == end) return;
            const Reach reach{listed, static_cast<std::uint32_t>(begin - sorted.begin()),
                              static_cast<std::uint32_t>(end - sorted.begin())};
            reaches.push_back(reach);
            for (std::uint32_t place = reach.begin; place < reach.end; ++place) ++first_[place + 2];
        });
        std::partial_sum(first_.begin(), first_.end(), first_.begin());
        listed_.resize(first_.back());
        for (const Reach& reach : reaches)
            for (std::uint32_t place = reach.begin; place < reach.end; ++place)
                listed_[first_[place + 1]++] = reach.listed;
    }

    template <class Visit>
    void for_each_triangle(Visit visit)
    {
        const IndexedMesh& mesh = whole_.mesh;
        std::vector<std::uint32_t> order;
        order_groups(mesh, order);
        for (const std::uint32_t g : order)
            for (std::uint32_t i = mesh.groups[g].first; i < mesh.groups[g].first + mesh.groups[g].count; ++i) {
                const Triangle& t = mesh.triangles[i];
                const auto [bottom, top] = std::minmax({heights_[t[0]], heights_[t[1]], heights_[t[2]]});
                highest_bottom_ = std::max(highest_bottom_, bottom);
                lowest_top_ = std::min(lowest_top_, top);
                visit(Listed{i, g}, bottom, top);
            }
    }

    static constexpr double kInfinity = std::numeric_limits<double>::infinity();

    const Fragment& whole_;
    const glm::dvec3 normal_;
    const std::vector<double> offsets_;
    std::vector<double> heights_;                                  ///< of each vertex, along the normal
    double lowest_ = kInfinity, highest_ = -kInfinity;             ///< of those that count
    double highest_bottom_ = -kInfinity, lowest_top_ = kInfinity;  ///< of triangles
    std::vector<std::uint32_t> place_;                             ///< of each plane, from the lowest on
    std::vector<std::uint64_t> first_;                             ///< where the triangles of each place begin
    std::vector<Listed> listed_;
};

}  // namespace

std::unique_ptr<StackSearch> sweep(const Fragment& whole, const glm::dvec3& normal, std::span<const double> offsets,
                                   const ProgressOfStep& progress)
{
    return std::make_unique<Sweep>(whole, normal, offsets, progress);
}

}  // namespace kerf::core::linear
