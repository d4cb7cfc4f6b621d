#include "common/cutting/group_pieces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <tuple>
#include <utility>

#include "common/caps/holes.h"
#include "common/cutting/cut_geometry.h"
#include "common/geometry/disjoint_sets.h"
#include "common/geometry/dominant_axis.h"
#include "common/mesh/index.h"

namespace kerf::core {

namespace {

/// The parts of one solid on one side.
struct SolidParts
{
    std::vector<std::uint32_t> shown;     ///< cut parts, and whole shells that are no cavities
    std::vector<std::uint32_t> cavities;  ///< whole shells of negative volume
    bool is_cut = false;
};

std::vector<std::uint32_t> numbered(DisjointSets& pieces, std::size_t part_count)
{
    // A set's representative is its smallest part, so it is met first.
    std::vector<std::uint32_t> number(part_count);
    std::uint32_t count = 0;
    for (std::uint32_t part = 0; part < part_count; ++part) {
        const std::uint32_t first = pieces.find(part);
        number[part] = first == part ? count++ : number[first];
    }
    return number;
}

/// One side while its pieces are found.
class SideGrouping
{
public:
    SideGrouping(const SideParts& side, Side which)
        : pieces(static_cast<std::uint32_t>(side.parts.size())), side_(side), which_(which)
    {
        std::vector<std::uint32_t> ids;
        for (const SurfacePart& part : side.parts) ids.push_back(part.solid);
        std::sort(ids.begin(), ids.end());
        ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
        for (const SurfacePart& part : side.parts)
            solid_of_.push_back(
                static_cast<std::uint32_t>(std::lower_bound(ids.begin(), ids.end(), part.solid) - ids.begin()));
        solids_.resize(ids.size());
        for (std::uint32_t part = 0; part < side.parts.size(); ++part) {
            SolidParts& solid = solids_[solid_of_[part]];
            const SurfacePart& p = side.parts[part];
            const bool is_cavity = !p.is_cut && !p.is_flat && p.volume6 < 0.0;
            (is_cavity ? solid.cavities : solid.shown).push_back(part);
            solid.is_cut = solid.is_cut || p.is_cut;
        }
    }

    /// Whether a solid has been cut into several parts; only then does the outline matter.
    bool has_come_apart() const
    {
        return std::any_of(solids_.begin(), solids_.end(),
                           [](const SolidParts& solid) { return solid.is_cut && solid.shown.size() > 1; });
    }

    void join_holes_of_solids(const SectionOutline& outline, int axis)
    {
        std::vector<std::uint64_t> parts;
        parts.reserve(outline.edges().size());
        for (const OutlineEdge& edge : outline.edges()) parts.push_back(edge.part[which_]);
        const DividedOutline divided = divide_outline(outline.plane(), outline.points(), outline.edges(), parts);
        std::vector<std::vector<FlatLoop>> flat(solids_.size());
        for (const OutlinePath& path : divided.paths) {
            const std::uint32_t part = outline.edges()[divided.edges[path.first]].part[which_];
            if (!path.closed || path.count < 3 || part == kNoPart) continue;
            const std::uint32_t solid = solid_of_[part];
            if (solids_[solid].shown.size() > 1)
                flat[solid].push_back(
                    flatten(outline, std::span(divided.edges).subspan(path.first, path.count), part, axis));
        }
        for (const auto& loops : flat) join_holes(loops, pieces);
    }

