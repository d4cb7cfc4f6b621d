#include "linear/parts_and_pieces.h"

#include <algorithm>

#include "common/geometry/disjoint_sets.h"
#include "common/geometry/pair_table.h"
#include "common/geometry/parallel_rays.h"
#include "common/mesh/mass_moments.h"
#include "common/mesh/mass_properties.h"
#include "common/repair/halfedges_by_edge.h"

namespace kerf::core::linear {

namespace {

/// Counts crossings of rays with the parts of a side, in one loop over all triangles.
class RayCounter
{
public:
    RayCounter(const IndexedMesh& mesh, std::span<const std::uint32_t> part_of_triangle)
        : mesh_(mesh), part_of_triangle_(part_of_triangle)
    {
    }

    void operator()(std::span<const AxisRay> rays, const std::vector<bool>& is_wanted, const AddCrossing& add) const
    {
        const ParallelRays bundle(rays);
        for (std::size_t t = 0; t < part_of_triangle_.size(); ++t) {
            if (!is_wanted[part_of_triangle_[t]]) continue;
            const auto& [a, b, c] = mesh_.triangles[t];
            bundle.for_each_crossing(mesh_.vertices[a].position, mesh_.vertices[b].position, mesh_.vertices[c].position,
                                     [&](std::uint32_t ray, int term) { add(part_of_triangle_[t], ray, term); });
        }
    }

private:
    const IndexedMesh& mesh_;
    std::span<const std::uint32_t> part_of_triangle_;
};

/// Fills in the data that decide a part's piece: its solid, a sample, its volume, whether it is flat.
void measure_parts(FoundParts& side, const SideBuilder& builder, const Plane& plane, double noise)
{
    const IndexedMesh& mesh = builder.mesh;
    const std::size_t count = side.parts.size();
    // Data of whole shells and data of cut parts: computing both for all does no harm.
    std::vector<Box> boxes(count);
    std::vector<ShellSample> samples(count);
    std::vector<bool> is_far(count, false);
    const auto for_each_triangle = [&](auto visit) {
        for (const TriangleGroup& group : mesh.groups)
            for (std::uint32_t t = group.first; t < group.first + group.count; ++t)
                visit(side.part_of_triangle[t], group,
                      std::array<glm::vec3, 3>{mesh.vertices[mesh.triangles[t][0]].position,
                                               mesh.vertices[mesh.triangles[t][1]].position,
                                               mesh.vertices[mesh.triangles[t][2]].position});
    };
    for_each_triangle([&](std::uint32_t i, const TriangleGroup& group, const std::array<glm::vec3, 3>& p) {
        SurfacePart& part = side.parts[i];
        part.solid = group.solid;
        if (!part.is_cut) samples[i].add(p[0], p[1], p[2]);
        for (const glm::vec3& corner : p) {
            boxes[i].add(corner);
            const double distance = plane.signed_distance(corner);
            is_far[i] = is_far[i] || (builder.side() == Side::positive ? distance > noise : distance < -noise);
        }
    });
    // About the sample: an open shell has another volume about another point.
    std::vector<MassMoments> moments(count);
    for (std::uint32_t i = 0; i < count; ++i)
        if (!side.parts[i].is_cut) side.parts[i].sample = samples[i].point();
    if (std::any_of(side.parts.begin(), side.parts.end(), [](const SurfacePart& part) { return !part.is_cut; }))
        for_each_triangle([&](std::uint32_t i, const TriangleGroup&, const std::array<glm::vec3, 3>& p) {
            if (!side.parts[i].is_cut) moments[i].add(side.parts[i].sample, p[0], p[1], p[2]);
        });
    for (std::uint32_t i = 0; i < count; ++i) {
        SurfacePart& part = side.parts[i];
        part.volume6 = moments[i].volume6;
        part.is_flat = part.is_cut ? !is_far[i] : has_no_volume(part.volume6, boxes[i], noise);
    }
}

/// Numbers the sets in the order of their first triangles. Returns how many there are.
std::uint32_t number_parts(DisjointSets& joined, std::vector<std::uint32_t>& part_of_triangle)
{
    std::uint32_t count = 0;
    part_of_triangle.resize(joined.size());
    for (std::uint32_t t = 0; t < joined.size(); ++t) {
        // The representative is the smallest, so it has its number already.
        const std::uint32_t first = joined.find(t);
        part_of_triangle[t] = first == t ? count++ : part_of_triangle[first];
    }
    return count;
}

/// Triangles sorted by piece, so that one table serves one piece after the other.
struct TrianglesByPiece
{
    std::vector<std::uint32_t> row;        ///< of each piece: where its triangles begin; and the end
    std::vector<std::uint32_t> triangles;  ///< piece by piece, in the order of the groups
    std::vector<std::uint32_t> group_of;   ///< of each triangle

