#pragma once

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

#include "common/geometry/pair_table.h"
#include "linear/crossing.h"
#include "linear/fragment.h"
#include "linear/vertex_box.h"

namespace kerf::core::linear {

/// Collects the triangles and vertices of one side of a cut. Whether a vertex is there already is decided by the
/// VertexLookup (vertex_lookup.h), not here.
class SideBuilder
{
public:
    /// `point_table` has one entry, kNone to begin with, for each point of the source, and is shared by both sides:
    /// nearly every point is needed on one side only.
    SideBuilder(const IndexedMesh& source, Side side, std::span<std::uint32_t> point_table)
        : source_(source), side_(side), point_table_(point_table)
    {
        mesh.streams.reserve(source.streams.size());
        for (const VertexStream& stream : source.streams) mesh.streams.push_back({stream.name, stream.width, {}});
        other_points_.reset(0);
    }

    IndexedMesh mesh;                        ///< what has been collected
    VertexBox bounds;                        ///< around its vertices
    std::vector<std::uint32_t> fan_centres;  ///< vertices of `mesh`
    std::uint64_t comparisons = 0;           ///< how often the lookup compared two vertices

    Side side() const { return side_; }
    const IndexedMesh& source() const { return source_; }

    void set_cut_point_count(std::size_t count) { point_of_cut_.assign(count, kNone); }

    /// Declares that the vertices of class `own` have been filled in bulk, in source order: `vertices` vertices of
    /// `points` points, which lie in `box`. Appends their streams.
    void set_copied(std::span<const std::uint8_t> classes, std::uint8_t own, std::uint32_t vertices,
                    std::uint32_t points, const VertexBox& box)
    {
        bounds = box;
        classes_ = classes;
        own_class_ = own;
        mesh.vertices.resize(vertices);
        mesh.points.resize(vertices);
        mesh.point_count = points;
        for (std::size_t s = 0; s < mesh.streams.size(); ++s)
            for (std::uint32_t v = 0; v < classes.size(); ++v)
                if (classes[v] == own) append_stream_values(s, v);
    }

    /// Whether a vertex of the source has been copied in bulk.
    bool has_copied(std::uint32_t vertex) const { return classes_[vertex] == own_class_; }

    /// This side's id of a point of the source. The side that asks first takes the point's entry in the shared table.
    std::uint32_t point_of_existing(std::uint32_t point)
    {
        const auto side = static_cast<std::uint32_t>(side_);
        std::uint32_t& entry = point_table_[point];
        if (entry == kNone) entry = 2 * mesh.point_count++ + side;
        if ((entry & 1) == side) return entry / 2;
        std::uint32_t& id = other_points_(point, 0);
        if (id == kNone) id = mesh.point_count++;
        return id;
    }

    /// This side's id of a cut point: that of the existing point of its class, if there is one.
    std::uint32_t point_of_cut(Crossings& crossings, std::uint32_t cut_point)
    {
        const std::uint32_t existing = crossings.cut_points.existing(cut_point);
        if (existing != kNone) return point_of_existing(existing);
        std::uint32_t& id = point_of_cut_[cut_point];
        if (id == kNone) id = mesh.point_count++;
        return id;
    }

    /// Unites points that coincide. O(n) if there are any.
    void join_points(const CutPointClasses& cut_points)
    {
        if (cut_points.joined().empty()) return;
        std::vector<std::uint32_t> id(mesh.point_count);
        std::iota(id.begin(), id.end(), 0u);
        for (const auto& [point, next] : cut_points.joined()) {
            const std::uint32_t own = point_of_existing(point),
                                stays = point_of_existing(cut_points.standing_for(next));
            if (own < id.size()) id[own] = stays;
        }
        for (std::uint32_t& point : mesh.points) point = id[point];
    }

    /// A point known to the caller alone.
    std::uint32_t new_point() { return mesh.point_count++; }

    /// Appends a copy of a vertex of the source and returns its index.
    std::uint32_t append_existing(std::uint32_t vertex)
    {
        append_streams_of(vertex);
        mesh.points.push_back(point_of_existing(source_.points[vertex]));
        return append_vertex(source_.vertices[vertex]);
    }

    /// Appends the vertex at a cut corner of a crossing triangle and returns its index.
    std::uint32_t append_cut(Crossings& crossings, const CrossingTriangle& crossing, std::uint8_t code)
    {
        append_streams(crossing, code);
        mesh.points.push_back(point_of_cut(crossings, crossings.cut_point(crossing, code)));
        return append_vertex(corner_vertex(source_, crossing, code));
    }

    /// Appends a vertex, whose point and streams are the caller's to append, and returns its index.
    std::uint32_t append_vertex(const Vertex& vertex)
    {
        mesh.vertices.push_back(vertex);
        bounds.add(vertex);
        return static_cast<std::uint32_t>(mesh.vertices.size() - 1);
    }

    /// Appends the stream values at a corner of a crossing triangle, for a vertex that the caller appends.
    void append_streams(const CrossingTriangle& crossing, std::uint8_t code)
    {
        for (std::size_t s = 0; s < mesh.streams.size(); ++s) {
            Buffer<float>& values = mesh.streams[s].values;
            values.resize(values.size() + source_.streams[s].width);
            corner_stream(source_, source_.streams[s], crossing, code,
                          values.data() + values.size() - source_.streams[s].width);
        }
    }

    /// Appends the stream values of a vertex of the source, for a vertex that the caller appends.
    void append_streams_of(std::uint32_t vertex)
    {
        for (std::size_t s = 0; s < mesh.streams.size(); ++s) append_stream_values(s, vertex);
    }

    /// Removes the last vertex. The bounds stay, because an equal vertex is there.
    void remove_last()
    {
        mesh.vertices.pop_back();
        mesh.points.pop_back();
        for (VertexStream& stream : mesh.streams) stream.values.resize(stream.values.size() - stream.width);
    }

    void add_triangle(const Triangle& triangle, std::uint32_t source)
    {
        mesh.triangles.push_back(triangle);
        mesh.sources.push_back(source);
    }

    /// Declares that the triangles added since the last call belong to a group like `like`; joins the group before if
    /// it is alike.
    void close_group(const TriangleGroup& like)
    {
        const auto end = static_cast<std::uint32_t>(mesh.triangles.size());
        const std::uint32_t first = mesh.groups.empty() ? 0 : mesh.groups.back().first + mesh.groups.back().count;
        if (end == first) return;
        if (!mesh.groups.empty()) {
            TriangleGroup& last = mesh.groups.back();
            if (last.material == like.material && last.solid == like.solid && last.kind == like.kind) {
                last.count = end - last.first;
                return;
            }
        }
        mesh.groups.push_back({first, end - first, like.material, like.solid, like.kind});
    }

private:
    void append_stream_values(std::size_t stream, std::uint32_t vertex)
    {
        const VertexStream& from = source_.streams[stream];
        const float* values = from.values.data() + std::size_t(vertex) * from.width;
        mesh.streams[stream].values.insert(mesh.streams[stream].values.end(), values, values + from.width);
    }

    const IndexedMesh& source_;
    Side side_;
    std::span<const std::uint8_t> classes_;  // of the vertices of the source, after set_copied()
    std::uint8_t own_class_ = 0;
    std::span<std::uint32_t> point_table_;     // by point of the source: 2 * id + side
    PairTable other_points_;                   // ids of points whose entry is the other side's
    std::vector<std::uint32_t> point_of_cut_;  // by class of cut points
};

}  // namespace kerf::core::linear
