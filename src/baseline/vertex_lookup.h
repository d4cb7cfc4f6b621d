#pragma once

#include <cstdint>
#include <cstring>
#include <functional>
#include <string_view>
#include <unordered_set>

#include "linear/side_builder.h"

// The report's three ways to find out whether a fragment has a vertex already (VertexLookup); remap_slicer.h has the
// fourth. Each is made for one side of one cut and answers
//   existing(vertex)           index in the fragment of a vertex of the source
//   cut(crossings, c, code)    index in the fragment of the vertex at a cut corner
// and adds a vertex that is missing. These three compare what the vertices are, as the report does.

namespace kerf::core::baseline {

using linear::Crossings;
using linear::CrossingTriangle;
using linear::SideBuilder;

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

}  // namespace kerf::core::baseline
