#include "common/fracture/fragments.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <map>
#include <utility>

#include "common/geometry/disjoint_sets.h"
#include "common/geometry/ray_crossing.h"
#include "common/mesh/index.h"

namespace kerf::core {

namespace {

/// A connected part of the surface of a cell.
struct Shell
{
    std::uint32_t cell = 0;
    std::vector<PartTriangle> surface;
    double volume = 0.0;  ///< below 0: a cavity
};

/// A triangle of a contact, and the shells that it closes.
struct Facet
{
    std::uint32_t contact = 0;
    PointTriple corners{};  ///< as it closes the first
    std::array<std::uint32_t, 2> shells{kNone, kNone};
};

class FragmentFinder
{
public:
    FragmentFinder(std::span<const glm::vec3> points, SplitSolid& split, double least_volume, const glm::dvec3& middle,
                   std::span<const KnownCell> known)
        : points_(points), split_(split), least_volume_(least_volume), middle_(middle), known_(known)
    {
    }

    Fragments find()
    {
        list_facets();
        place_.resize(points_.size() + split_.new_points.size(), kNone);
        for (std::uint32_t cell = 0; cell < split_.parts.size(); ++cell) find_shells(cell);
        for (std::uint32_t s = 0; s < shells_.size(); ++s) solid_.push_back(s);
        for (std::uint32_t cell = 0; cell < split_.parts.size(); ++cell) place_cavities(cell);
        join_small_ones();
        return collect();
    }

private:
    glm::dvec3 position(std::uint32_t point) const
    {
        const glm::vec3& p = point < points_.size() ? points_[point] : split_.new_points[point - points_.size()];
        return glm::dvec3(p) - middle_;
    }

    /// Facets by the cells that they close.
    void list_facets()
    {
        facets_of_.resize(split_.parts.size());
        for (std::uint32_t c = 0; c < split_.contacts.size(); ++c)
            for (const PointTriple& corners : split_.contacts[c].triangles) {
                for (const std::uint32_t cell : split_.contacts[c].cells)
                    facets_of_[cell].push_back(static_cast<std::uint32_t>(facets_.size()));
                facets_.push_back({c, corners, {kNone, kNone}});
            }
    }

    std::size_t side_of(const Facet& facet, std::uint32_t cell) const
    {
        return split_.contacts[facet.contact].cells[0] == cell ? 0 : 1;
    }

    /// Corners of a facet as they run on a cell.
    PointTriple corners_on(const Facet& facet, std::size_t side) const
    {
        const auto& [a, b, c] = facet.corners;
        return side == 0 ? facet.corners : PointTriple{a, c, b};
    }

    /// The number of a point among those of the cell.
    std::uint32_t local(std::uint32_t point)
    {
        if (place_[point] == kNone) {
            place_[point] = sets_.add();
            used_.push_back(point);
        }
        return place_[point];
    }

    void unite(const PointTriple& corners)
    {
        const std::uint32_t first = local(corners[0]);
        sets_.unite(first, local(corners[1]));
        sets_.unite(first, local(corners[2]));
    }

    double six_volumes(const PointTriple& corners) const
    {
        return glm::dot(position(corners[0]), glm::cross(position(corners[1]), position(corners[2])));
    }

    void find_shells(std::uint32_t cell)
    {
        if (!known_.empty() && known_.front().cell == cell) return add_known_shell(cell);
        sets_.clear();
        for (const PartTriangle& part : split_.parts[cell]) unite(part.corners);
        for (const std::uint32_t facet : facets_of_[cell]) unite(facets_[facet].corners);

        std::vector<std::uint32_t> shell_of(sets_.size(), kNone);
        first_shell_.push_back(static_cast<std::uint32_t>(shells_.size()));
        const auto shell_at = [&](std::uint32_t point) {
            std::uint32_t& shell = shell_of[sets_.find(place_[point])];
            if (shell == kNone) {
                shell = static_cast<std::uint32_t>(shells_.size());
                shells_.push_back({cell, {}, 0.0});
            }
            return shell;
        };
        for (const PartTriangle& part : split_.parts[cell]) {
            Shell& shell = shells_[shell_at(part.corners[0])];
            shell.surface.push_back(part);
            shell.volume += six_volumes(part.corners) / 6.0;
        }
        split_.parts[cell] = {};
        for (const std::uint32_t number : facets_of_[cell]) {
            Facet& facet = facets_[number];
            const std::size_t side = side_of(facet, cell);
            facet.shells[side] = shell_at(facet.corners[0]);
            shells_[facet.shells[side]].volume += six_volumes(corners_on(facet, side)) / 6.0;
        }
        for (const std::uint32_t point : used_) place_[point] = kNone;
        used_.clear();
    }