    /// Finds in each solid the first piece that has volume: the piece at the first outline edge that one piece alone
    /// has, or else at the first edge. The direction of an edge does not matter.
    void find_first_pieces(const SectionOutline& outline)
    {
        struct Claim
        {
            std::uint32_t solid;
            glm::vec3 low, high;
            std::uint32_t piece, source;
        };
        const std::vector<bool> has_volume = find_volume();
        std::vector<Claim> claims;
        claims.reserve(outline.edges().size());
        for (const OutlineEdge& edge : outline.edges()) {
            const std::uint32_t part = edge.part[which_];
            if (part == kNoPart) continue;
            const std::uint32_t piece = pieces.find(part);
            if (!has_volume[piece]) continue;
            Claim claim{solid_of_[part], outline.position(edge.from), outline.position(edge.to), piece, edge.source};
            if (lexicographically_less(claim.high, claim.low)) std::swap(claim.low, claim.high);
            claims.push_back(claim);
        }
        const auto is_less = [](const Claim& a, const Claim& b) {
            if (a.solid != b.solid) return a.solid < b.solid;
            if (!same_position(a.low, b.low)) return lexicographically_less(a.low, b.low);
            if (!same_position(a.high, b.high)) return lexicographically_less(a.high, b.high);
            return false;
        };
        std::sort(claims.begin(), claims.end(), [&](const Claim& a, const Claim& b) {
            return is_less(a, b) || (!is_less(b, a) && a.source < b.source);
        });
        first_piece_.assign(solids_.size(), kNone);
        std::vector<bool> is_alone(solids_.size(), false);
        for (std::size_t first = 0, last; first < claims.size(); first = last) {
            last = first + 1;
            while (last < claims.size() && !is_less(claims[first], claims[last])) ++last;
            const std::uint32_t solid = claims[first].solid;
            const bool alone = std::all_of(claims.begin() + static_cast<std::ptrdiff_t>(first),
                                           claims.begin() + static_cast<std::ptrdiff_t>(last),
                                           [&](const Claim& c) { return c.piece == claims[first].piece; });
            if (first_piece_[solid] != kNone && (is_alone[solid] || !alone)) continue;
            first_piece_[solid] = claims[first].piece;
            is_alone[solid] = alone;
        }
    }

    /// Joins pieces without volume with the first piece of their solid that has some.
    void join_flat_pieces(const SectionOutline& outline)
    {
        if (std::none_of(side_.parts.begin(), side_.parts.end(), [](const SurfacePart& part) { return part.is_flat; }))
            return;
        find_first_pieces(outline);
        const std::vector<bool> has_volume = find_volume();
        for (std::uint32_t part = 0; part < side_.parts.size(); ++part) {
            const std::uint32_t first = first_piece_[solid_of_[part]];
            if (side_.parts[part].is_flat && first != kNone && !has_volume[pieces.find(part)])
                pieces.unite(part, first);
        }
    }

    /// `outline` is null if no solid has come apart.
    void join_the_rest(const AxisRay& away, const SectionOutline* outline)
    {
        join_cavities(away, outline);
        for (const SolidParts& solid : solids_) {
            if (solid.is_cut) continue;
            const std::uint32_t first = (solid.shown.empty() ? solid.cavities : solid.shown).front();
            for (const auto* some : {&solid.shown, &solid.cavities})
                for (const std::uint32_t part : *some) pieces.unite(first, part);
        }
    }

    std::vector<std::uint32_t> result() { return numbered(pieces, side_.parts.size()); }

    DisjointSets pieces;

private:
    /// A cavity and the piece that it lies in, named by its first part.
    struct Home
    {
        std::uint32_t cavity, piece;
    };

    /// Whether pieces have volume, by their representatives.
    std::vector<bool> find_volume()
    {
        std::vector<bool> has_volume(side_.parts.size(), false);
        for (std::uint32_t part = 0; part < side_.parts.size(); ++part)
            if (!side_.parts[part].is_flat) has_volume[pieces.find(part)] = true;
        return has_volume;
    }

    /// Joins each cavity of a cut solid with the piece it lies in: the one whose winding number around it is not 0. If
    /// pieces overlap, there may be several; they become one.
    void join_cavities(const AxisRay& direction, const SectionOutline* outline)
    {
        // Joining a cavity changes the names of pieces, so all homes are found before any is joined.
        std::vector<Home> homes, sought;
        for (const SolidParts& solid : solids_) {
            if (!solid.is_cut || solid.cavities.empty() || solid.shown.empty()) continue;
            std::uint32_t first = pieces.find(solid.shown.front());
            bool is_one = true;
            for (const std::uint32_t part : solid.shown) {
                const std::uint32_t piece = pieces.find(part);
                is_one = is_one && piece == first;
                first = std::min(first, piece);
            }
            for (const std::uint32_t cavity : solid.cavities) (is_one ? homes : sought).push_back({cavity, first});
        }
        if (!sought.empty()) {
            // A cavity that no count claims, because it touches the surface around it, goes to the first piece.
            if (outline != nullptr) find_first_pieces(*outline);
            for (Home& home : sought)
                if (outline != nullptr && first_piece_[solid_of_[home.cavity]] != kNone)
                    home.piece = first_piece_[solid_of_[home.cavity]];
            look_for_homes(sought, direction, homes);
        }
        for (const Home& home : homes) pieces.unite(home.cavity, home.piece);
    }

