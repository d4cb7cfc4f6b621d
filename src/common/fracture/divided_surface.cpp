#include "common/fracture/divided_surface.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <unordered_map>
#include <utility>

#include "common/fracture/border_line.h"
#include "common/fracture/cell_finder.h"
#include "common/mesh/index.h"
#include "common/mesh/position_order.h"

namespace kerf::core {

namespace {

/// What a point is named by that several triangles or cells have in common: an edge of the mesh and two cells, or a triangle
/// and three.
using PointName = std::array<std::uint32_t, 4>;

struct HashOfName
{
    std::size_t operator()(const PointName& name) const
    {
        std::uint64_t hash = 0xcbf29ce484222325;
        for (const std::uint32_t part : name) hash = (hash ^ part) * 0x100000001b3;
        return hash ^ (hash >> 29);
    }
};

/// A side of a part of a triangle: a side of the triangle (from corner `number` on), or a border on another cell.
struct PartSide
{
    bool is_border = false;
    std::uint32_t number = 0;
};

class SurfaceDivider
{
public:
    SurfaceDivider(std::span<const glm::vec3> points, std::span<const PointTriple> triangles,
                   const CellDiagram& diagram)
        : points_(points), triangles_(triangles), diagram_(diagram)
    {
        result_.parts.resize(diagram.sites.size());
        place_of_distances_.resize(diagram.sites.size(), 0);
        place_of_reached_.resize(diagram.sites.size(), 0);
    }

    DividedSurface divide(const ProgressOfStep& progress)
    {
        // Only points that a triangle has: there may be others.
        CellFinder finder(diagram_);
        std::vector<std::uint32_t> cells(points_.size(), kNone);
        const auto cell_at = [&](std::uint32_t point) {
            if (cells[point] == kNone) cells[point] = finder.cell_of(points_[point]);
            return cells[point];
        };
        progress.at(0.0);
        // One triangle may lie in thousands of cells.
        std::uint32_t looks = 0;
        constexpr std::uint32_t kBetweenQuestions = 1u << 12;
        for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
            const auto look = [&] {
                if (++looks % kBetweenQuestions == 0) progress.at(double(t) / double(triangles_.size()));
            };
            look();
            const PointTriple& corners = triangles_[t];
            const SiteTriple at{cell_at(corners[0]), cell_at(corners[1]), cell_at(corners[2])};
            if (at[0] == at[1] && at[1] == at[2])
                result_.parts[at[0]].push_back({corners, t});
            else
                divide_triangle(t, at, look);
        }
        return std::move(result_);
    }

private:
    template <class Look>
    void divide_triangle(std::uint32_t triangle, const SiteTriple& cells_of_corners, Look look)
    {
        ++result_.crossing_triangles;
        triangle_ = triangle;
        corners_ = triangles_[triangle];
        distances_.clear();
        // Each part borders on the next ones: all are found from any.
        reached_.clear();
        reach(cells_of_corners[0]);
        for (std::size_t i = 0; i < reached_.size(); ++i) {
            look();
            cell_ = reached_[i];
            cut_out();
            if (sides_.size() > 2) add_part();
        }
    }

    void reach(std::uint32_t cell)
    {
        std::uint32_t& at = place_of_reached_[cell];
        if (at < reached_.size() && reached_[at] == cell) return;
        at = static_cast<std::uint32_t>(reached_.size());
        reached_.push_back(cell);
    }

    /// Squared distances of the corners from a site.
    const std::array<double, 3>& distances(std::uint32_t site)
    {
        std::uint32_t& at = place_of_distances_[site];
        if (at < distances_.size() && distances_[at].first == site) return distances_[at].second;
        at = static_cast<std::uint32_t>(distances_.size());
        const glm::dvec3& place = diagram_.sites[site];
        return distances_
            .emplace_back(site, std::array{squared_distance_to_site(points_[corners_[0]], place),
                                           squared_distance_to_site(points_[corners_[1]], place),
                                           squared_distance_to_site(points_[corners_[2]], place)})
            .second;
    }

    /// The line of a side, positive towards the inside.
    BorderLine line_of(const PartSide& side)
    {
        if (!side.is_border) return BorderLine::side(static_cast<int>(side.number));
        const std::array<double, 3> other = distances(side.number);
        return {other, distances(cell_)};
    }