    void add_known_shell(std::uint32_t cell)
    {
        const auto number = static_cast<std::uint32_t>(shells_.size());
        first_shell_.push_back(number);
        Shell& shell = shells_.emplace_back(Shell{cell, std::move(split_.parts[cell]), known_.front().volume});
        known_ = known_.subspan(1);
        for (const PartTriangle& part : shell.surface) shell.volume += six_volumes(part.corners) / 6.0;
        for (const std::uint32_t facet : facets_of_[cell]) {
            const std::size_t side = side_of(facets_[facet], cell);
            facets_[facet].shells[side] = number;
            shell.volume += six_volumes(corners_on(facets_[facet], side)) / 6.0;
        }
    }

    /// A cavity belongs to the smallest of its cell's shells that goes around it.
    void place_cavities(std::uint32_t cell)
    {
        const std::uint32_t first = first_shell_[cell];
        const std::uint32_t last =
            cell + 1 < first_shell_.size() ? first_shell_[cell + 1] : static_cast<std::uint32_t>(shells_.size());
        for (std::uint32_t cavity = first; cavity < last; ++cavity) {
            if (shells_[cavity].volume >= 0.0) continue;
            std::uint32_t found = kNone;
            for (std::uint32_t outer = first; outer < last; ++outer)
                if (shells_[outer].volume > 0.0 && (found == kNone || shells_[outer].volume < shells_[found].volume) &&
                    lies_in(cavity, outer))
                    found = outer;
            if (found != kNone) solid_[cavity] = found;
        }
    }

    glm::vec3 corner(const PointTriple& corners, std::size_t i) const
    {
        const std::uint32_t point = corners[i];
        return point < points_.size() ? points_[point] : split_.new_points[point - points_.size()];
    }

    template <class Visit>
    void for_each_triangle(std::uint32_t shell, Visit visit) const
    {
        for (const PartTriangle& part : shells_[shell].surface) visit(part.corners);
        for (const std::uint32_t number : facets_of_[shells_[shell].cell])
            for (std::size_t side = 0; side < 2; ++side)
                if (facets_[number].shells[side] == shell) visit(corners_on(facets_[number], side));
    }

    bool lies_in(std::uint32_t cavity, std::uint32_t outer) const
    {
        AxisRay ray;
        for_each_triangle(cavity, [&](const PointTriple& corners) { ray.origin = corner(corners, 0); });
        int winding = 0;
        for_each_triangle(outer, [&](const PointTriple& c) {
            winding += ray_crossing(ray, corner(c, 0), corner(c, 1), corner(c, 2));
        });
        return winding != 0;
    }

    double area(const Facet& facet) const { return 0.5 * glm::length(twice_area(facet)); }
    /// Across it, away from the first shell.
    glm::dvec3 twice_area(const Facet& facet) const
    {
        const glm::dvec3 a = position(facet.corners[0]);
        return glm::cross(position(facet.corners[1]) - a, position(facet.corners[2]) - a);
    }

    std::uint32_t group(std::uint32_t shell) { return groups_.find(solid_[shell]); }

    void join_small_ones()
    {
        for (std::size_t s = 0; s < shells_.size(); ++s) groups_.add();
        std::vector<double> volume(shells_.size(), 0.0);
        for (std::uint32_t s = 0; s < shells_.size(); ++s) volume[solid_[s]] += shells_[s].volume;

        // Neighbours of each group. Those of a group that was joined are found by its members.
        std::vector<std::vector<std::uint32_t>> neighbours(shells_.size());
        for (const Facet& facet : facets_) {
            const std::uint32_t a = solid_[facet.shells[0]], b = solid_[facet.shells[1]];
            if (a == b) continue;
            neighbours[a].push_back(b);
            neighbours[b].push_back(a);
        }
        std::vector<std::uint32_t> order;
        for (std::uint32_t s = 0; s < shells_.size(); ++s)
            if (solid_[s] == s && !(volume[s] >= least_volume_)) order.push_back(s);
        std::ranges::sort(order, [&](std::uint32_t a, std::uint32_t b) {
            return volume[a] != volume[b] ? volume[a] < volume[b] : a < b;
        });
        for (const std::uint32_t start : order) {
            std::uint32_t s = groups_.find(start);
            while (!(volume[s] >= least_volume_)) {
                std::uint32_t largest = kNone;
                for (const std::uint32_t other : neighbours[s]) {
                    const std::uint32_t g = groups_.find(other);
                    if (g != s && (largest == kNone || volume[g] > volume[largest])) largest = g;
                }
                if (largest == kNone) break;
                const double together = volume[s] + volume[largest];
                std::vector<std::uint32_t> all = std::move(neighbours[s]);
                all.insert(all.end(), neighbours[largest].begin(), neighbours[largest].end());
                groups_.unite(s, largest);
                s = groups_.find(s);
                volume[s] = together;
                std::ranges::sort(all);
                all.erase(std::unique(all.begin(), all.end()), all.end());
                neighbours[s] = std::move(all);
            }
        }
    }