    /// Adds all homes that counting finds, and the home in `sought` for each cavity without one.
    void look_for_homes(const std::vector<Home>& sought, const AxisRay& direction, std::vector<Home>& homes)
    {
        std::vector<AxisRay> rays(sought.size(), direction);
        for (std::size_t i = 0; i < sought.size(); ++i) rays[i].origin = side_.parts[sought[i].cavity].sample;
        std::vector<bool> is_shown(side_.parts.size(), false);
        for (const SolidParts& solid : solids_)
            for (const std::uint32_t part : solid.shown) is_shown[part] = true;

        struct Term
        {
            std::uint32_t ray, piece;
            int term;
        };
        std::vector<Term> terms;
        // Cavities are not counted: in rows they would cross one another's rays, and nothing else.
        side_.count_crossings(rays, is_shown, [&](std::uint32_t part, std::uint32_t ray, int term) {
            if (solid_of_[part] == solid_of_[sought[ray].cavity]) terms.push_back({ray, pieces.find(part), term});
        });
        std::sort(terms.begin(), terms.end(),
                  [](const Term& a, const Term& b) { return std::tie(a.ray, a.piece) < std::tie(b.ray, b.piece); });
        std::vector<bool> is_found(sought.size(), false);
        for (std::size_t first = 0, last; first < terms.size(); first = last) {
            const std::uint32_t ray = terms[first].ray, piece = terms[first].piece;
            int winding = 0;
            for (last = first; last < terms.size() && terms[last].ray == ray && terms[last].piece == piece; ++last)
                winding += terms[last].term;
            if (winding == 0) continue;
            homes.push_back({sought[ray].cavity, piece});
            is_found[ray] = true;
        }
        for (std::size_t i = 0; i < sought.size(); ++i)
            if (!is_found[i]) homes.push_back(sought[i]);
    }

