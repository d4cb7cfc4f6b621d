#include "linear/partial_cut.h"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <utility>

#include "common/cutting/cut_geometry.h"
#include "common/cutting/joined_pieces.h"
#include "common/sections/chosen_paths.h"
#include "linear/outline.h"
#include "linear/slicing_steps.h"

namespace kerf::core::linear {

namespace {

using Place = JoinedPieces::Place;

/// An edge by its points, the smaller one first.
using Edge = std::pair<std::uint32_t, std::uint32_t>;

/// Where a cut along some of an outline leaves what. The sources of the mesh's triangles are their own numbers.
struct GivenSides
{
    std::vector<bool> is_cut;            ///< of each triangle: it is divided as the plane does
    std::vector<Side> side_of_triangle;  ///< of each that is not cut
    /// What of each triangle is on a side: the number of its piece.
    BySide<std::vector<std::uint32_t>> piece_of_triangle;
};

/// A place as a key.
using Position = std::array<float, 3>;

/// From the pieces of a whole cut, without caps, to the sides of a cut along the chosen paths.
class PartialCut
{
public:
    /// @param pieces  of the whole cut, whose sources are numbers of the triangles of `whole`
    PartialCut(const Fragment& whole, const Plane& plane, const PlaneSection& section,
               const std::vector<bool>& is_chosen, const Slices& pieces)
        : mesh_(whole.mesh),
          plane_(plane),
          joined_(
              {static_cast<std::uint32_t>(pieces.negative.size()), static_cast<std::uint32_t>(pieces.positive.size())})
    {
        for (const Side side : kSides) {
            std::vector<std::uint32_t>& piece = piece_[side];
            piece.assign(mesh_.triangles.size(), kNone);
            const std::vector<Fragment>& all = side == Side::negative ? pieces.negative : pieces.positive;
            for (std::uint32_t p = 0; p < all.size(); ++p)
                for (const std::uint32_t source : all[p].mesh.sources) piece[source] = p;
        }
        sort_triangles();
        for (std::size_t i = 0; i < section.paths.size(); ++i) {
            if (!is_chosen[i]) continue;
            const auto edges = section.edges_of(section.paths[i]);
            section.for_each_edge(section.paths[i], [&](std::size_t e, const glm::vec3& p, const glm::vec3& q) {
                if (kind_[edges[e].source] != Kind::apart)
                    kind_[edges[e].source] = Kind::cut;
                else
                    chosen_edges_.insert(key(p, q));
            });
        }
    }

    /// False if the chosen paths part nothing.
    bool find()
    {
        for (std::uint32_t i = 0; i < mesh_.triangles.size(); ++i)
            if (is_divided(i) && kind_[i] == Kind::cut)
                joined_.part({piece_[Side::negative][i], piece_[Side::positive][i]});
        join_around_triangles();
        join_along_plane();
        return joined_.find();
    }

    GivenSides sides()
    {
        GivenSides given;
        given.side_of_triangle.resize(mesh_.triangles.size());
        for (const Side side : kSides) {
            given.piece_of_triangle[side].assign(mesh_.triangles.size(), kNone);
            is_needed_[side].assign(mesh_.point_count, false);
        }
        for (std::uint32_t i = 0; i < mesh_.triangles.size(); ++i) {
            place(i, given);
            if (kind_[i] != Kind::touching) need_corners(i);
        }
        const BySide<std::vector<bool>> is_needed = is_needed_;
        for (std::uint32_t i = 0; i < mesh_.triangles.size(); ++i) {
            if (kind_[i] != Kind::touching) continue;
            if (loses_a_corner(i, is_needed)) kind_[i] = Kind::cut;
            need_corners(i);
        }
        for (const Kind kind : kind_) given.is_cut.push_back(kind == Kind::cut);
        return given;
    }

private:
    static std::pair<Position, Position> key(const glm::vec3& p, const glm::vec3& q)
    {
        const Position a{p.x, p.y, p.z}, b{q.x, q.y, q.z};
        return std::minmax(a, b);
    }

