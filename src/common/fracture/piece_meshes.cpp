#include "common/fracture/piece_meshes.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <utility>

#include "common/fracture/close_border.h"
#include "common/geometry/dominant_axis.h"
#include "common/mesh/float_range.h"
#include "common/mesh/index.h"
#include "common/mesh/triangle_soup.h"
#include "common/repair/repair.h"

namespace kerf::core {

namespace {

/// What a new vertex of a piece is named by: a point, and the vertices or the contact that it has its attributes from.
using VertexName = std::array<std::uint32_t, 3>;
constexpr std::uint32_t kOfTriangle = 0xFFFFFFFFu, kOfContact = 0xFFFFFFFEu;

/// A new vertex, among others at the same point.
struct NamedVertex
{
    VertexName name;
    std::uint32_t vertex;
    std::uint32_t next;  ///< of the list
};

/// The vertices that a new one lies between, and its shares of them.
struct Mixture
{
    std::array<std::uint32_t, 3> vertices{};
    std::array<double, 3> shares{};
    std::size_t count = 0;
};

glm::vec3 unit_or(const glm::dvec3& v, const glm::vec3& otherwise)
{
    const double length = glm::length(v);
    return length > 0.0 ? glm::vec3(v / length) : otherwise;
}

}  // namespace

class PieceMeshes::Maker
{
public:
    Maker(const IndexedMesh& mesh, std::span<const glm::vec3> points, const SplitSolid& split, const InsideLook& look,
          std::span<const std::vector<double>> stream_means)
        : mesh_(mesh),
          points_(points),
          split_(split),
          look_(look),
          means_(stream_means.begin(), stream_means.end()),
          vertex_of_point_(points.size()),
          local_vertex_(mesh.vertices.size(), kNone),
          local_point_(points.size() + split.new_points.size(), kNone),
          first_named_(local_point_.size(), kNone)
    {
        for (std::uint32_t v = static_cast<std::uint32_t>(mesh.vertices.size()); v-- > 0;)
            vertex_of_point_[mesh.points[v]] = v;
        for (std::size_t s = means_.size(); s < mesh.streams.size(); ++s) {
            const VertexStream& stream = mesh.streams[s];
            std::vector<double>& mean = means_.emplace_back(stream.width, 0.0);
            for (std::size_t i = 0; i < stream.values.size(); ++i) mean[i % stream.width] += stream.values[i];
            for (double& value : mean) value /= double(mesh.vertices.size());
        }
    }

    std::optional<ProvenMesh> make(const Fragment& fragment)
    {
        put_together(fragment);
        if (!has_thin_triangle_) {
            if (Proof proof = prove(std::move(piece_)); proof.error.empty()) return std::move(proof.mesh);
            put_together(fragment);
        }
        return repaired();
    }

    std::optional<PieceBorder> border_of(std::uint32_t cell)
    {
        PieceBorder border;
        border.cell = cell;
        Fragment fragment;
        for (const PartTriangle& part : split_.parts[cell]) {
            if (std::ranges::all_of(part.corners, [&](std::uint32_t p) { return p < points_.size(); })) {
                border.kept.push_back(part.source);
            } else {
                fragment.surface.push_back(part);
                border.divided.push_back(part.source);
            }
        }
        for (const std::uint32_t contact : contacts_of(cell))
            for (const auto& [a, b, c] : split_.contacts[contact].triangles) {
                const bool is_turned = split_.contacts[contact].cells[0] != cell;
                fragment.inside.push_back(
                    {is_turned ? PointTriple{a, c, b} : PointTriple{a, b, c}, contact, is_turned});
            }
        put_together(fragment);
        if (has_thin_triangle_) return std::nullopt;
        border.surface_count = static_cast<std::uint32_t>(fragment.surface.size());
        border.old_vertex.assign(piece_.vertices.size(), kNone);
        for (std::size_t i = 0; i < used_vertices_.size(); ++i) border.old_vertex[old_places_[i]] = used_vertices_[i];
        for (const std::uint32_t point : used_points_)
            border.old_point.push_back(point < points_.size() ? point : kNone);
        border.mesh = std::move(piece_);
        return close_border(border) ? std::optional(std::move(border)) : std::nullopt;
    }

private:
    std::span<const std::uint32_t> contacts_of(std::uint32_t cell)
    {
        if (contacts_of_.empty()) {
            contacts_of_.resize(split_.parts.size());
            for (std::uint32_t c = 0; c < split_.contacts.size(); ++c)
                for (const std::uint32_t of : split_.contacts[c].cells) contacts_of_[of].push_back(c);
        }
        return contacts_of_[cell];
    }