    /// Where the side begins: which side of the border on `other` it lies on.
    bool is_inside(std::size_t i, std::uint32_t other)
    {
        const PartSide &before = sides_[(i + sides_.size() - 1) % sides_.size()], &side = sides_[i];
        const std::array<double, 3> theirs = distances(other), ours = distances(cell_);
        int sign;
        if (!before.is_border && !side.is_border)
            sign = theirs[side.number] > ours[side.number] ? 1 : theirs[side.number] < ours[side.number] ? -1 : 0;
        else
            sign = side_of_crossing(line_of(before), line_of(side), {theirs, ours});
        return sign > 0 || (sign == 0 && cell_ < other);
    }

    /// The sides of that part of the triangle that lies in the cell.
    void cut_out()
    {
        sides_ = {{false, 0}, {false, 1}, {false, 2}};
        const std::array<double, 3> ours = distances(cell_);
        for (const std::uint32_t other : diagram_.neighbours[cell_]) {
            const std::array<double, 3>& theirs = distances(other);
            if (theirs[0] > ours[0] && theirs[1] > ours[1] && theirs[2] > ours[2]) continue;
            inside_.clear();
            for (std::size_t i = 0; i < sides_.size(); ++i) inside_.push_back(is_inside(i, other));
            const std::size_t kept = static_cast<std::size_t>(std::ranges::count(inside_, char(true)));
            if (kept == sides_.size()) continue;
            rest_.clear();
            for (std::size_t i = 0; kept > 0 && i < sides_.size(); ++i) {
                const bool begins = inside_[i] != 0, ends = inside_[(i + 1) % sides_.size()] != 0;
                if (begins || ends) rest_.push_back(sides_[i]);
                if (begins && !ends) rest_.push_back({true, other});
            }
            sides_.swap(rest_);
            if (sides_.size() < 3) return;
        }
    }

    void add_part()
    {
        std::vector<std::uint32_t>& outline = outline_;
        outline.clear();
        for (std::size_t i = 0; i < sides_.size(); ++i)
            outline.push_back(beginning_of(sides_[(i + sides_.size() - 1) % sides_.size()], sides_[i]));
        // A fan from the same corner, whichever the triangle begins with.
        const std::size_t n = outline.size(), apex = first_of(outline);
        for (std::size_t i = 1; i + 1 < n; ++i)
            result_.parts[cell_].push_back(
                {{outline[apex], outline[(apex + i) % n], outline[(apex + i + 1) % n]}, triangle_});
        for (std::size_t i = 0; i < sides_.size(); ++i) {
            if (!sides_[i].is_border) continue;
            const std::uint32_t other = sides_[i].number;
            if (cell_ < other)
                result_.borders[{cell_, other}].push_back({outline[(i + 1) % outline.size()], outline[i]});
            reach(other);
        }
    }

    const glm::vec3& position(std::uint32_t point) const
    {
        return point < points_.size() ? points_[point] : result_.new_points[point - points_.size()];
    }

    /// The corner that comes first in space.
    std::size_t first_of(const std::vector<std::uint32_t>& outline) const
    {
        std::size_t first = 0;
        for (std::size_t i = 1; i < outline.size(); ++i)
            if (lexicographically_less(position(outline[i]), position(outline[first]))) first = i;
        return first;
    }

    std::uint32_t beginning_of(const PartSide& before, const PartSide& side)
    {
        if (!before.is_border && !side.is_border) return corners_[side.number];
        if (before.is_border && side.is_border) return place_of_three(before.number, side.number);
        const PartSide &edge = before.is_border ? side : before, &border = before.is_border ? before : side;
        return place_on_edge(edge.number, border.number);
    }

    std::uint32_t place_on_edge(std::uint32_t number, std::uint32_t other)
    {
        const auto [a, b] = std::minmax(corners_[number], corners_[(number + 1) % 3]);
        const auto [first, second] = std::minmax(cell_, other);
        const auto [place, is_new] = numbers_.try_emplace({a, b, first, second}, next_number());
        if (is_new) {
            const auto difference = [&, one = first, two = second](std::uint32_t point) {
                return squared_distance_to_site(points_[point], diagram_.sites[one]) -
                       squared_distance_to_site(points_[point], diagram_.sites[two]);
            };
            const bool is_turned = lexicographically_less(points_[b], points_[a]);
            const std::uint32_t begin = is_turned ? b : a, end = is_turned ? a : b;
            const double at_begin = difference(begin), at_end = difference(end);
            const double share = at_begin / (at_begin - at_end);
            // Where the whole edge is equally far from both, anywhere will do.
            const double t = share >= 0.0 && share <= 1.0 ? share : 0.0;
            const glm::dvec3 from(points_[begin]), to(points_[end]);
            add_point(from + t * (to - from), {{begin, end, SurfacePlace::kNoPoint}, {1.0 - t, t, 0.0}});
        }
        return place->second;
    }