    /// Whether the whole cut leaves something of a triangle on both sides.
    bool is_divided(std::uint32_t i) const
    {
        return piece_[Side::negative][i] != kNone && piece_[Side::positive][i] != kNone;
    }

    /// What a triangle is to the cut.
    enum class Kind : std::uint8_t
    {
        apart,     ///< it has no corners strictly on both sides
        crossed,   ///< a path runs through it that is not cut
        touching,  ///< it crosses without an edge of the section: cut points coincide, and one side keeps all or nothing
        cut,       ///< a path runs through it that is cut
    };

    void sort_triangles()
    {
        for (const Triangle& t : mesh_.triangles) {
            const std::array<glm::vec3, 3> p{mesh_.vertices[t[0]].position, mesh_.vertices[t[1]].position,
                                             mesh_.vertices[t[2]].position};
            const std::array<double, 3> d{distance(t[0]), distance(t[1]), distance(t[2])};
            const bool is_crossing = classify(d[0], d[1], d[2]) == TriangleClass::crossing;
            kind_.push_back(!is_crossing                              ? Kind::apart
                            : split_triangle(p, d).has_section_edge() ? Kind::crossed
                                                                      : Kind::touching);
        }
    }

    double distance(std::uint32_t vertex) const { return plane_.signed_distance(mesh_.vertices[vertex].position); }

    /// Calls visit(a, b) for the edges of a triangle that lie in the plane, by vertices.
    template <class Visit>
    void for_each_edge_in_plane(const Triangle& t, Visit visit) const
    {
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const std::uint32_t a = t[corner], b = t[(corner + 1) % 3];
            if (distance(a) == 0.0 && distance(b) == 0.0) visit(a, b);
        }
    }

    bool is_chosen_edge(std::uint32_t a, std::uint32_t b) const
    {
        return chosen_edges_.contains(key(mesh_.vertices[a].position, mesh_.vertices[b].position));
    }

    /// What a crossing triangle that is not cut is connected with: its own pieces, and those of its neighbours.
    void join_around_triangles()
    {
        std::vector<std::uint32_t> whole;
        std::vector<bool> is_near(mesh_.point_count, false);
        for (std::uint32_t i = 0; i < mesh_.triangles.size(); ++i) {
            if (kind_[i] != Kind::crossed) continue;
            whole.push_back(i);
            for (const std::uint32_t v : mesh_.triangles[i]) is_near[mesh_.points[v]] = true;
        }
        if (whole.empty()) return;
        // The first piece at each edge of these triangles stands for all that are connected there.
        std::map<Edge, JoinedPieces::Piece> at;
        const auto join_at = [&](const Edge& edge, const JoinedPieces::Piece& piece) {
            const auto [entry, is_new] = at.try_emplace(edge, piece);
            if (!is_new) joined_.join(entry->second, piece);
        };
        std::set<Edge> edges;
        for (const std::uint32_t i : whole) for_each_edge(i, [&](const Edge& edge) { edges.insert(edge); });
        for (std::uint32_t i = 0; i < mesh_.triangles.size(); ++i) {
            if (kind_[i] == Kind::cut || kind_[i] == Kind::touching) continue;
            if (std::ranges::none_of(mesh_.triangles[i], [&](std::uint32_t v) { return is_near[mesh_.points[v]]; }))
                continue;
            for_each_edge(i, [&](const Edge& edge) {
                if (!edges.contains(edge)) return;
                for (const Side side : kSides)
                    if (piece_[side][i] != kNone) join_at(edge, {side, piece_[side][i]});
            });
        }
        // A triangle of which nothing is left connects its edges all the same.
        for (const std::uint32_t i : whole) {
            std::optional<JoinedPieces::Piece> first;
            for_each_edge(i, [&](const Edge& edge) {
                const auto entry = at.find(edge);
                if (entry == at.end()) return;
                if (first)
                    joined_.join(*first, entry->second);
                else
                    first = entry->second;
            });
        }
    }