    void put_together(const Fragment& fragment)
    {
        begin(fragment);
        for (const PartTriangle& part : fragment.surface) add(part);
        for (const InsideFacet& facet : fragment.inside) add(facet);
        piece_.point_count = static_cast<std::uint32_t>(used_points_.size());
        for (const std::uint32_t v : used_vertices_) local_vertex_[v] = kNone;
        for (const std::uint32_t p : used_points_) local_point_[p] = first_named_[p] = kNone;
    }

    void begin(const Fragment& fragment)
    {
        piece_ = {};
        piece_.materials = mesh_.materials;
        for (const VertexStream& stream : mesh_.streams) piece_.streams.push_back({stream.name, stream.width, {}});
        const std::size_t triangles = fragment.surface.size() + fragment.inside.size();
        piece_.triangles.reserve(triangles);
        piece_.sources.reserve(triangles);
        used_vertices_.clear();
        old_places_.clear();
        used_points_.clear();
        named_.clear();
        group_ = 0;
        has_thin_triangle_ = false;
    }

    const glm::vec3& position(std::uint32_t point) const
    {
        return point < points_.size() ? points_[point] : split_.new_points[point - points_.size()];
    }

    /// The corner of the triangle that lies at the point.
    std::uint32_t vertex_at(const Triangle& triangle, std::uint32_t point) const
    {
        for (const std::uint32_t v : triangle)
            if (mesh_.points[v] == point) return v;
        return triangle[0];
    }

    std::uint32_t add_vertex(const Vertex& vertex, std::uint32_t point)
    {
        std::uint32_t& local = local_point_[point];
        if (local == kNone) {
            local = static_cast<std::uint32_t>(used_points_.size());
            used_points_.push_back(point);
        }
        piece_.vertices.push_back(vertex);
        piece_.points.push_back(local);
        return static_cast<std::uint32_t>(piece_.vertices.size() - 1);
    }

    std::uint32_t old_vertex(std::uint32_t v)
    {
        std::uint32_t& local = local_vertex_[v];
        if (local == kNone) {
            local = add_vertex(mesh_.vertices[v], mesh_.points[v]);
            used_vertices_.push_back(v);
            old_places_.push_back(local);
            for (std::size_t s = 0; s < mesh_.streams.size(); ++s) {
                const VertexStream& from = mesh_.streams[s];
                const auto first = from.values.begin() + std::ptrdiff_t(std::size_t{v} * from.width);
                piece_.streams[s].values.insert(piece_.streams[s].values.end(), first, first + from.width);
            }
        }
        return local;
    }

    template <class VertexAt>
    Mixture mixture_at(std::uint32_t point, VertexAt vertex_at_point) const
    {
        const SurfacePlace& place = split_.places[point - points_.size()];
        Mixture mixture;
        for (std::size_t i = 0; i < 3; ++i) {
            if (place.corners[i] == SurfacePlace::kNoPoint) continue;
            mixture.vertices[mixture.count] = vertex_at_point(place.corners[i]);
            mixture.shares[mixture.count++] = place.shares[i];
        }
        return mixture;
    }