    /// Where three cells meet in the triangle. `before` and `after` lie behind the sides that lead to it and from it.
    std::uint32_t place_of_three(std::uint32_t before, std::uint32_t after)
    {
        SiteTriple sites{cell_, before, after};
        std::ranges::sort(sites);
        const auto [place, is_new] =
            numbers_.try_emplace({kOfTriangle + sites[0], triangle_, sites[1], sites[2]}, next_number());
        if (is_new) {
            add_crossing_of(sites);
            // Counter-clockwise around it lie this cell, the one before and the one after. If these ascend when they are
            // gone round, so they lie around the diagram's edge, seen from where it leads to: out of the surface.
            const int ascents = int(cell_ < before) + int(before < after) + int(after < cell_);
            result_.piercings[sites].push_back({place->second, ascents == 2});
        }
        return place->second;
    }

    void add_crossing_of(const SiteTriple& sites)
    {
        const std::array<double, 3> a = distances(sites[0]), b = distances(sites[1]), c = distances(sites[2]);
        const glm::dvec3 one{b[0] - a[0], b[1] - a[1], b[2] - a[2]}, two{c[0] - a[0], c[1] - a[1], c[2] - a[2]};
        const glm::dvec3 weights = glm::cross(one, two);
        std::array<int, 3> order{0, 1, 2};
        std::ranges::sort(order, [&](int i, int j) {
            return lexicographically_less(points_[corners_[std::size_t(i)]], points_[corners_[std::size_t(j)]]);
        });
        const double sum = (weights[order[0]] + weights[order[1]]) + weights[order[2]];
        SurfacePlace place;
        glm::dvec3 position(0.0);
        for (std::size_t i = 0; i < 3; ++i) {
            const double share = sum == 0.0 ? (i == 0 ? 1.0 : 0.0) : glm::clamp(weights[order[i]] / sum, 0.0, 1.0);
            place.corners[i] = corners_[std::size_t(order[i])];
            place.shares[i] = share;
            position += share * glm::dvec3(points_[place.corners[i]]);
        }
        add_point(position, place);
    }

    void add_point(const glm::dvec3& position, const SurfacePlace& place)
    {
        // -0 does not occur in a mesh.
        result_.new_points.push_back(glm::vec3(position) + 0.0f);
        result_.places.push_back(place);
    }

    std::uint32_t next_number() const { return static_cast<std::uint32_t>(points_.size() + result_.new_points.size()); }

    /// Names of places in triangles begin with numbers that no point has.
    static constexpr std::uint32_t kOfTriangle = 1u << 31;

    std::span<const glm::vec3> points_;
    std::span<const PointTriple> triangles_;
    const CellDiagram& diagram_;
    DividedSurface result_;
    std::unordered_map<PointName, std::uint32_t, HashOfName> numbers_;

    // Of the triangle that is divided
    std::uint32_t triangle_ = 0;
    PointTriple corners_{};
    std::vector<std::pair<std::uint32_t, std::array<double, 3>>> distances_;
    std::vector<std::uint32_t> reached_;  ///< cells that have a part of it
    /// Of each site, where in these lists it is, if that is where it is.
    std::vector<std::uint32_t> place_of_distances_, place_of_reached_;

    // Of the part that is cut out
    std::uint32_t cell_ = 0;
    std::vector<PartSide> sides_, rest_;  ///< counter-clockwise; what is left of them
    std::vector<std::uint32_t> outline_;
    std::vector<char> inside_;
};

}  // namespace

DividedSurface divide_surface(std::span<const glm::vec3> points, std::span<const PointTriple> triangles,
                              const CellDiagram& diagram, const ProgressOfStep& progress)
{
    return SurfaceDivider(points, triangles, diagram).divide(progress);
}

}  // namespace kerf::core