    /// Calls visit({p, q}) for a triangle's edges, by points.
    template <class Visit>
    void for_each_edge(std::uint32_t i, Visit visit) const
    {
        const Triangle& t = mesh_.triangles[i];
        for (std::size_t corner = 0; corner < 3; ++corner)
            visit(Edge(std::minmax({mesh_.points[t[corner]], mesh_.points[t[(corner + 1) % 3]]})));
    }

    /// Triangles on both sides of an edge in the plane.
    void join_along_plane()
    {
        std::map<std::pair<std::uint32_t, std::uint32_t>, BySide<std::uint32_t>> pieces_at;
        for (std::uint32_t i = 0; i < mesh_.triangles.size(); ++i)
            for_each_edge_in_plane(mesh_.triangles[i], [&](std::uint32_t a, std::uint32_t b) {
                const auto points = std::minmax(mesh_.points[a], mesh_.points[b]);
                const auto [entry, is_new] =
                    pieces_at.try_emplace({points.first, points.second}, BySide<std::uint32_t>{kNone, kNone});
                for (const Side side : kSides)
                    if (piece_[side][i] != kNone) entry->second[side] = piece_[side][i];
                const BySide<std::uint32_t>& pieces = entry->second;
                if (pieces[Side::negative] == kNone || pieces[Side::positive] == kNone) return;
                is_chosen_edge(a, b) ? joined_.part(pieces) : joined_.join(pieces);
            });
    }

    /// Where what is left of a triangle comes to.
    void place(std::uint32_t i, GivenSides& given) const
    {
        for (const Side side : kSides) {
            if (piece_[side][i] == kNone) continue;
            const Place place = joined_.place_of(side, piece_[side][i]);
            given.side_of_triangle[i] = place.side;
            given.piece_of_triangle[place.side][i] = place.number;
        }
    }

    void need_corners(std::uint32_t i)
    {
        const Triangle& t = mesh_.triangles[i];
        if (kind_[i] != Kind::cut) {
            for (const Side side : kSides)
                if (piece_[side][i] != kNone)
                    for (const std::uint32_t v : t)
                        is_needed_[joined_.place_of(side, piece_[side][i]).side][mesh_.points[v]] = true;
            return;
        }
        // Corners on the plane may be needed by what is left on either side.
        for (const std::uint32_t v : t) {
            if (distance(v) >= 0.0) is_needed_[Side::positive][mesh_.points[v]] = true;
            if (distance(v) <= 0.0) is_needed_[Side::negative][mesh_.points[v]] = true;
        }
    }

    /// Whether a triangle that only touches the plane has a corner beyond it that goes elsewhere.
    bool loses_a_corner(std::uint32_t i, const BySide<std::vector<bool>>& is_needed) const
    {
        for (const Side side : kSides) {
            if (piece_[side][i] == kNone) continue;
            const Side own = joined_.place_of(side, piece_[side][i]).side;
            return std::ranges::any_of(mesh_.triangles[i], [&](std::uint32_t v) {
                return distance(v) != 0.0 && side_of(distance(v)) != side && is_needed[opposite(own)][mesh_.points[v]];
            });
        }
        return true;
    }

    const IndexedMesh& mesh_;
    const Plane& plane_;
    JoinedPieces joined_;
    BySide<std::vector<std::uint32_t>> piece_;              ///< of each triangle on each side, or kNone
    std::vector<Kind> kind_;                                ///< of each triangle
    BySide<std::vector<bool>> is_needed_;                   ///< of each point, by what is left on a side
    std::set<std::pair<Position, Position>> chosen_edges_;  ///< that lie in the plane
};

/// Finds vertices by where they come from.
class OriginLookup
{
public:
    explicit OriginLookup(SideBuilder& builder) : builder_(builder), of_vertex_(builder.source().vertices.size(), kNone)
    {
        of_cut_.reset(0);
    }

    std::uint32_t existing(std::uint32_t vertex)
    {
        std::uint32_t& index = of_vertex_[vertex];
        if (index == kNone) index = builder_.append_existing(vertex);
        return index;
    }

