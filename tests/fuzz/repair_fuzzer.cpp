// Triangles that nothing is promised of: repaired into a mesh that keeps IndexedMesh's promises and that both back ends
// take, or refused in one sentence.

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "baseline/baseline.h"
#include "common/proxy/collision_proxy.h"
#include "common/repair/mesh_facts.h"
#include "common/repair/repair.h"
#include "fuzz/byte_reader.h"
#include "fuzz/fuzzers.h"
#include "fuzz/mesh_from_bytes.h"
#include "fuzz/require.h"
#include "halfedge/fragment.h"
#include "halfedge/halfedge.h"
#include "support/check_universe.h"
#include "support/referee.h"

namespace kerf::core::fuzz {

namespace {

/// Breaks what mesh_from_bytes keeps.
void damage(TriangleSoup& soup, ByteReader& bytes)
{
    const std::uint8_t what = bytes.byte();
    const auto some_vertex = [&]() -> Vertex& {
        return soup.vertices[bytes.below(static_cast<std::uint32_t>(soup.vertices.size()))];
    };
    const auto some_float = [&] { return std::bit_cast<float>(bytes.word()); };
    if ((what & 1) != 0) some_vertex().position[static_cast<int>(bytes.below(3))] = some_float();
    if ((what & 2) != 0) some_vertex().normal[static_cast<int>(bytes.below(3))] = some_float();
    if ((what & 4) != 0) some_vertex().uv[static_cast<int>(bytes.below(2))] = some_float();
    if ((what & 8) != 0 && !soup.triangles.empty())
        soup.triangles[bytes.below(static_cast<std::uint32_t>(soup.triangles.size()))][bytes.below(3)] = bytes.word();
    if ((what & 16) != 0 && !soup.triangle_materials.empty()) soup.triangle_materials.back() = bytes.word();
    if ((what & 32) != 0 && !soup.streams.empty()) soup.streams.back().values.pop_back();
    if ((what & 64) != 0) soup.has_normals = !soup.has_normals;
    if ((what & 128) != 0)
        for (std::uint32_t i = bytes.below(40); i > 0 && !soup.triangles.empty(); --i) {
            Triangle t = soup.triangles[bytes.below(static_cast<std::uint32_t>(soup.triangles.size()))];
            if (bytes.byte() % 2 == 0) std::swap(t[0], t[1]);
            soup.triangles.push_back(t);
            if (!soup.triangle_materials.empty()) soup.triangle_materials.push_back(0);
        }
}

}  // namespace

void fuzz_repair(Bytes input)
{
    ByteReader bytes(input);
    TriangleSoup soup = soup_from(bytes);
    damage(soup, bytes);
    const std::size_t triangles = soup.triangles.size();
    const bool in_range = std::all_of(soup.triangles.begin(), soup.triangles.end(), [&](const Triangle& t) {
        return std::all_of(t.begin(), t.end(), [&](std::uint32_t v) { return v < soup.vertices.size(); });
    });
    const MeshFacts facts = in_range ? measure(soup) : MeshFacts();

    const Repaired repaired = repair(std::move(soup));
    if (!repaired.error.empty()) {
        require(repaired.error.size() < 300, "an error is a sentence");
        return;
    }
    const IndexedMesh& mesh = repaired.mesh;
    const Repairs& repairs = repaired.repairs;
    require(prove(mesh).error.empty(), "a repaired mesh is one (" + prove(mesh).error + ")");
    require(is_manifold(mesh), "a repaired mesh is manifold");
    require(mesh.triangles.size() + repairs.degenerate_triangles + repairs.duplicate_triangles == triangles,
            "triangles are kept or counted as dropped");
    require(std::all_of(mesh.sources.begin(), mesh.sources.end(), [&](std::uint32_t s) { return s < triangles; }),
            "sources are triangles of the soup");
    require(referee::triangles_with_equal_corners(mesh) == 0, "no triangle has two corners at one position");
    require(referee::open_edges(mesh) == facts.open_edges, "the facts say what is open");
    require(facts.unbalanced_edges > 0 || facts.closed(), "what is closed stays closed");

    for (const auto& backend : {baseline::make_back_end(), halfedge::make_back_end()}) {
        const PrepareResult result = backend->prepare(mesh);
        require(result.status == Status::done, backend->name() + " takes a repaired mesh (" + result.reason + ")");
        const IndexedMesh copy = result.object->to_indexed_mesh();
        require(referee::canonical_surface(copy) == referee::canonical_surface(mesh),
                backend->name() + " keeps every triangle");
        require(referee::open_edges(copy) == referee::open_edges(mesh), backend->name() + " keeps every edge");
        if (const auto* fragment = dynamic_cast<const halfedge::Fragment*>(result.object.get())) {
            const std::string fault = halfedge::check_universe(fragment->universe(), fragment->shells());
            require(fault.empty(), "the half-edge mesh is consistent (" + fault + ")");
        }
        for (const ProxyKind kind :
             {ProxyKind::box, ProxyKind::sphere, ProxyKind::bounded_hull, ProxyKind::full_hull}) {
            const CollisionProxy proxy = collision_proxy(*result.object, kind);
            for (const Triangle& t : proxy.faces)
                for (const std::uint32_t v : t)
                    require(v < proxy.points.size(), "faces of a proxy are over its points");
        }
    }
}

}  // namespace kerf::core::fuzz
