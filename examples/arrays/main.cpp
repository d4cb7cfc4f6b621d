// Arrays in, arrays out: a program's own vertices become a mesh, and its pieces become such vertices again.

#include <kerf/kerf.h>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <vector>

namespace {

/// A vertex as this program has it. Kerf reads it where it lies.
struct GameVertex
{
    float position[3];
    float colour[4];
};

struct GameMesh
{
    std::vector<GameVertex> vertices;
    std::vector<std::uint32_t> indices;
};

/// A cube whose colours follow its corners.
GameMesh cube()
{
    GameMesh mesh;
    for (int i = 0; i < 8; ++i) {
        const float x = (i & 1) != 0 ? 1.0f : -1.0f, y = (i & 2) != 0 ? 1.0f : -1.0f, z = (i & 4) != 0 ? 1.0f : -1.0f;
        mesh.vertices.push_back({{x, y, z}, {0.5f + 0.5f * x, 0.5f + 0.5f * y, 0.5f + 0.5f * z, 1.0f}});
    }
    mesh.indices = {0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4,
                    2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5};
    return mesh;
}

/// Where Kerf finds all that. Nothing is copied; `colours` is used by the result.
kerf::MeshInput input_of(const GameMesh& mesh, kerf::StreamInput& colours)
{
    colours.name = "colour";
    colours.values = mesh.vertices[0].colour;
    colours.width = 4;
    colours.stride = sizeof(GameVertex);

    kerf::MeshInput input;
    input.positions = mesh.vertices[0].position;
    input.position_stride = sizeof(GameVertex);
    input.vertex_count = mesh.vertices.size();
    input.indices = mesh.indices.data();
    input.triangle_count = mesh.indices.size() / 3;
    input.streams = {&colours, 1};
    return input;
}

GameMesh from_kerf(const kerf::Mesh& mesh)
{
    const kerf::MeshArrays arrays = mesh.arrays();
    const std::span<const float> colours = mesh.stream(0).values;
    GameMesh result;
    for (std::size_t v = 0; v < arrays.positions.size(); ++v) {
        const kerf::Vec3f& p = arrays.positions[v];
        result.vertices.push_back(
            {{p.x, p.y, p.z}, {colours[4 * v], colours[4 * v + 1], colours[4 * v + 2], colours[4 * v + 3]}});
    }
    result.indices.assign(arrays.indices.begin(), arrays.indices.end());
    return result;
}

/// The height of each vertex of a piece, from those of the cube's corners: as the piece would have it if the height were
/// something that Kerf knows nothing of. Returns how far one is off, or -1 if the piece is none of the cube's.
float height_from_corners(const kerf::Mesh& piece, const GameMesh& cube, const kerf::MeshInput& input)
{
    const std::span<const kerf::Vec3f> positions = piece.arrays().positions;
    std::vector<kerf::VertexOrigin> origins(positions.size());
    if (kerf::vertex_origins(piece, input, origins) != kerf::Status::done) return -1.0f;
    float worst = 0.0f;
    for (std::size_t v = 0; v < origins.size(); ++v) {
        if (origins[v].vertices[0] == kerf::kNone) continue;  // of a cap
        float height = 0.0f;
        for (int i = 0; i < 3; ++i)
            if (origins[v].weights[i] != 0.0f)
                height += origins[v].weights[i] * cube.vertices[origins[v].vertices[i]].position[2];
        worst = std::fmax(worst, std::fabs(height - positions[v].z));
    }
    return worst;
}

}  // namespace

int main()
{
    const GameMesh given = cube();
    kerf::StreamInput given_colours;
    const kerf::MeshInput input = input_of(given, given_colours);
    const kerf::Result<kerf::Mesh> mesh = kerf::Mesh::make(input);
    if (!mesh) return std::fprintf(stderr, "%s\n", mesh.reason()), 1;

    // One cut of a mesh that is not kept: the linear back end has next to nothing to prepare.
    kerf::PrepareOptions once;
    once.cuts_expected = 1;
    kerf::Result<kerf::Object> object = kerf::prepare(*mesh, once);
    if (!object) return std::fprintf(stderr, "%s\n", object.reason()), 1;
    kerf::Cut cut = kerf::cut(*std::move(object), *kerf::Plane::at(kerf::Point(0, 0, 0.25), kerf::Normal(0, 1, 2)));

    for (const kerf::Side side : {kerf::Side::positive, kerf::Side::negative}) {
        const kerf::Object* const half = cut.one(side);
        if (half == nullptr) return std::fprintf(stderr, "not cut: %s\n", kerf::outcome_name(cut.status)), 1;
        const kerf::Result<kerf::Mesh> piece = half->mesh();
        if (!piece) return std::fprintf(stderr, "%s\n", piece.reason()), 1;
        const GameMesh game = from_kerf(*piece);

        // Colours of the surface were interpolated: they still follow the corners. Caps are Kerf's own triangles.
        // Every other triangle says which of the cube's twelve it was.
        std::size_t caps = 0;
        std::uint32_t faces = 0;
        float worst = 0.0f;
        const kerf::MeshArrays arrays = piece->arrays();
        for (std::size_t t = 0; t < arrays.kinds.size(); ++t) {
            if (arrays.kinds[t] == kerf::TriangleKind::cap) {
                ++caps;
                continue;
            }
            faces |= 1u << (arrays.sources[t] / 2);
            for (std::size_t c = 0; c < 3; ++c) {
                const GameVertex& v = game.vertices[arrays.indices[3 * t + c]];
                for (int axis = 0; axis < 3; ++axis) {
                    const float off = v.colour[axis] - (0.5f + 0.5f * v.position[axis]);
                    worst = std::fmax(worst, std::fabs(off));
                }
            }
        }
        const float height_off = height_from_corners(*piece, given, input);
        std::printf("%zu vertices, %zu triangles, %zu of them cap; colours off by %g, heights by %g; faces:",
                    game.vertices.size(), game.indices.size() / 3, caps, static_cast<double>(worst),
                    static_cast<double>(height_off));
        for (int face = 0; face < 6; ++face)
            if ((faces & (1u << face)) != 0) std::printf(" %d", face);
        std::printf("\n");
        if (caps == 0 || worst > 1e-6f || height_off < 0.0f || height_off > 1e-6f) return 1;
    }
}
