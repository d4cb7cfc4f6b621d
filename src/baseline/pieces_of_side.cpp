#include "baseline/pieces_of_side.h"

#include <algorithm>

#include "baseline/pair_table.h"
#include "common/half_edge_pairs.h"
#include "common/mass_properties.h"

namespace kerf::baseline {

namespace {

/// Numbers the triangles that hang together by edges.
std::vector<std::uint32_t> flood(std::span<const std::uint32_t> twins, std::uint32_t& count)
{
    std::vector<std::uint32_t> part(twins.size() / 3, kNone), stack;
    count = 0;
    for (std::uint32_t seed = 0; seed < part.size(); ++seed) {
        if (part[seed] != kNone) continue;
        part[seed] = count;
        stack.push_back(seed);
        while (!stack.empty()) {
            const std::uint32_t t = stack.back();
            stack.pop_back();
            for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h) {
                if (twins[h] == kNoTwin || part[twins[h] / 3] != kNone) continue;
                part[twins[h] / 3] = count;
                stack.push_back(twins[h] / 3);
            }
        }
        ++count;
    }
    return part;
}

/// Signed crossings of a ray with each part that somebody asks for; one loop over all triangles a ray.
class RayCounter
{
public:
    RayCounter(const IndexedMesh& mesh, std::span<const std::uint32_t> part_of_triangle)
        : mesh_(mesh), part_of_triangle_(part_of_triangle)
    {
    }

    int operator()(std::uint32_t part, const AxisRay& ray)
    {
        int count = 0;
        for (std::size_t t = 0; t < part_of_triangle_.size(); ++t) {
            if (part_of_triangle_[t] != part) continue;
            const auto& [a, b, c] = mesh_.triangles[t];
            count +=
                ray_crossing(ray, mesh_.vertices[a].position, mesh_.vertices[b].position, mesh_.vertices[c].position);
        }
        return count;
    }

private:
    const IndexedMesh& mesh_;
    std::span<const std::uint32_t> part_of_triangle_;
};

}  // namespace

PartsOfSide find_parts(SideBuilder& builder, Crossings& crossings, const Section& section)
{
    const IndexedMesh& mesh = builder.mesh;
    const Buffer<std::uint32_t> twins = half_edge_twins(mesh);
    PartsOfSide side;
    std::uint32_t count = 0;
    side.part_of_triangle = flood(twins, count);
    side.parts.resize(count);

    // Whole shells need a sample and a volume; for those that turn out to be cut they do no harm.
    std::vector<MassMoments> moments(count);
    const glm::dvec3 reference = mesh.vertices.empty() ? glm::dvec3(0) : glm::dvec3(mesh.vertices[0].position);
    for (const TriangleGroup& group : mesh.groups)
        for (std::uint32_t t = group.first; t < group.first + group.count; ++t) {
            const auto& [a, b, c] = mesh.triangles[t];
            const std::uint32_t part = side.part_of_triangle[t];
            side.parts[part].solid = group.solid;
            side.parts[part].sample = mesh.vertices[a].position;
            moments[part].add(reference, mesh.vertices[a].position, mesh.vertices[b].position,
                              mesh.vertices[c].position);
        }
    for (std::uint32_t i = 0; i < count; ++i) side.parts[i].volume6 = moments[i].volume6;

    // The triangle at each section edge: the one whose boundary half-edge runs between the same points.
    const auto point_of = [&](std::uint32_t i) {
        const SectionPoint& point = section.points[i];
        return point.existing != kNone ? builder.point_of_existing(point.existing)
                                       : builder.point_of_cut(crossings, point.cut_point);
    };
    PairTable triangle_at;
    triangle_at.reset(section.edges.size());
    for (std::uint32_t h = 0; h < twins.size(); ++h) {
        if (twins[h] != kNoTwin) continue;
        const std::uint32_t from = mesh.points[mesh.triangles[h / 3][h % 3]];
        const std::uint32_t to = mesh.points[mesh.triangles[h / 3][(h % 3 + 1) % 3]];
        triangle_at(from, to) = h / 3;
    }
    side.part_of_edge.resize(section.edges.size());
    for (std::size_t i = 0; i < section.edges.size(); ++i) {
        std::uint32_t from = point_of(section.edges[i].from), to = point_of(section.edges[i].to);
        if (builder.side() == Side::negative) std::swap(from, to);
        const std::uint32_t triangle = triangle_at.find(from, to);
        // An edge without a triangle on this side occurs on open meshes only, where a piece vanished at the boundary.
        const std::uint32_t part = triangle == kNone ? 0 : side.part_of_triangle[triangle];
        side.part_of_edge[i] = part;
        if (part < side.parts.size()) side.parts[part].is_cut = true;
    }
    return side;
}

