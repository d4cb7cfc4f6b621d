#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <functional>
#include <limits>
#include <span>
#include <stdexcept>
#include <string_view>
#include <unordered_set>
#include <vector>

#include "baseline/pair_table.h"
#include "baseline/side_builder.h"

// The four ways to find out whether a fragment has a vertex already (VertexLookup). Each is made for one side of one
// cut and answers
//   existing(vertex)           index in the fragment of a vertex of the source
//   cut(crossings, c, code)    index in the fragment of the vertex at a cut corner
// and adds a vertex that is missing. The first three compare what the vertices are, as the report does; `remap`
// compares where they come from, which gives the same fragments in a fraction of the time.

namespace kerf::baseline {

/// Two vertices of a fragment are the same: attributes, point and streams bit for bit.
inline bool same_vertex(const IndexedMesh& mesh, std::uint32_t a, std::uint32_t b)
{
    if (mesh.points[a] != mesh.points[b]) return false;
    // NOLINTNEXTLINE(bugprone-suspicious-memory-comparison): that is what "bit for bit" means
    if (std::memcmp(&mesh.vertices[a], &mesh.vertices[b], sizeof(Vertex)) != 0) return false;
    for (const VertexStream& stream : mesh.streams) {
        const float* values = stream.values.data();
        const std::size_t size = stream.width * sizeof(float);
        if (std::memcmp(values + std::size_t(a) * stream.width, values + std::size_t(b) * stream.width, size) != 0)
            return false;
    }
    return true;
}

/// Appends the vertex in question, asks `find` whether an equal one was there before, and takes it away again if so.
template <class Self>
class LookupByContent
{
public:
    explicit LookupByContent(SideBuilder& builder) : builder_(builder) {}

    std::uint32_t existing(std::uint32_t vertex) { return keep_or_find(builder_.append_existing(vertex)); }

    std::uint32_t cut(Crossings& crossings, const CrossingTriangle& crossing, std::uint8_t code)
    {
        return keep_or_find(builder_.append_cut(crossings, crossing, code));
    }

protected:
    SideBuilder& builder_;

private:
    std::uint32_t keep_or_find(std::uint32_t candidate)
    {
        const std::uint32_t index = static_cast<Self*>(this)->find_or_insert(candidate);
        if (index != candidate) builder_.remove_last();
        return index;
    }
};

/// "Loop over all points of the fragment, and check if that point already exists."
class ScanLookup : public LookupByContent<ScanLookup>
{
public:
    using LookupByContent::LookupByContent;

    std::uint32_t find_or_insert(std::uint32_t candidate)
    {
        std::uint32_t i = 0;
        while (!same_vertex(builder_.mesh, i, candidate)) ++i;
        builder_.comparisons += i + 1;
        return i;
    }
};

/// Hashes all that same_vertex() compares: if many vertices lie in one place, position alone would put them all into
/// one chain.
struct ProperHash
{
    static std::size_t of(const IndexedMesh& mesh, std::uint32_t i)
    {
        // Boost's hash_combine constants, 64 bit: the fractional part of the golden ratio spreads neighbouring values.
        const auto mix = [](std::size_t seed, std::size_t value) {
            return seed ^ (value + 0x9e3779b97f4a7c15ull + (seed << 6) + (seed >> 2));
        };
        std::size_t hash = mix(of_bytes(&mesh.vertices[i], sizeof(Vertex)), mesh.points[i]);
        for (const VertexStream& stream : mesh.streams)
            hash =
                mix(hash, of_bytes(stream.values.data() + std::size_t(i) * stream.width, stream.width * sizeof(float)));
        return hash;
    }

private:
    static std::size_t of_bytes(const void* bytes, std::size_t size)
    {
        return std::hash<std::string_view>{}({static_cast<const char*>(bytes), size});
    }
};

/// Combines the hashes of the coordinates with a logical or, as the report's program did: it has two values, true and
/// false.
struct TwoValuedHash
{
    static std::size_t of(const IndexedMesh& mesh, std::uint32_t i)
    {
        const glm::vec3& p = mesh.vertices[i].position;
        const std::hash<float> hash;
        return (hash(p.x) || hash(p.y) || hash(p.z)) ? 1 : 0;
    }
};

/// "Each point added to a fragment is added to a dictionary as well."
template <class Hash>
class DictionaryLookup : public LookupByContent<DictionaryLookup<Hash>>
{
    using Base = LookupByContent<DictionaryLookup<Hash>>;

public:
    explicit DictionaryLookup(SideBuilder& builder)
        : Base(builder), dictionary_(0, HashOfIndex{&builder.mesh}, SameVertex{&builder})
    {
    }