    void add_streams(const Mixture& mixture)
    {
        for (std::size_t s = 0; s < mesh_.streams.size(); ++s) {
            const VertexStream& from = mesh_.streams[s];
            for (std::uint32_t w = 0; w < from.width; ++w) {
                double value = mixture.count == 0 ? means_[s][w] : 0.0;
                for (std::size_t i = 0; i < mixture.count; ++i)
                    value += mixture.shares[i] * double(from.values[std::size_t{mixture.vertices[i]} * from.width + w]);
                piece_.streams[s].values.push_back(static_cast<float>(value));
            }
        }
    }

    /// The vertex of a name; if it is new, the one that is added next.
    std::pair<std::uint32_t, bool> vertex_named(const VertexName& name)
    {
        for (std::uint32_t i = first_named_[name[0]]; i != kNone; i = named_[i].next)
            if (named_[i].name == name) return {named_[i].vertex, false};
        const auto vertex = static_cast<std::uint32_t>(piece_.vertices.size());
        const std::uint32_t next = std::exchange(first_named_[name[0]], static_cast<std::uint32_t>(named_.size()));
        named_.push_back({name, vertex, next});
        return {vertex, true};
    }

    /// A corner of a part of a triangle.
    std::uint32_t surface_vertex(const Triangle& triangle, std::uint32_t point)
    {
        if (point < points_.size()) return old_vertex(vertex_at(triangle, point));
        const Mixture mixture = mixture_at(point, [&](std::uint32_t p) { return vertex_at(triangle, p); });
        const VertexName name = mixture.count == 2 ? VertexName{point, mixture.vertices[0], mixture.vertices[1]}
                                                   : VertexName{point, kOfTriangle, 0};
        const auto [vertex, is_new] = vertex_named(name);
        if (is_new) {
            glm::dvec3 normal(0.0);
            glm::dvec2 uv(0.0);
            for (std::size_t i = 0; i < mixture.count; ++i) {
                const Vertex& v = mesh_.vertices[mixture.vertices[i]];
                normal += mixture.shares[i] * glm::dvec3(v.normal);
                uv += mixture.shares[i] * glm::dvec2(v.uv);
            }
            add_vertex({position(point), unit_or(normal, mesh_.vertices[mixture.vertices[0]].normal), glm::vec2(uv)},
                       point);
            add_streams(mixture);
        }
        return vertex;
    }

    std::uint32_t inside_vertex(const InsideFacet& facet, std::uint32_t point)
    {
        const std::uint32_t contact = 2 * facet.contact + (facet.is_turned ? 1 : 0);
        const auto [vertex, is_new] = vertex_named({point, kOfContact, contact});
        if (is_new) {
            const glm::dvec3 normal = split_.contacts[facet.contact].normal;
            const int axis = dominant_axis(normal);
            const glm::vec3& p = position(point);
            const auto coordinate = [&](int which) {
                return nearest_finite_float(look_.uv_scale * double(p[(axis + which) % 3]));
            };
            add_vertex({p, glm::vec3(facet.is_turned ? -normal : normal), {coordinate(1), coordinate(2)}}, point);
            add_streams(mixture_inside(point));
        }
        return vertex;
    }

    /// Of a point of a contact that lies on the surface the vertices there; none of the others.
    Mixture mixture_inside(std::uint32_t point) const
    {
        if (point < points_.size()) return {{vertex_of_point_[point]}, {1.0}, 1};
        if (point - points_.size() >= split_.places.size()) return {};
        return mixture_at(point, [&](std::uint32_t p) { return vertex_of_point_[p]; });
    }

    void add_triangle(const Triangle& corners, std::uint32_t source, std::uint32_t material, TriangleKind kind)
    {
        std::vector<TriangleGroup>& groups = piece_.groups;
        if (groups.empty() || groups.back().material != material || groups.back().kind != kind)
            groups.push_back({static_cast<std::uint32_t>(piece_.triangles.size()), 0, material, 0, kind});
        ++groups.back().count;
        piece_.triangles.push_back(corners);
        piece_.sources.push_back(source);
        const glm::vec3 &a = piece_.vertices[corners[0]].position, &b = piece_.vertices[corners[1]].position,
                        &c = piece_.vertices[corners[2]].position;
        has_thin_triangle_ = has_thin_triangle_ || a == b || b == c || c == a;
    }

