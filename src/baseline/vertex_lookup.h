#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <functional>
#include <limits>
#include <span>
#include <stdexcept>
#include <unordered_set>

#include "baseline/pair_table.h"
#include "baseline/side_builder.h"

// The four ways to find out whether a fragment has a vertex already (VertexLookup). Each is made for one side of one
// cut and answers
//   existing(vertex)           index in the fragment of a vertex of the source
//   cut(crossings, c, code)    index in the fragment of the vertex at a cut corner
// and adds what is not there. The first three compare what the vertices are, as the report does; `remap` compares where
// they come from, which gives the same fragments in a fraction of the time.

namespace kerf::baseline {

/// Two vertices of a fragment are the same: attributes, point and streams bit for bit.
inline bool same_vertex(const IndexedMesh& mesh, std::uint32_t a, std::uint32_t b)
{
    if (mesh.points[a] != mesh.points[b]) return false;
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

    std::uint32_t find_or_insert(std::uint32_t candidate) const
    {
        std::uint32_t i = 0;
        while (!same_vertex(builder_.mesh, i, candidate)) ++i;
        return i;
    }
};

/// Combines the hashes of the coordinates as a dictionary should.
struct ProperHash
{
    static std::size_t combine(std::size_t x, std::size_t y, std::size_t z)
    {
        // Boost's hash_combine constants, 64 bit: the fractional part of the golden ratio spreads neighbouring values.
        const auto mix = [](std::size_t seed, std::size_t value) {
            return seed ^ (value + 0x9e3779b97f4a7c15ull + (seed << 6) + (seed >> 2));
        };
        return mix(mix(x, y), z);
    }
};

/// Combines them with a logical or, as the report's program did: true or false are all the values there are.
struct TwoValuedHash
{
    static std::size_t combine(std::size_t x, std::size_t y, std::size_t z) { return (x || y || z) ? 1 : 0; }
};

/// "Each point added to a fragment is added to a dictionary as well."
template <class Hash>
class DictionaryLookup : public LookupByContent<DictionaryLookup<Hash>>
{
    using Base = LookupByContent<DictionaryLookup<Hash>>;

public:
    explicit DictionaryLookup(SideBuilder& builder)
        : Base(builder), dictionary_(0, HashOfIndex{&builder.mesh}, SameVertex{&builder.mesh})
    {
    }

    std::uint32_t find_or_insert(std::uint32_t candidate) { return *dictionary_.insert(candidate).first; }

private:
    struct HashOfIndex
    {
        const IndexedMesh* mesh;
        std::size_t operator()(std::uint32_t i) const
        {
            const glm::vec3& p = mesh->vertices[i].position;
            const std::hash<float> hash;
            return Hash::combine(hash(p.x), hash(p.y), hash(p.z));
        }
    };
    struct SameVertex
    {
        const IndexedMesh* mesh;
        bool operator()(std::uint32_t a, std::uint32_t b) const { return same_vertex(*mesh, a, b); }
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
        cut_vertices_.reset(0);
        other_vertices_.reset(0);
    }

    /// Copies each vertex to its side while the vertices are being classified, and notes in `table` where it went: 2 *
    /// index + 1 on the positive side, 2 * index on the negative one. Vertices on the plane wait until a triangle asks
    /// for them.
    class Copier
    {
    public:
        Copier(const IndexedMesh& source, std::array<SideBuilder, 2>& builders, Buffer<std::uint32_t>& table,
               std::span<std::uint32_t> point_table)
            : source_(source), builders_(builders), table_(table), point_table_(point_table)
        {
            // The table spends one bit on the side.
            if (source.vertices.size() > std::numeric_limits<std::uint32_t>::max() / 2)
                throw std::length_error("remap can number 2^31 vertices");
            table.resize(source.vertices.size());
            for (std::size_t side = 0; side < 2; ++side) {
                IndexedMesh& mesh = builders[side].mesh;
                mesh.vertices.resize(source.vertices.size());
                mesh.points.resize(source.vertices.size());
                vertices_[side] = mesh.vertices.data();
                points_[side] = mesh.points.data();
            }
        }

        void operator()(std::uint32_t vertex, std::uint8_t vertex_class)
        {
            if (vertex_class == 0) return;
            const std::size_t side = vertex_class >> 1;
            const std::uint32_t at = side ? next_[1] : next_[0];
            (side ? vertices_[1] : vertices_[0])[at] = source_.vertices[vertex];
            std::uint32_t& point = point_table_[source_.points[vertex]];
            if (point == SideBuilder::kNone)
                point = 2 * (side ? next_point_[1]++ : next_point_[0]++) + static_cast<std::uint32_t>(side);
            (side ? points_[1] : points_[0])[at] = point / 2;
            table_[vertex] = 2 * at + static_cast<std::uint32_t>(side);
            next_[1] += static_cast<std::uint32_t>(side);
            next_[0] += static_cast<std::uint32_t>(1 - side);
        }

        void finish(std::span<const std::uint8_t> classes)
        {
            for (std::size_t side = 0; side < 2; ++side)
                builders_[side].set_copied(classes, static_cast<std::uint8_t>(side + 1), next_[side],
                                           next_point_[side]);
        }

    private:
        const IndexedMesh& source_;
        std::array<SideBuilder, 2>& builders_;
        Buffer<std::uint32_t>& table_;
        std::array<Vertex*, 2> vertices_;
        std::array<std::uint32_t*, 2> points_;
        std::span<std::uint32_t> point_table_;
        std::array<std::uint32_t, 2> next_{}, next_point_{};
    };

    /// Makes room for the vertices on `count` cut edges.
    void reserve_cuts(std::size_t count) { cut_vertices_.reset(count); }

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
        std::uint32_t& index = cut_vertices_(std::min(a, b), std::max(a, b));
        if (index == PairTable::kNone) index = builder_.append_cut(crossings, crossing, code);
        return index;
    }

private:
    SideBuilder& builder_;
    const Buffer<std::uint32_t>& table_;
    PairTable cut_vertices_, other_vertices_;
};

}  // namespace kerf::baseline