    TrianglesByPiece(const IndexedMesh& mesh, std::span<const std::uint32_t> piece_of_triangle, std::uint32_t count)
        : row(count + 1, 0), triangles(piece_of_triangle.size()), group_of(piece_of_triangle.size())
    {
        for (const std::uint32_t piece : piece_of_triangle) ++row[piece + 1];
        for (std::uint32_t i = 0; i < count; ++i) row[i + 1] += row[i];
        std::vector<std::uint32_t> fill(row.begin(), row.end() - 1);
        for (std::uint32_t g = 0; g < mesh.groups.size(); ++g)
            for (std::uint32_t t = mesh.groups[g].first; t < mesh.groups[g].first + mesh.groups[g].count; ++t) {
                triangles[fill[piece_of_triangle[t]]++] = t;
                group_of[t] = g;
            }
    }

    std::span<const std::uint32_t> of_piece(std::uint32_t i) const
    {
        return {triangles.data() + row[i], triangles.data() + row[i + 1]};
    }
};

}  // namespace

FoundParts find_parts(SideBuilder& builder, Crossings& crossings, const Section& section, const Plane& plane,
                      double noise)
{
    const IndexedMesh& mesh = builder.mesh;
    const auto triangle_count = static_cast<std::uint32_t>(mesh.triangles.size());
    Buffer<Triangle> corners(triangle_count);
    for (std::size_t t = 0; t < triangle_count; ++t)
        for (std::size_t i = 0; i < 3; ++i) corners[t][i] = mesh.points[mesh.triangles[t][i]];

    // All triangles at an edge are connected. If more run one way than the other, the edge bounds the side.
    HalfedgesByEdge runs(mesh.point_count, corners);
    DisjointSets joined(triangle_count);
    PairTable triangle_at;  // by the points of edges, the smaller one first
    triangle_at.reset(section.edges.size());
    const auto note = [&](std::span<const HalfedgesByEdge::Entry> edge) {
        const std::uint32_t first = edge.front().halfedge / 3, corner = edge.front().halfedge % 3;
        const auto [smaller, larger] = std::minmax(corners[first][corner], corners[first][(corner + 1) % 3]);
        triangle_at(smaller, larger) = first;
    };
    runs.for_each([&](std::span<const HalfedgesByEdge::Entry> edge) {
        const std::uint32_t first = edge.front().halfedge / 3;
        std::int32_t surplus = 0;
        for (const HalfedgesByEdge::Entry& side : edge) {
            joined.unite(first, side.halfedge / 3);
            surplus += corners[side.halfedge / 3][side.halfedge % 3] < side.larger_point ? 1 : -1;
        }
        if (surplus != 0) note(edge);
    });

    FoundParts side;
    const std::uint32_t count = number_parts(joined, side.part_of_triangle);
    side.parts.resize(count);
    const auto point_of = [&](std::uint32_t i) {
        const SectionPoint& point = section.points[i];
        return point.existing != kNone ? builder.point_of_existing(point.existing)
                                       : builder.point_of_cut(crossings, point.cut_point);
    };
    const auto triangle_of = [&](const SectionEdge& edge) {
        const std::uint32_t a = point_of(edge.from), b = point_of(edge.to);
        return triangle_at.find(std::min(a, b), std::max(a, b));
    };
    // On open meshes a triangle may lie on the back of another, so that the section edge between them bounds neither;
    // then all edges between its points are looked at.
    if (std::any_of(section.edges.begin(), section.edges.end(),
                    [&](const SectionEdge& edge) { return triangle_of(edge) == kNone; })) {
        std::vector<bool> is_on_section(mesh.point_count, false);
        for (std::uint32_t i = 0; i < section.points.size(); ++i)
            if (const std::uint32_t point = point_of(i); point < is_on_section.size()) is_on_section[point] = true;
        runs.for_each([&](std::span<const HalfedgesByEdge::Entry> edge) {
            const Triangle& t = corners[edge.front().halfedge / 3];
            const std::uint32_t corner = edge.front().halfedge % 3;
            if (is_on_section[t[corner]] && is_on_section[t[(corner + 1) % 3]]) note(edge);
        });
    }
    side.part_of_edge.resize(section.edges.size());
    for (std::size_t i = 0; i < section.edges.size(); ++i) {
        const std::uint32_t triangle = triangle_of(section.edges[i]);
        // An edge without a triangle on this side occurs on open meshes only, where a piece vanished at the boundary.
        const std::uint32_t part = triangle == kNone ? kNoPart : side.part_of_triangle[triangle];
        side.part_of_edge[i] = part;
        if (part != kNoPart) side.parts[part].is_cut = true;
    }
    // A connected side needs no grouping. That is the usual case, in which one more loop over all triangles would cost
    // as much as the flood.
    if (count > 1 || !side.parts.front().is_cut) measure_parts(side, builder, plane, noise);
    return side;
}

BySide<std::vector<std::uint32_t>> find_pieces(const BySide<SideBuilder>& builders, const Section& section,
                                               const BySide<FoundParts>& parts, const Plane& plane)
{
    std::vector<OutlineEdge> outline = outline_of(section);
    for (std::size_t i = 0; i < outline.size(); ++i)
        for (const Side side : kSides) outline[i].part[side] = parts[side].part_of_edge[i];
    BySide<SideParts> sides;
    for (const Side side : kSides)
        sides[side] = {parts[side].parts, RayCounter(builders[side].mesh, parts[side].part_of_triangle)};
    return group_pieces(plane, sides, positions_of(section), outline);
}

std::vector<Fragment> extract_pieces(const Fragment& whole, std::span<const std::uint32_t> piece_of_triangle)
{
    const IndexedMesh& mesh = whole.mesh;
    const std::uint32_t count =
        piece_of_triangle.empty() ? 0 : *std::max_element(piece_of_triangle.begin(), piece_of_triangle.end()) + 1;
    const TrianglesByPiece sorted(mesh, piece_of_triangle, count);
    std::vector<bool> is_centre(mesh.vertices.size(), false);
    for (const std::uint32_t v : whole.fan_centres) is_centre[v] = true;

    std::vector<Fragment> pieces(count);
    std::vector<std::uint32_t> new_vertex(mesh.vertices.size(), kNone), new_point(mesh.point_count, kNone), used;
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::span<const std::uint32_t> own = sorted.of_piece(i);
        Fragment& piece = pieces[i];
        piece.noise = whole.noise;
        piece.cap_material = whole.cap_material;
        piece.mesh.materials = mesh.materials;
        for (const VertexStream& stream : mesh.streams) piece.mesh.streams.push_back({stream.name, stream.width, {}});

        used.clear();
        for (const std::uint32_t t : own)
            for (const std::uint32_t v : mesh.triangles[t])
                if (new_vertex[v] == kNone) {
                    new_vertex[v] = 0;
                    used.push_back(v);
                }
        std::sort(used.begin(), used.end());
        for (const std::uint32_t v : used) {
            new_vertex[v] = static_cast<std::uint32_t>(piece.mesh.vertices.size());
            if (is_centre[v]) piece.fan_centres.push_back(new_vertex[v]);
            piece.mesh.vertices.push_back(mesh.vertices[v]);
            piece.bounds.add(mesh.vertices[v].position);
            std::uint32_t& point = new_point[mesh.points[v]];
            if (point == kNone) point = piece.mesh.point_count++;
            piece.mesh.points.push_back(point);
            for (std::size_t s = 0; s < mesh.streams.size(); ++s) {
                const VertexStream& from = mesh.streams[s];
                const float* values = from.values.data() + std::size_t(v) * from.width;
                Buffer<float>& to = piece.mesh.streams[s].values;
                to.insert(to.end(), values, values + from.width);
            }
        }
        for (const std::uint32_t t : own) {
            const auto& [a, b, c] = mesh.triangles[t];
            const TriangleGroup& like = mesh.groups[sorted.group_of[t]];
            auto& groups = piece.mesh.groups;
            if (groups.empty() || groups.back().material != like.material || groups.back().solid != like.solid ||
                groups.back().kind != like.kind)
                groups.push_back(
                    {static_cast<std::uint32_t>(piece.mesh.triangles.size()), 0, like.material, like.solid, like.kind});
            ++groups.back().count;
            piece.mesh.triangles.push_back({new_vertex[a], new_vertex[b], new_vertex[c]});
            piece.mesh.sources.push_back(mesh.sources[t]);
        }
        for (const std::uint32_t v : used) {
            new_point[mesh.points[v]] = kNone;
            new_vertex[v] = kNone;
        }
    }
    return pieces;
}

}  // namespace kerf::core::linear