    void add(const PartTriangle& part)
    {
        while (part.source >= mesh_.groups[group_].first + mesh_.groups[group_].count) ++group_;
        const Triangle& triangle = mesh_.triangles[part.source];
        const TriangleGroup& group = mesh_.groups[group_];
        add_triangle({surface_vertex(triangle, part.corners[0]), surface_vertex(triangle, part.corners[1]),
                      surface_vertex(triangle, part.corners[2])},
                     mesh_.sources[part.source], group.material, group.kind);
    }

    void add(const InsideFacet& facet)
    {
        add_triangle({inside_vertex(facet, facet.corners[0]), inside_vertex(facet, facet.corners[1]),
                      inside_vertex(facet, facet.corners[2])},
                     kNoSource, look_.material, TriangleKind::cap);
    }

    /// Points that were rounded to one place are welded, and what is left of their triangles is put together anew.
    std::optional<ProvenMesh> repaired()
    {
        const std::vector<std::uint32_t> sources(piece_.sources.begin(), piece_.sources.end());
        TriangleSoup soup;
        soup.materials.resize(2 * piece_.materials.size());
        for (const TriangleGroup& group : piece_.groups)
            soup.triangle_materials.insert(soup.triangle_materials.end(), group.count,
                                           2 * group.material + static_cast<std::uint32_t>(group.kind));
        soup.vertices = std::move(piece_.vertices);
        soup.triangles = std::move(piece_.triangles);
        soup.streams = std::move(piece_.streams);
        Repaired result = repair(std::move(soup), FactsWanted::none);
        if (!result.error.empty()) return std::nullopt;
        IndexedMesh mesh = *std::move(result.mesh);
        mesh.materials = std::move(piece_.materials);
        for (TriangleGroup& group : mesh.groups) {
            group.kind = static_cast<TriangleKind>(group.material % 2);
            group.material /= 2;
        }
        for (std::uint32_t& source : mesh.sources) source = sources[source];
        Proof proof = prove(std::move(mesh));
        if (!proof.error.empty()) return std::nullopt;
        return std::move(proof.mesh);
    }

    const IndexedMesh& mesh_;
    std::span<const glm::vec3> points_;
    const SplitSolid& split_;
    const InsideLook look_;
    std::vector<std::vector<double>> means_;               ///< of each stream
    std::vector<std::uint32_t> vertex_of_point_;           ///< the first one
    std::vector<std::vector<std::uint32_t>> contacts_of_;  ///< of each cell; made when it is first asked for

    // Of the piece that is made
    IndexedMesh piece_;
    std::vector<std::uint32_t> local_vertex_, local_point_;  ///< numbers in it, or kNone
    std::vector<std::uint32_t> used_vertices_, used_points_;
    std::vector<std::uint32_t> old_places_;   ///< numbers of the used vertices in it
    std::vector<std::uint32_t> first_named_;  ///< of each point the first of its list in named_, or kNone
    std::vector<NamedVertex> named_;          ///< new vertices
    std::size_t group_ = 0;                   ///< of the mesh, of the last triangle
    bool has_thin_triangle_ = false;
};

PieceMeshes::PieceMeshes(const IndexedMesh& mesh, std::span<const glm::vec3> points, const SplitSolid& split,
                         const InsideLook& look, std::span<const std::vector<double>> stream_means)
    : maker_(std::make_unique<Maker>(mesh, points, split, look, stream_means))
{
}

PieceMeshes::~PieceMeshes() = default;

std::optional<PieceBorder> PieceMeshes::border_of(std::uint32_t cell)
{
    return maker_->border_of(cell);
}

std::optional<ProvenMesh> PieceMeshes::make(const Fragment& fragment)
{
    return maker_->make(fragment);
}

}  // namespace kerf::core