    Fragments collect()
    {
        Fragments result;
        std::vector<std::uint32_t> fragment_of(shells_.size(), kNone);
        const auto fragment_at = [&](std::uint32_t shell) {
            std::uint32_t& fragment = fragment_of[group(shell)];
            if (fragment == kNone) {
                fragment = static_cast<std::uint32_t>(result.fragments.size());
                result.fragments.emplace_back();
            }
            return fragment;
        };
        for (std::uint32_t s = 0; s < shells_.size(); ++s) {
            Fragment& fragment = result.fragments[fragment_at(s)];
            if (fragment.cells.empty() || fragment.cells.back() != shells_[s].cell)
                fragment.cells.push_back(shells_[s].cell);
            const bool is_first = fragment.surface.empty();
            if (is_first)
                fragment.surface = std::move(shells_[s].surface);
            else
                fragment.surface.insert(fragment.surface.end(), shells_[s].surface.begin(), shells_[s].surface.end());
            if (!is_first) std::ranges::stable_sort(fragment.surface, {}, &PartTriangle::source);
            fragment.volume += shells_[s].volume;
        }
        add_facets(fragment_at, result);
        return result;
    }

    template <class FragmentAt>
    void add_facets(FragmentAt fragment_at, Fragments& result)
    {
        std::map<std::array<std::uint32_t, 2>, Bond> bonds;
        for (const Facet& facet : facets_) {
            const std::array<std::uint32_t, 2> of{fragment_at(facet.shells[0]), fragment_at(facet.shells[1])};
            if (of[0] == of[1]) continue;
            for (std::size_t side = 0; side < 2; ++side)
                result.fragments[of[side]].inside.push_back({corners_on(facet, side), facet.contact, side == 1});
            const auto [least, most] = std::minmax(of[0], of[1]);
            Bond& bond = bonds.try_emplace({least, most}, Bond{least, most}).first->second;
            const double share = area(facet);
            glm::dvec3 sum(0.0);
            for (const std::uint32_t point : facet.corners) sum += position(point);
            bond.area += share;
            bond.centre += share / 3.0 * sum;
            bond.normal += of[0] == least ? twice_area(facet) : -twice_area(facet);
        }
        for (auto& [fragments, bond] : bonds) {
            bond.centre = (bond.area > 0.0 ? bond.centre / bond.area : bond.centre) + middle_;
            const double length = glm::length(bond.normal);
            if (length > 0.0) bond.normal /= length;
            result.bonds.push_back(bond);
        }
    }

    std::span<const glm::vec3> points_;
    SplitSolid& split_;
    double least_volume_;
    glm::dvec3 middle_;
    std::span<const KnownCell> known_;  ///< that are still to come
    std::vector<Facet> facets_;
    std::vector<std::vector<std::uint32_t>> facets_of_;  ///< of each cell
    std::vector<Shell> shells_;                          ///< cell by cell
    std::vector<std::uint32_t> first_shell_;             ///< of each cell
    std::vector<std::uint32_t> solid_;                   ///< of each shell: itself, or the shell whose cavity it is
    DisjointSets groups_{0};                             ///< of solids

    // Of the cell that is looked at
    DisjointSets sets_{0};
    std::vector<std::uint32_t> place_;  ///< of each point in it
    std::vector<std::uint32_t> used_;
};

}  // namespace

Fragments find_fragments(std::span<const glm::vec3> points, SplitSolid& split, double least_volume,
                         const glm::dvec3& middle, std::span<const KnownCell> known)
{
    return FragmentFinder(points, split, least_volume, middle, known).find();
}

}  // namespace kerf::core
