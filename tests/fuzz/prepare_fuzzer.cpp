// Anything at all as a mesh, without repair: refused in one sentence or cut rightly, by both back ends alike.

#include <array>
#include <bit>
#include <memory>
#include <string>

#include "baseline/baseline.h"
#include "common/repair/proven_mesh.h"
#include "fuzz/byte_reader.h"
#include "fuzz/fuzzers.h"
#include "fuzz/require.h"
#include "halfedge/fragment.h"
#include "halfedge/halfedge.h"
#include "support/check_universe.h"
#include "support/mesh_trial.h"
#include "support/wrong_meshes.h"

namespace kerf::core::fuzz {

namespace {

constexpr std::uint32_t kMostVertices = 40, kMostTriangles = 60;

/// Mostly what a good mesh would have there.
std::uint32_t number_from(ByteReader& bytes, std::uint32_t usual)
{
    return bytes.byte() == 0xFF ? bytes.word() : usual;
}

float float_from(ByteReader& bytes, bool any)
{
    return any && bytes.byte() >= 0xF0 ? std::bit_cast<float>(bytes.word()) : bytes.coordinate(126);
}

/// Every field out of bytes. `wild`: nothing is kept, sizes and numbers included.
IndexedMesh mesh_from(ByteReader& bytes, bool wild)
{
    IndexedMesh mesh;
    const std::uint32_t vertices = 1 + bytes.below(kMostVertices), triangles = bytes.below(kMostTriangles);
    for (std::uint32_t v = 0; v < vertices; ++v) {
        Vertex vertex{{}, {0.0f, 0.0f, 1.0f}, {0.0f, 0.0f}};
        for (int axis = 0; axis < 3; ++axis) vertex.position[axis] = float_from(bytes, wild);
        if (wild) {
            for (int axis = 0; axis < 3; ++axis) vertex.normal[axis] = float_from(bytes, true);
            for (int axis = 0; axis < 2; ++axis) vertex.uv[axis] = float_from(bytes, true);
        }
        mesh.vertices.push_back(vertex);
        mesh.points.push_back(wild && bytes.byte() >= 0xC0 ? bytes.below(vertices) : v);
    }
    mesh.point_count = wild ? number_from(bytes, vertices) : vertices;
    for (std::uint32_t t = 0; t < triangles && !bytes.empty(); ++t) {
        const auto corner = [&] { return wild ? number_from(bytes, bytes.below(vertices)) : bytes.below(vertices); };
        mesh.triangles.push_back({corner(), corner(), corner()});
        mesh.sources.push_back(wild ? number_from(bytes, t) : t);
    }
    const auto count = static_cast<std::uint32_t>(mesh.triangles.size());
    mesh.materials.resize(1 + bytes.below(3));
    const std::uint32_t split = bytes.below(count + 1);
    mesh.groups = {{0, split, 0, 0, TriangleKind::surface}, {split, count - split, 0, 0, TriangleKind::surface}};
    if (bytes.byte() % 2 == 0) mesh.streams.push_back({"heat", 1, Buffer<float>(vertices, 0.5f)});
    if (!wild) return mesh;
    for (TriangleGroup& group : mesh.groups) {
        group = {number_from(bytes, group.first), number_from(bytes, group.count),
                 number_from(bytes, bytes.below(static_cast<std::uint32_t>(mesh.materials.size()))),
                 number_from(bytes, 0), static_cast<TriangleKind>(bytes.byte() % 4)};
    }
    for (VertexStream& stream : mesh.streams) stream.width = number_from(bytes, 1);
    const auto resize = [&](auto& list) {
        if (bytes.byte() >= 0xF0) list.resize(bytes.below(80));
    };
    resize(mesh.points);
    resize(mesh.sources);
    resize(mesh.groups);
    return mesh;
}

/// A good mesh, changed in the ways that the bytes name.
IndexedMesh changed_mesh(ByteReader& bytes)
{
    test::Random random(bytes.word());
    IndexedMesh mesh = test::small_mesh(random);
    const auto changes = test::mesh_changes();
    for (std::uint32_t i = bytes.below(4); i > 0; --i) {
        const test::MeshChange& change = changes[bytes.below(static_cast<std::uint32_t>(changes.size()))];
        change.apply(mesh, random);
        // What breaks a promise may leave nothing for the next change to work on.
        if (change.verdict != test::Verdict::cut) break;
    }
    return mesh;
}

}  // namespace

void fuzz_prepare(Bytes input)
{
    ByteReader bytes(input);
    const std::uint8_t setting = bytes.byte();
    test::Random random(bytes.word());
    const IndexedMesh mesh = setting % 4 == 0 ? changed_mesh(bytes) : mesh_from(bytes, setting % 4 == 1);
    const std::array<std::unique_ptr<Backend>, 2> backends{
        baseline::make_back_end(static_cast<baseline::VertexLookup>((setting >> 4) % 4)), halfedge::make_back_end()};
    const test::MeshTrial trial = test::try_mesh(mesh, backends, random);
    if (!trial.refusal.empty()) return;
    const PrepareResult prepared = backends[1]->prepare(mesh);
    const auto* fragment = dynamic_cast<const halfedge::Fragment*>(prepared.object.get());
    require(fragment != nullptr, "what was prepared once is prepared again");
    const std::string fault = halfedge::check_universe(fragment->universe(), fragment->shells());
    require(fault.empty(), "the half-edge mesh is consistent (" + fault + ")");
}

}  // namespace kerf::core::fuzz
