#include "tools/surface_keys.h"

#include <algorithm>
#include <array>
#include <cstring>

namespace kerf::tools {

namespace {

/// The finaliser of SplitMix64 (Steele, Lea and Flood, "Fast splittable pseudorandom number generators", 2014) over
/// what came before and one more word.
std::uint64_t mixed(std::uint64_t before, std::uint64_t word)
{
    std::uint64_t z = (before + 0x9e3779b97f4a7c15ull) ^ word;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
    return z ^ (z >> 31);
}

std::uint64_t hash_of(const float* values, std::size_t count, std::uint64_t hash)
{
    for (std::size_t i = 0; i < count; ++i) {
        std::uint32_t bits;
        std::memcpy(&bits, values + i, sizeof bits);
        hash = mixed(hash, bits);
    }
    return hash;
}

std::vector<std::uint64_t> vertex_hashes(const FlatMesh& mesh)
{
    static_assert(sizeof(Vertex) == 8 * sizeof(float));
    std::vector<std::uint64_t> hashes(mesh.vertices.size());
    for (std::size_t v = 0; v < hashes.size(); ++v) {
        std::array<float, 8> values;
        std::memcpy(values.data(), &mesh.vertices[v], sizeof values);
        hashes[v] = hash_of(values.data(), values.size(), 0);
        for (const VertexStream& stream : mesh.streams)
            hashes[v] = hash_of(stream.values.data() + v * stream.width, stream.width, hashes[v]);
    }
    return hashes;
}

bool same_vertex(const FlatMesh& a, std::uint32_t i, const FlatMesh& b, std::uint32_t j)
{
    // NOLINTNEXTLINE(bugprone-suspicious-memory-comparison): vertices are told apart by their bits, as hash_of() does
    if (std::memcmp(&a.vertices[i], &b.vertices[j], sizeof(Vertex)) != 0) return false;
    for (std::size_t s = 0; s < a.streams.size(); ++s) {
        const std::size_t width = a.streams[s].width;
        if (std::memcmp(&a.streams[s].values[i * width], &b.streams[s].values[j * width], width * sizeof(float)) != 0)
            return false;
    }
    return true;
}

bool same_triangle(const SurfaceKeys& first, const SurfaceKeys::Key& p, const SurfaceKeys& second,
                   const SurfaceKeys::Key& q)
{
    const FlatMesh &a = first.mesh(), &b = second.mesh();
    const TriangleGroup &g = a.groups[p.group], &h = b.groups[q.group];
    if (a.sources[p.triangle] != b.sources[q.triangle] || g.material != h.material || g.solid != h.solid) return false;
    const Triangle &t = a.triangles[p.triangle], &u = b.triangles[q.triangle];
    for (std::size_t turn = 0; turn < 3; ++turn) {
        std::size_t i = 0;
        while (i < 3 && same_vertex(a, t[i], b, u[(i + turn) % 3])) ++i;
        if (i == 3) return true;
    }
    return false;
}

bool same_layout(const FlatMesh& a, const FlatMesh& b)
{
    return std::equal(
               a.streams.begin(), a.streams.end(), b.streams.begin(), b.streams.end(),
               [](const VertexStream& s, const VertexStream& t) { return s.name == t.name && s.width == t.width; }) &&
           std::equal(a.materials.begin(), a.materials.end(), b.materials.begin(), b.materials.end(),
                      [](const MaterialLook& m, const MaterialLook& n) { return m == n; });
}

}  // namespace

SurfaceKeys::SurfaceKeys(const FlatMesh& mesh) : mesh_(&mesh)
{
    const std::vector<std::uint64_t> vertex_hash = vertex_hashes(mesh);
    keys_.reserve(mesh.triangles.size());
    for (std::uint32_t g = 0; g < mesh.groups.size(); ++g) {
        const TriangleGroup& group = mesh.groups[g];
        if (group.kind != TriangleKind::surface) continue;
        for (std::uint32_t t = group.first; t < group.first + group.count; ++t) {
            const auto corner_hash = [&](std::uint32_t i) { return vertex_hash[mesh.triangles[t][i % 3]]; };
            const auto from = [&](std::uint32_t i) {
                return std::array{corner_hash(i), corner_hash(i + 1), corner_hash(i + 2)};
            };
            std::uint32_t corner = 0;
            for (std::uint32_t i = 1; i < 3; ++i)
                if (from(i) < from(corner)) corner = i;
            std::uint64_t hash = mixed(mixed(mesh.sources[t], group.material), group.solid);
            for (const std::uint64_t word : from(corner)) hash = mixed(hash, word);
            keys_.push_back({hash, t, g, corner});
        }
    }
    std::sort(keys_.begin(), keys_.end(), [](const Key& a, const Key& b) { return a.hash < b.hash; });
}

SurfaceDifference compare_surfaces(const SurfaceKeys& first, const SurfaceKeys& second)
{
    SurfaceDifference difference;
    if (!same_layout(first.mesh(), second.mesh())) {
        difference.other_layout = true;
        return difference;
    }
    const auto &a = first.sorted(), &b = second.sorted();
    std::vector<const SurfaceKeys::Key*> unmatched;
    for (std::size_t i = 0, j = 0; i < a.size() || j < b.size();) {
        const std::uint64_t hash = i == a.size()   ? b[j].hash
                                   : j == b.size() ? a[i].hash
                                                   : std::min(a[i].hash, b[j].hash);
        // Triangles of one hash are matched one by one; almost always it is one on each side.
        unmatched.clear();
        for (; i < a.size() && a[i].hash == hash; ++i) unmatched.push_back(&a[i]);
        for (; j < b.size() && b[j].hash == hash; ++j) {
            const auto match = std::find_if(unmatched.begin(), unmatched.end(), [&](const SurfaceKeys::Key* key) {
                return same_triangle(first, *key, second, b[j]);
            });
            if (match == unmatched.end())
                ++difference.only_second;
            else
                unmatched.erase(match);
        }
        difference.only_first += unmatched.size();
    }
    return difference;
}

}  // namespace kerf::tools