    std::uint32_t find_or_insert(std::uint32_t candidate) { return *dictionary_.insert(candidate).first; }

private:
    struct HashOfIndex
    {
        const IndexedMesh* mesh;
        std::size_t operator()(std::uint32_t i) const { return Hash::of(*mesh, i); }
    };
    struct SameVertex
    {
        SideBuilder* builder;
        bool operator()(std::uint32_t a, std::uint32_t b) const
        {
            ++builder->comparisons;
            return same_vertex(builder->mesh, a, b);
        }
    };

    std::unordered_set<std::uint32_t, HashOfIndex, SameVertex> dictionary_;
};

/// Old index -> new index. Vertices strictly on a side are copied in source order before anything else; only cut edges,
/// and the few vertices that both sides may need (on the plane, or fallen upon by a cut point), are looked up.
class RemapLookup
{
public:
    RemapLookup(SideBuilder& builder, const Buffer<std::uint32_t>& table) : builder_(builder), table_(table)
    {
        seam_vertices_.reset(0);
        other_vertices_.reset(0);
    }

    /// Copies each vertex to its side while `classify` shows it with its class, and notes in `table` where it went: 2 *
    /// index + 1 on the positive side, 2 * index on the negative one. Vertices on the plane wait until a triangle asks
    /// for them. O(n). `classify(visit)` calls visit(vertex, class) for every vertex in order and returns the classes.
    template <class Classify>
    static void copy_vertices(const IndexedMesh& source, BySide<SideBuilder>& builders, Buffer<std::uint32_t>& table,
                              std::span<std::uint32_t> point_table, Classify&& classify)
    {
        const std::size_t n = source.vertices.size();
        // The table spends one bit on the side.
        if (n > std::numeric_limits<std::uint32_t>::max() / 2)
            throw std::length_error("remap can number 2^31 vertices");
        table.resize(n);
        // Room for all on either side; what is not needed is given back at once and never written.
        for (SideBuilder& builder : builders) {
            builder.mesh.vertices.resize(n);
            builder.mesh.points.resize(n);
        }
        // Locals, which the compiler can keep in registers: everything here is written through pointers of the same
        // types.
        SideBuilder &negative = builders[Side::negative], &positive = builders[Side::positive];
        Vertex *const below = negative.mesh.vertices.data(), *const above = positive.mesh.vertices.data();
        std::uint32_t* const points_below = negative.mesh.points.data();
        std::uint32_t* const points_above = positive.mesh.points.data();
        const Vertex* const vertices = source.vertices.data();
        const std::uint32_t* const points = source.points.data();
        std::uint32_t *const indices = table.data(), *const point_ids = point_table.data();
        std::uint32_t next_below = 0, next_above = 0, next_point_below = 0, next_point_above = 0;
        VertexBox box_below, box_above;

        const std::span<const std::uint8_t> classes = classify([&](std::uint32_t vertex, std::uint8_t vertex_class) {
            std::uint32_t& point = point_ids[points[vertex]];
            if (vertex_class == 1) {
                if (point == SideBuilder::kNone) point = 2 * next_point_below++;
                below[next_below] = vertices[vertex];
                box_below.add(vertices[vertex]);
                points_below[next_below] = point / 2;
                indices[vertex] = 2 * next_below++;
            } else if (vertex_class == 2) {
                if (point == SideBuilder::kNone) point = 2 * next_point_above++ + 1;
                above[next_above] = vertices[vertex];
                box_above.add(vertices[vertex]);
                points_above[next_above] = point / 2;
                indices[vertex] = 2 * next_above++ + 1;
            }
        });
        negative.set_copied(classes, 1, next_below, next_point_below, box_below);
        positive.set_copied(classes, 2, next_above, next_point_above, box_above);
    }

    /// Makes room for the vertices on `count` cut edges.
    void reserve_cuts(std::size_t count) { on_edge_.assign(count, {}); }

    std::uint32_t existing(std::uint32_t vertex)
    {
        if (builder_.has_copied(vertex)) return table_[vertex] >> 1;
        std::uint32_t& index = other_vertices_(vertex, 0);
        if (index == PairTable::kNone) index = builder_.append_existing(vertex);
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
        std::uint32_t& index = known.index == PairTable::kNone ? known.index : seam_vertices_(lo, hi);
        if (&index == &known.index) {
            known.lo = lo;
            known.hi = hi;
        }
        if (index == PairTable::kNone) index = builder_.append_cut(crossings, crossing, code);
        return index;
    }

private:
    SideBuilder& builder_;
    const Buffer<std::uint32_t>& table_;
    /// The vertex on a cut edge, for the first pair of vertices that asked.
    struct OnEdge
    {
        std::uint32_t lo = 0, hi = 0;
        std::uint32_t index = PairTable::kNone;
    };
    std::vector<OnEdge> on_edge_;  // by cut point
    PairTable seam_vertices_, other_vertices_;
};

}  // namespace kerf::baseline
