#include "common/caps/touching_loops.h"

#include <algorithm>
#include <numeric>
#include <tuple>

#include "common/geometry/turn.h"

namespace kerf::core {

namespace {

/// A piece of an edge at a place where it begins or ends.
struct Ray
{
    glm::dvec2 towards;  ///< the other end of the edge
    Index edge;
    bool is_outgoing;  ///< it begins here, and the inside is on its left
};

class Parter
{
public:
    Parter(const CapOutline& outline, Succession& succession) : outline_(outline), succession_(succession)
    {
        const std::size_t n = outline.points.size();
        succession_.after.resize(n);
        succession_.shared.clear();
        before_.resize(n);
        end_.resize(n);
        for (Index loop = 0; loop + 1 < outline.loop_starts.size(); ++loop)
            for (Index i = outline.loop_starts[loop]; i < outline.loop_starts[loop + 1]; ++i) {
                end_[i] = succession_.after[i] = outline.successor(i, loop);
                before_[end_[i]] = i;
            }
    }

    void run()
    {
        std::vector<Index> by_place(outline_.points.size());
        std::iota(by_place.begin(), by_place.end(), Index{0});
        const auto key = [&](Index i) {
            const glm::vec3& p = outline_.positions[i];
            return std::tie(p.x, p.y, p.z);
        };
        std::sort(by_place.begin(), by_place.end(),
                  [&](Index a, Index b) { return std::tuple(key(a), a) < std::tuple(key(b), b); });
        for (std::size_t first = 0, last; first < by_place.size(); first = last) {
            for (last = first + 1; last < by_place.size() && key(by_place[first]) == key(by_place[last]);) ++last;
            if (last - first > 1) part({by_place.data() + first, last - first});
        }
    }

private:
    void part(std::span<const Index> points)
    {
        const glm::dvec2& place = outline_.points[points.front()];
        rays_.clear();
        for (const Index i : points) {
            rays_.push_back({outline_.points[before_[i]], before_[i], false});
            rays_.push_back({outline_.points[end_[i]], i, true});
        }
        const auto is_below = [&](const glm::dvec2& p) { return p.y < place.y || (p.y == place.y && p.x < place.x); };
        // Around the place from the positive x axis on.
        const auto precedes = [&](const Ray& a, const Ray& b) {
            const bool a_below = is_below(a.towards), b_below = is_below(b.towards);
            return a_below != b_below ? b_below : turn(place, a.towards, b.towards) > 0.0;
        };
        std::sort(rays_.begin(), rays_.end(), precedes);
        // From an outgoing ray on, the inside lies between it and the next one, which must come in.
        for (std::size_t r = 0; r < rays_.size(); ++r) {
            const Ray &ray = rays_[r], &next = rays_[(r + 1) % rays_.size()];
            if (ray.is_outgoing == next.is_outgoing || (r + 1 < rays_.size() && !precedes(ray, next))) return;
        }
        bool changed = false;
        for (std::size_t r = 0; r < rays_.size(); ++r) {
            const Ray &ray = rays_[r], &next = rays_[(r + 1) % rays_.size()];
            if (!ray.is_outgoing) continue;
            changed = changed || succession_.after[next.edge] != ray.edge;
            succession_.after[next.edge] = ray.edge;
        }
        if (changed) succession_.shared.insert(succession_.shared.end(), points.begin(), points.end());
    }

    const CapOutline& outline_;
    Succession& succession_;
    std::vector<Index> before_, end_;  // the edge that leads to each point, and the point that each edge leads to
    std::vector<Ray> rays_;
};

}  // namespace

void part_touching_loops(const CapOutline& outline, Succession& succession)
{
    Parter(outline, succession).run();
}

}  // namespace kerf::core
