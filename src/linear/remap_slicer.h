#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <vector>

#include "common/geometry/pair_table.h"
#include "linear/slicing_steps.h"
#include "linear/vertex_box.h"

namespace kerf::core::linear {

/// Old index -> new index: compares where vertices come from, not what they are, which gives the same fragments as the
/// lookups of vertex_lookup.h in a fraction of the time. Vertices strictly on a side are copied in source order before
/// anything else; only cut edges, and the few vertices that both sides may need (on the plane, or fallen upon by a cut
/// point), are looked up.
class RemapLookup
{
public:
    RemapLookup(SideBuilder& builder, const Buffer<std::uint32_t>& table) : builder_(builder), table_(table)
    {
        seam_vertices_.reset(0);
        other_vertices_.reset(0);
    }

    /// Makes room for the vertices on `count` cut edges.
    void reserve_cuts(std::size_t count) { on_edge_.assign(count, {}); }

    std::uint32_t existing(std::uint32_t vertex)
    {
        if (builder_.has_copied(vertex)) return table_[vertex] >> 1;
        std::uint32_t& index = other_vertices_(vertex, 0);
        if (index == kNone) index = builder_.append_existing(vertex);
        return index;
    }

    std::uint32_t cut(Crossings& crossings, const CrossingTriangle& crossing, std::uint8_t code)
    {
        const Triangle& t = builder_.source().triangles[crossing.triangle];
        const std::uint8_t lone = crossing.split.lone;
        const std::uint32_t a = t[lone];
        const std::uint32_t b = code == TriangleSplit::kCutNext ? t[(lone + 1u) % 3] : t[(lone + 2u) % 3];
        const std::uint32_t lo = std::min(a, b), hi = std::max(a, b);
        OnEdge& known = on_edge_[code == TriangleSplit::kCutNext ? crossing.cut_next : crossing.cut_previous];
        if (known.lo == lo && known.hi == hi) return known.index;
        // The other triangle at a seam has vertices of its own on the same edge.
        std::uint32_t& index = known.index == kNone ? known.index : seam_vertices_(lo, hi);
        if (&index == &known.index) {
            known.lo = lo;
            known.hi = hi;
        }
        if (index == kNone) index = builder_.append_cut(crossings, crossing, code);
        return index;
    }

private:
    SideBuilder& builder_;
    const Buffer<std::uint32_t>& table_;
    /// The vertex on a cut edge, for the first pair of vertices that asked.
    struct OnEdge
    {
        std::uint32_t lo = 0, hi = 0;
        std::uint32_t index = kNone;
    };
    std::vector<OnEdge> on_edge_;  // by cut point
    PairTable seam_vertices_, other_vertices_;
};

/// Copies whole sides and renumbers triangles, instead of looking up every vertex.
class RemapSlicer : public Slicer<RemapSlicer>
{
public:
    using Slicer::Slicer;