    std::uint32_t cut(Crossings& crossings, const CrossingTriangle& crossing, std::uint8_t code)
    {
        const auto [a, b] = cut_edge_vertices(builder_.source(), crossing, code);
        std::uint32_t& index = of_cut_(std::min(a, b), std::max(a, b));
        if (index == kNone) index = builder_.append_cut(crossings, crossing, code);
        return index;
    }

private:
    SideBuilder& builder_;
    std::vector<std::uint32_t> of_vertex_;
    PairTable of_cut_;  ///< by the vertices of the edge
};

/// Puts every triangle where it is told.
class GivenSlicer : public Slicer<GivenSlicer>
{
public:
    GivenSlicer(const Fragment& whole, const Plane& plane, const CutOptions& options, Closing& closing,
                const GivenSides& given)
        : Slicer(whole, plane, options, closing), given_(given)
    {
    }

    void classify_vertices()
    {
        // Nobody asks for more than that both sides get something.
        classes_.far_below = classes_.far_above = 1;
    }

    void distribute(std::uint32_t g)
    {
        const TriangleGroup& group = mesh_.groups[g];
        const auto is_on = [&](std::uint32_t v) { return plane_.signed_distance(mesh_.vertices[v].position) == 0.0; };
        for (std::uint32_t i = group.first; i < group.first + group.count; ++i) {
            if (given_.is_cut[i]) {
                crossings_.triangles.push_back({i, g, 0, 0, {}});
                continue;
            }
            const Side side = given_.side_of_triangle[i];
            const Triangle& t = mesh_.triangles[i];
            for (std::uint8_t corner = 0; corner < 3; ++corner)
                if (is_on(t[corner]) && is_on(t[(corner + 1u) % 3])) edges_in_plane_[side].push_back({i, g, corner});
            add_untouched(i, side);
        }
    }

    void expect_cut_points(std::size_t) {}

    OriginLookup& lookup(Side side) { return lookups_[side]; }

    BySide<std::vector<std::uint32_t>> pieces_of(const BySide<FoundParts>& parts)
    {
        BySide<std::vector<std::uint32_t>> piece_of_part;
        for (const Side side : kSides) {
            piece_of_part[side].resize(parts[side].parts.size());
            const std::vector<std::uint32_t>& part = parts[side].part_of_triangle;
            for (std::size_t i = 0; i < part.size(); ++i)
                piece_of_part[side][part[i]] = given_.piece_of_triangle[side][builders_[side].mesh.sources[i]];
        }
        return piece_of_part;
    }

private:
    const GivenSides& given_;
    BySide<OriginLookup> lookups_{OriginLookup(builders_[Side::negative]), OriginLookup(builders_[Side::positive])};
};

}  // namespace

Slices cut_only(const Fragment& whole, const Plane& plane, const CutOptions& options, Closing& closing,
                const RunSlicer& run)
{
    CutOptions all = options;
    all.only.reset();
    PlaneSection section;
    Fragment numbered = whole;
    std::iota(numbered.mesh.sources.begin(), numbered.mesh.sources.end(), 0u);
    find_outline(numbered, plane, section);
    if (section.paths.empty()) return run(whole, all);
    const std::vector<bool> is_chosen = choose_paths(plane, *options.only, section);

    CutOptions to_pieces = all;
    to_pieces.split_components = true;
    to_pieces.build_caps = false;
    const Slices pieces = run(numbered, to_pieces);
    PartialCut partial(numbered, plane, section, is_chosen, pieces);
    if (!partial.find()) {
        Slices refused;
        refused.status = Status::not_separated;
        refused.statistics.triangles = refused.statistics.triangles_touched = whole.mesh.triangles.size();
        return refused;
    }
    const GivenSides given = partial.sides();
    Slices slices = GivenSlicer(numbered, plane, all, closing, given).run();
    for (auto* fragments : {&slices.negative, &slices.positive})
        for (Fragment& fragment : *fragments)
            for (std::uint32_t& source : fragment.mesh.sources)
                if (source != kNoSource) source = whole.mesh.sources[source];
    return slices;
}

}  // namespace kerf::core::linear