PiecesOfSide find_pieces(const SideBuilder& builder, const Section& section, const PartsOfSide& parts,
                         std::span<const SectionPath> paths, const Plane& plane)
{
    const IndexedMesh& mesh = builder.mesh;
    std::vector<std::vector<glm::vec3>> points;
    std::vector<PartLoop> loops;
    points.reserve(paths.size());
    for (const SectionPath& path : paths) {
        if (!path.closed) continue;
        points.push_back(to_loop(section, path).points);
        loops.push_back({path.tag, points.back()});
    }
    const std::vector<std::uint32_t> piece_of_part =
        group_pieces(plane, builder.side(), parts.parts, loops, RayCounter(mesh, parts.part_of_triangle));

    // A cap triangle belongs to the part at its rim: with the cap in place, flooding goes through the rim's edges.
    PiecesOfSide pieces;
    std::vector<std::uint32_t>& piece = pieces.of_triangle;
    piece.resize(mesh.triangles.size(), kNone);
    for (std::size_t t = 0; t < parts.part_of_triangle.size(); ++t) piece[t] = piece_of_part[parts.part_of_triangle[t]];
    if (piece.size() > parts.part_of_triangle.size()) {
        const Buffer<std::uint32_t> twins = half_edge_twins(mesh);
        for (std::size_t t = parts.part_of_triangle.size(); t < piece.size(); ++t) {
            const std::uint32_t rim = static_cast<std::uint32_t>(3 * t + 1);  // corner 0 is the fan's apex
            if (twins[rim] != kNoTwin) piece[t] = piece[twins[rim] / 3];
        }
    }
    // Left over: a cap whose surface vanished (open meshes). It stays with the first piece rather than being lost.
    std::replace(piece.begin(), piece.end(), kNone, 0u);
    for (const SectionPath& path : paths) pieces.of_path.push_back(piece_of_part.empty() ? 0 : piece_of_part[path.tag]);
    return pieces;
}

std::vector<Fragment> extract_pieces(const Fragment& whole, std::span<const std::uint32_t> piece_of_triangle)
{
    const IndexedMesh& mesh = whole.mesh;
    const std::uint32_t count =
        piece_of_triangle.empty() ? 0 : *std::max_element(piece_of_triangle.begin(), piece_of_triangle.end()) + 1;

    // Triangles sorted by piece, so that the tables below serve one piece after the other.
    std::vector<std::uint32_t> row(count + 1, 0), triangles(piece_of_triangle.size()),
        group_of(piece_of_triangle.size());
    for (const std::uint32_t piece : piece_of_triangle) ++row[piece + 1];
    for (std::uint32_t i = 0; i < count; ++i) row[i + 1] += row[i];
    std::vector<std::uint32_t> fill(row.begin(), row.end() - 1);
    for (std::uint32_t g = 0; g < mesh.groups.size(); ++g)
        for (std::uint32_t t = mesh.groups[g].first; t < mesh.groups[g].first + mesh.groups[g].count; ++t) {
            triangles[fill[piece_of_triangle[t]]++] = t;
            group_of[t] = g;
        }

    std::vector<bool> is_centre(mesh.vertices.size(), false);
    for (const std::uint32_t v : whole.fan_centres) is_centre[v] = true;

    std::vector<Fragment> pieces(count);
    std::vector<std::uint32_t> new_vertex(mesh.vertices.size(), kNone), new_point(mesh.point_count, kNone), used;
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::span<const std::uint32_t> own(triangles.data() + row[i], triangles.data() + row[i + 1]);
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
            const TriangleGroup& like = mesh.groups[group_of[t]];
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

}  // namespace kerf::baseline