    /// Copies each vertex to its side while it is classified, and notes in `table_` where it went: 2 * index + 1 on the
    /// positive side, 2 * index on the negative one. Vertices on the plane wait until a triangle asks for them. O(n).
    void classify_vertices()
    {
        const std::size_t n = mesh_.vertices.size();
        // The table spends one bit on the side.
        if (n > std::numeric_limits<std::uint32_t>::max() / 2)
            throw std::length_error("remap can number 2^31 vertices");
        table_.resize(n);
        // Room for all on either side; what is not needed is given back at once and never written.
        for (SideBuilder& builder : builders_) {
            builder.mesh.vertices.resize(n);
            builder.mesh.points.resize(n);
        }
        // Locals, which the compiler can keep in registers: everything here is written through pointers of the same
        // types.
        SideBuilder &negative = builders_[Side::negative], &positive = builders_[Side::positive];
        Vertex *const below = negative.mesh.vertices.data(), *const above = positive.mesh.vertices.data();
        std::uint32_t* const points_below = negative.mesh.points.data();
        std::uint32_t* const points_above = positive.mesh.points.data();
        const Vertex* const vertices = mesh_.vertices.data();
        const std::uint32_t* const points = mesh_.points.data();
        std::uint32_t *const indices = table_.data(), *const point_ids = point_table_.data();
        std::uint32_t next_below = 0, next_above = 0, next_point_below = 0, next_point_above = 0;
        VertexBox box_below, box_above;

        classes_.classify(whole_, plane_, [&](std::uint32_t vertex, std::uint8_t vertex_class) {
            std::uint32_t& point = point_ids[points[vertex]];
            if (vertex_class == kBelow) {
                if (point == kNone) point = 2 * next_point_below++;
                below[next_below] = vertices[vertex];
                box_below.add(vertices[vertex]);
                points_below[next_below] = point / 2;
                indices[vertex] = 2 * next_below++;
            } else if (vertex_class == kAbove) {
                if (point == kNone) point = 2 * next_point_above++ + 1;
                above[next_above] = vertices[vertex];
                box_above.add(vertices[vertex]);
                points_above[next_above] = point / 2;
                indices[vertex] = 2 * next_above++ + 1;
            }
        });
        negative.set_copied(classes_.of_vertex, kBelow, next_below, next_point_below, box_below);
        positive.set_copied(classes_.of_vertex, kAbove, next_above, next_point_above, box_above);
    }

    /// All vertices are there. Both sides are written without a branch that depends on the side: triangles in a random
    /// order cost no mispredictions.
    void distribute(std::uint32_t g)
    {
        const TriangleGroup& group = mesh_.groups[g];
        IndexedMesh &below = builders_[Side::negative].mesh, &above = builders_[Side::positive].mesh;
        std::size_t at_below = below.triangles.size(), at_above = above.triangles.size();
        // Room for all on either side; what is not needed is given back at once and never written.
        for (IndexedMesh* mesh : {&below, &above}) {
            mesh->triangles.resize(mesh->triangles.size() + group.count);
            mesh->sources.resize(mesh->sources.size() + group.count);
        }
        Triangle *const triangles_below = below.triangles.data(), *const triangles_above = above.triangles.data();
        std::uint32_t *const sources_below = below.sources.data(), *const sources_above = above.sources.data();
        const std::uint32_t* const table = table_.data();
        const std::uint32_t* const sources = mesh_.sources.data();
        const Triangle* const triangles = mesh_.triangles.data();
        for (std::uint32_t i = group.first; i < group.first + group.count; ++i) {
            const Triangle& t = triangles[i];
            const std::uint32_t a = table[t[0]], b = table[t[1]], c = table[t[2]];
            const std::uint32_t sides = ((a ^ b) | (b ^ c)) & 1;
            if (sides != 0) {
                crossings_.triangles.push_back({i, g, 0, 0, {}});
                continue;
            }
            const std::size_t is_above = a & 1;
            const std::size_t at = is_above ? at_above : at_below;
            (is_above ? triangles_above : triangles_below)[at] = {a >> 1, b >> 1, c >> 1};
            (is_above ? sources_above : sources_below)[at] = sources[i];
            at_above += is_above;
            at_below += 1 - is_above;
        }
        below.triangles.resize(at_below);
        below.sources.resize(at_below);
        above.triangles.resize(at_above);
        above.sources.resize(at_above);
    }

    void expect_cut_points(std::size_t count)
    {
        for (RemapLookup& find : lookups_) find.reserve_cuts(count);
    }

    RemapLookup& lookup(Side side) { return lookups_[side]; }

private:
    Buffer<std::uint32_t> table_;  ///< new index of each vertex on its own side
    BySide<RemapLookup> lookups_{RemapLookup(builders_[Side::negative], table_),
                                 RemapLookup(builders_[Side::positive], table_)};
};

}  // namespace kerf::core::linear
