#include "common/repair/weld.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstring>

namespace kerf::core {

namespace {

constexpr std::uint32_t kEmpty = std::numeric_limits<std::uint32_t>::max();

/// Mixes one more 64-bit word into a hash: multiply, fold the high half down.
std::uint64_t mix(std::uint64_t hash, std::uint64_t word)
{
    hash = (hash ^ word) * 0x9E3779B97F4A7C15u;
    return hash ^ (hash >> 32);
}

std::uint64_t bits(float a, float b)
{
    return std::bit_cast<std::uint32_t>(a) | std::uint64_t{std::bit_cast<std::uint32_t>(b)} << 32;
}

/// A hash table of indices whose keys stay where they are, in the arrays that are welded: the owner hashes and
/// compares. Open addressing, linear probing.
class IndexTable
{
public:
    explicit IndexTable(std::size_t capacity)
        : slots_(std::bit_ceil(std::max<std::size_t>(16, capacity + capacity / 2)), kEmpty), mask_(slots_.size() - 1)
    {
    }

    /// Returns the entry that is_same() accepts; otherwise enters and returns `candidate`.
    template <class IsSame>
    std::uint32_t find_or_insert(std::uint64_t hash, std::uint32_t candidate, IsSame&& is_same)
    {
        for (std::size_t i = hash & mask_;; i = (i + 1) & mask_) {
            if (slots_[i] == kEmpty) return slots_[i] = candidate;
            if (is_same(slots_[i])) return slots_[i];
        }
    }

private:
    std::vector<std::uint32_t> slots_;
    std::size_t mask_;
};

/// A position as bits, with -0 turned into +0.
struct PositionKey
{
    std::uint64_t xy, z;
    explicit PositionKey(const glm::vec3& p) : xy(bits(p.x + 0.0f, p.y + 0.0f)), z(bits(p.z + 0.0f, 0.0f)) {}
    bool operator==(const PositionKey&) const = default;
    std::uint64_t hash() const { return mix(mix(0, xy), z); }
};

}  // namespace

Weld weld_positions(std::span<const Vertex> vertices)
{
    Weld weld;
    weld.points.resize(vertices.size());
    IndexTable table(vertices.size());
    for (std::uint32_t v = 0; v < vertices.size(); ++v) {
        const PositionKey key(vertices[v].position);
        for (int i = 0; i < 3; ++i) weld.is_finite &= std::isfinite(vertices[v].position[i]);
        const std::uint32_t first = table.find_or_insert(
            key.hash(), v, [&](std::uint32_t other) { return PositionKey(vertices[other].position) == key; });
        weld.points[v] = first == v ? weld.point_count++ : weld.points[first];
    }
    return weld;
}

Buffer<std::uint32_t> first_equal_vertices(const Weld& weld, std::span<const Vertex> vertices,
                                           std::span<const VertexStream> streams, bool ignore_normals)
{
    const auto equal = [&](std::uint32_t a, std::uint32_t b) {
        if (weld.points[a] != weld.points[b]) return false;
        // NOLINTBEGIN(bugprone-suspicious-memory-comparison): equal means bit for bit
        if (std::memcmp(&vertices[a].uv, &vertices[b].uv, sizeof(glm::vec2)) != 0) return false;
        if (!ignore_normals && std::memcmp(&vertices[a].normal, &vertices[b].normal, sizeof(glm::vec3)) != 0)
            return false;
        // NOLINTEND(bugprone-suspicious-memory-comparison)
        for (const VertexStream& stream : streams) {
            const float* values = stream.values.data();
            const std::size_t width = stream.width;
            if (std::memcmp(values + a * width, values + b * width, width * sizeof(float)) != 0) return false;
        }
        return true;
    };
    const auto hash = [&](std::uint32_t v) {
        std::uint64_t h = mix(0, weld.points[v]);
        h = mix(h, bits(vertices[v].uv.x, vertices[v].uv.y));
        if (!ignore_normals) {
            h = mix(h, bits(vertices[v].normal.x, vertices[v].normal.y));
            h = mix(h, bits(vertices[v].normal.z, 0.0f));
        }
        for (const VertexStream& stream : streams) {
            const std::size_t first = std::size_t{v} * stream.width;
            for (std::size_t i = 0; i < stream.width; ++i) h = mix(h, bits(stream.values[first + i], 0.0f));
        }
        return h;
    };

    // Most points have one vertex: only vertices that differ from the first one of their point need a table.
    Buffer<std::uint32_t> first_of_point(weld.point_count, kEmpty);
    Buffer<std::uint32_t> first_equal(vertices.size());
    IndexTable table(vertices.size() - weld.point_count);
    for (std::uint32_t v = 0; v < vertices.size(); ++v) {
        std::uint32_t& first = first_of_point[weld.points[v]];
        if (first == kEmpty) first = v;
        if (first == v || equal(first, v))
            first_equal[v] = first;
        else
            first_equal[v] = table.find_or_insert(hash(v), v, [&](std::uint32_t other) { return equal(other, v); });
    }
    return first_equal;
}

}  // namespace kerf::core