    const SideParts& side_;
    Side which_;
    std::vector<std::uint32_t> solid_of_;  ///< dense numbers of the solids that occur
    std::vector<SolidParts> solids_;
    std::vector<std::uint32_t> first_piece_;  ///< of each solid, as find_first_pieces() found it
};

/// If edges of a pair of pieces, one on each side, arrive at a point but do not leave it, no loops keep to these
/// pieces, and the pieces at that point become one. They stay apart if the outline itself ends there.
void join_where_loops_need_it(const SectionOutline& outline, const BySide<SideParts>& sides,
                              BySide<SideGrouping>& grouping)
{
    struct End
    {
        std::uint32_t point, solid;
        BySide<std::uint32_t> piece;
        std::int32_t leaves;  // +1 or -1
    };
    // At nearly every point one edge arrives and one leaves, between the same pieces: such points are left out.
    std::vector<End> first_at(outline.points().size(), End{kNone, 0, {}, 0}), ends;
    std::vector<bool> is_plain(outline.points().size(), false);
    const auto visit_ends = [&](auto visit) {
        for (const OutlineEdge& edge : outline.edges()) {
            if (edge.part[Side::negative] == kNoPart || edge.part[Side::positive] == kNoPart) continue;
            BySide<std::uint32_t> piece;
            for (const Side side : kSides) piece[side] = grouping[side].pieces.find(edge.part[side]);
            const std::uint32_t solid = sides[Side::negative].parts[edge.part[Side::negative]].solid;
            visit(End{edge.from, solid, piece, 1});
            visit(End{edge.to, solid, piece, -1});
        }
    };
    visit_ends([&](const End& end) {
        End& first = first_at[end.point];
        if (first.point == kNone) {
            first = end;
        } else {
            // The second end; any further one makes the point one to look at.
            is_plain[end.point] = first.leaves + end.leaves == 0 && first.piece == end.piece;
            first.leaves = 2;
        }
    });
    visit_ends([&](const End& end) {
        if (!is_plain[end.point]) ends.push_back(end);
    });
    std::sort(ends.begin(), ends.end(), [](const End& a, const End& b) {
        return std::tie(a.point, a.solid, a.piece) < std::tie(b.point, b.solid, b.piece);
    });
    for (std::size_t first = 0, last; first < ends.size(); first = last) {
        std::int32_t sum = 0;
        for (last = first;
             last < ends.size() && ends[last].point == ends[first].point && ends[last].solid == ends[first].solid;
             ++last)
            sum += ends[last].leaves;
        if (sum != 0) continue;
        const End* odd = nullptr;
        for (std::size_t begin = first, end; begin < last; begin = end) {
            for (end = begin; end < last && ends[end].piece == ends[begin].piece; ++end) sum += ends[end].leaves;
            if (std::exchange(sum, 0) == 0) continue;
            if (odd == nullptr) odd = &ends[begin];
            for (const Side side : kSides) grouping[side].pieces.unite(odd->piece[side], ends[begin].piece[side]);
        }
    }
}

}  // namespace

void ShellSample::add(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c)
{
    std::array<glm::vec3, 3> corners{a, b, c};
    const auto is_less = [](const glm::vec3& p, const glm::vec3& q) {
        return !same_position(p, q) && lexicographically_less(p, q);
    };
    std::sort(corners.begin(), corners.end(), is_less);
    if (std::lexicographical_compare(corners.begin(), corners.end(), first_.begin(), first_.end(), is_less))
        first_ = corners;
}

glm::vec3 ShellSample::point() const
{
    return glm::vec3((glm::dvec3(first_[0]) + glm::dvec3(first_[1]) + glm::dvec3(first_[2])) / 3.0);
}

BySide<std::vector<std::uint32_t>> group_pieces(const Plane& plane, const BySide<SideParts>& sides,
                                                std::span<const glm::vec3> points, std::span<const OutlineEdge> edges)
{
    const int axis = dominant_axis(plane.normal);
    if (plane.normal[axis] < 0.0) {
        // Loops that touch can be linked in several ways: a flipped plane must link them as the plane does.
        std::vector<OutlineEdge> reversed;
        reversed.reserve(edges.size());
        for (const OutlineEdge& edge : edges)
            reversed.push_back(
                {edge.to, edge.from, {edge.part[Side::positive], edge.part[Side::negative]}, edge.source});
        auto piece = group_pieces(plane.flipped(), {sides[Side::positive], sides[Side::negative]}, points, reversed);
        std::swap(piece[Side::negative], piece[Side::positive]);
        return piece;
    }
    BySide<SideGrouping> grouping{SideGrouping(sides[Side::negative], Side::negative),
                                  SideGrouping(sides[Side::positive], Side::positive)};
    const BySide<bool> apart{grouping[Side::negative].has_come_apart(), grouping[Side::positive].has_come_apart()};
    std::optional<SectionOutline> outline_of_parts;
    if (apart[Side::negative] || apart[Side::positive]) {
        const SectionOutline& outline = outline_of_parts.emplace(plane, points, edges);
        for (const Side side : kSides)
            if (apart[side]) grouping[side].join_holes_of_solids(outline, axis);
        join_where_loops_need_it(outline, sides, grouping);
        for (const Side side : kSides)
            if (apart[side]) grouping[side].join_flat_pieces(outline);
    }
    for (const Side side : kSides)
        grouping[side].join_the_rest({{}, axis, side == Side::positive},
                                     outline_of_parts ? &*outline_of_parts : nullptr);
    return {grouping[Side::negative].result(), grouping[Side::positive].result()};
}

}  // namespace kerf::core
