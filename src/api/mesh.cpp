#include <kerf/mesh.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <new>
#include <stdexcept>
#include <string>

#include "api/convert.h"
#include "api/mesh_data.h"
#include "api/no_memory.h"
#include "common/mesh/coordinate_grain.h"
#include "common/repair/repair.h"

namespace kerf {

namespace {

constexpr const char* kNoMemoryForMesh = "there is not enough memory for the mesh; divide it or free some";
constexpr std::size_t kWidestStream = 16;

/// Reads element i of an array of floats with a stride.
template <std::size_t kWidth>
void read(const float* first, std::size_t stride, std::size_t i, float* to)
{
    std::memcpy(to, reinterpret_cast<const char*>(first) + i * stride, kWidth * sizeof(float));
}

/// Empty, or one sentence that names the first fault of the arrays themselves. repair() looks at what is in them.
bool strides_over(const MeshInput& input, std::size_t stride, std::size_t floats) noexcept
{
    return stride >= floats * sizeof(float) && stride <= std::size_t{PTRDIFF_MAX} / input.vertex_count;
}

}  // namespace

bool has_right_strides(const MeshInput& input) noexcept
{
    return input.vertex_count == 0 || (strides_over(input, input.position_stride, 3) &&
                                       (input.normals == nullptr || strides_over(input, input.normal_stride, 3)) &&
                                       (input.uvs == nullptr || strides_over(input, input.uv_stride, 2)));
}

namespace {

std::string fault_of(const MeshInput& input)
{
    if (input.positions == nullptr || input.vertex_count == 0) return "there are no positions; give some";
    if (input.triangle_count == 0) return "the mesh has no triangles; give it one at least";
    if (input.vertex_count >= kNone) return "the mesh has more than 2^32 - 2 vertices; divide it into several";
    if (input.triangle_count > kNone / 3) return "the mesh has more than 2^32 corners; divide it into several";
    if (input.indices == nullptr && 3 * input.triangle_count != input.vertex_count)
        return "without indices each three vertices are a triangle, but there are " +
               std::to_string(input.vertex_count) + " vertices and " + std::to_string(input.triangle_count) +
               " triangles";
    if (!has_right_strides(input))
        return "a stride is shorter than what it strides over, or leads out of memory; it counts bytes, not numbers";
    if (!(input.crease_degrees >= 0.0f && input.crease_degrees <= 180.0f))
        return "the angle of creases is not 0 to 180 degrees; 40 is usual";
    for (const StreamInput& stream : input.streams)
        if (stream.values == nullptr || stream.width == 0 || stream.width > kWidestStream)
            return "a stream has no values, or not 1 to 16 a vertex; complete it or leave it out";
    for (const StreamInput& stream : input.streams)
        if (stream.stride != 0 && !strides_over(input, stream.stride, stream.width))
            return "the stride of a stream is shorter than its values, or leads out of memory; it counts bytes";
    return {};
}

core::TriangleSoup soup_of(const MeshInput& input)
{
    core::TriangleSoup soup;
    soup.has_normals = input.normals != nullptr;
    soup.crease_degrees = static_cast<double>(input.crease_degrees);
    soup.vertices.resize(input.vertex_count);
    for (std::size_t v = 0; v < input.vertex_count; ++v) {
        core::Vertex& vertex = soup.vertices[v];
        vertex = {};
        read<3>(input.positions, input.position_stride, v, &vertex.position.x);
        if (input.normals != nullptr) read<3>(input.normals, input.normal_stride, v, &vertex.normal.x);
        if (input.uvs != nullptr) read<2>(input.uvs, input.uv_stride, v, &vertex.uv.x);
    }
    soup.triangles.resize(input.triangle_count);
    for (std::size_t t = 0; t < input.triangle_count; ++t)
        for (std::size_t i = 0; i < 3; ++i)
            soup.triangles[t][i] =
                input.indices != nullptr ? input.indices[3 * t + i] : static_cast<std::uint32_t>(3 * t + i);
    if (input.triangle_materials != nullptr)
        soup.triangle_materials.assign(input.triangle_materials, input.triangle_materials + input.triangle_count);
    for (const Material& material : input.materials) soup.materials.push_back(to_core(material));
    for (const StreamInput& stream : input.streams) {
        core::VertexStream& to = soup.streams.emplace_back();
        to.name = stream.name != nullptr ? stream.name : "";
        to.width = stream.width;
        to.values.resize(std::size_t{stream.width} * input.vertex_count);
        const std::size_t bytes = stream.width * sizeof(float), stride = stream.stride != 0 ? stream.stride : bytes;
        for (std::size_t v = 0; v < input.vertex_count; ++v)
            std::memcpy(&to.values[v * stream.width], reinterpret_cast<const char*>(stream.values) + v * stride, bytes);
        // As files are read.
        std::replace_if(
            to.values.begin(), to.values.end(), [](float value) { return !std::isfinite(value); }, 0.0f);
    }
    return soup;
}

MeshFacts facts_of(const core::MeshFacts& facts)
{
    MeshFacts result;
    result.triangles = facts.triangles;
    result.vertices = facts.vertices;
    result.points = facts.welded_vertices;
    result.degenerate_triangles = facts.degenerate_triangles;
    result.duplicate_triangles = facts.duplicate_triangles;
    result.has_coarse_coordinates = facts.has_coarse_coordinates();
    result.boundary_edges = facts.boundary_edges;
    result.boundary_loops = facts.boundary_loops;
    result.open_edges = facts.open_edges;
    result.nonmanifold_edges = facts.nonmanifold_edges;
    result.nonmanifold_points = facts.nonmanifold_points;
    result.misoriented_edges = facts.misoriented_edges;
    result.unbalanced_edges = facts.unbalanced_edges;
    result.shells = facts.shells;
    result.shortest_edge = facts.shortest_edge;
    result.area = facts.area;
    result.volume = facts.volume;
    result.bounds = to_public(facts.bounds);
    return result;
}

}  // namespace

MeshReport report_of(const core::MeshFacts& facts, const core::Repairs& repairs)
{
    return {facts_of(facts),
            {repairs.degenerate_triangles, repairs.duplicate_triangles, repairs.coinciding_triangles,
             repairs.nonmanifold_edges, repairs.nonmanifold_points, repairs.flipped_triangles,
             repairs.unorientable_edges, repairs.replaced_attributes}};
}

Sentence describe(const Repairs& r) noexcept
{
    return answer_or(Sentence(), [&] {
        const core::Repairs inside{r.degenerate_triangles, r.duplicate_triangles, r.coinciding_triangles,
                                   r.nonmanifold_edges,    r.nonmanifold_points,  r.flipped_triangles,
                                   r.unorientable_edges,   r.replaced_attributes};
        return Sentence(inside.describe().c_str());
    });
}

Result<Mesh> Mesh::make(const MeshInput& input, MeshReport* report) noexcept
{
    if (report != nullptr) *report = {};
    try {
        if (const std::string fault = fault_of(input); !fault.empty())
            return {Status::invalid_mesh, Sentence(fault.c_str())};
        core::Repaired repaired =
            core::repair(soup_of(input), report != nullptr ? core::FactsWanted::all : core::FactsWanted::none);
        if (report != nullptr) *report = report_of(repaired.facts, repaired.repairs);
        if (!repaired.error.empty()) return {Status::invalid_mesh, Sentence(repaired.error.c_str())};
        return Mesh(new Data(std::move(repaired.mesh)));
    } catch (const std::bad_alloc&) {
        return {Status::out_of_memory, Sentence(kNoMemoryForMesh)};
    } catch (const std::length_error&) {
        return {Status::out_of_memory, Sentence(kNoMemoryForMesh)};
    }
}

namespace {

/// The same triangles with the same sources, joined as those of a file are. Half-edges know how surfaces go on that lie on
/// one another, back to back; the arrays of a piece do not.
core::Proof joined_anew(const core::IndexedMesh& mesh)
{
    // A material for each group, so that each triangle keeps its own.
    core::TriangleSoup soup{mesh.vertices, mesh.triangles, {}, mesh.streams, {}};
    for (const core::TriangleGroup& group : mesh.groups) {
        soup.triangle_materials.insert(soup.triangle_materials.end(), group.count,
                                       static_cast<std::uint32_t>(soup.materials.size()));
        soup.materials.push_back(mesh.materials[group.material]);
    }
    core::Repaired repaired = core::repair(std::move(soup), core::FactsWanted::none);
    if (!repaired.error.empty()) return {{}, std::move(repaired.error)};
    core::IndexedMesh joined = *std::move(repaired.mesh);
    joined.materials = mesh.materials;
    for (core::TriangleGroup& group : joined.groups) {
        group.kind = mesh.groups[group.material].kind;
        group.material = mesh.groups[group.material].material;
    }
    for (std::uint32_t& source : joined.sources) source = mesh.sources[source];
    return core::prove(std::move(joined));
}

}  // namespace

core::PrepareResult Mesh::Data::prepare(const core::Backend& back_end, const core::PrepareOptions& options,
                                        bool is_last_owner)
{
    if (is_proven_)
        return is_last_owner ? back_end.prepare(std::move(proven_), options) : back_end.prepare(proven_, options);
    core::Proof proof = core::prove(core::IndexedMesh(plain_));
    if (!proof.error.empty()) proof = joined_anew(plain_);
    if (!proof.error.empty()) return {core::Status::invalid_mesh, nullptr, std::move(proof.error), false};
    if (is_last_owner) plain_ = core::IndexedMesh();
    return back_end.prepare(std::move(proof.mesh), options);
}

bool Mesh::Data::is_closed() const
{
    if (!is_proven_) return core::measure(plain_).boundary_edges == 0;
    return proven_.is_closed();
}

bool Mesh::Data::has_coarse_coordinates() const
{
    if (!is_proven_) return core::measure(plain_).has_coarse_coordinates();
    return core::has_coarse_coordinates(proven_.shortest_edge(), proven_.bounds());
}

Mesh::Mesh(const Mesh& other) noexcept : data_(other.data_)
{
    if (data_ != nullptr) data_->add_owner();
}

Mesh::Mesh(Mesh&& other) noexcept : data_(std::exchange(other.data_, nullptr)) {}

Mesh& Mesh::operator=(Mesh other) noexcept
{
    std::swap(data_, other.data_);
    return *this;
}

Mesh::~Mesh()
{
    if (data_ != nullptr && data_->remove_owner()) delete data_;
}

Result<Mesh> Mesh::clone() const noexcept
{
    if (is_empty()) return {Status::invalid_mesh, Sentence("the mesh is empty; make one with Mesh::make()")};
    return result_of<Mesh>(kNoMemoryForMesh, [&]() -> Result<Mesh> { return Mesh(data_->clone()); });
}

std::uint64_t Mesh::triangle_count() const noexcept
{
    return data_ != nullptr ? data_->mesh().triangles.size() : 0;
}

std::uint64_t Mesh::vertex_count() const noexcept
{
    return data_ != nullptr ? data_->mesh().vertices.size() : 0;
}

bool Mesh::is_closed() const noexcept
{
    return data_ != nullptr && answer_or(false, [&] { return data_->is_closed(); });
}

bool Mesh::has_coarse_coordinates() const noexcept
{
    return data_ != nullptr && answer_or(false, [&] { return data_->has_coarse_coordinates(); });
}

Box Mesh::bounds() const noexcept
{
    return to_public(data_ != nullptr ? data_->bounds() : core::Box());
}

MeshArrays Mesh::arrays() const noexcept
{
    return data_ != nullptr ? data_->arrays_made() : MeshArrays();
}

std::size_t Mesh::stream_count() const noexcept
{
    return data_ != nullptr ? data_->mesh().streams.size() : 0;
}

Stream Mesh::stream(std::size_t i) const noexcept
{
    if (i >= stream_count()) return {};
    const core::VertexStream& stream = data_->mesh().streams[i];
    return {stream.name.c_str(), stream.width, stream.values};
}

std::size_t Mesh::material_count() const noexcept
{
    return data_ != nullptr ? data_->mesh().materials.size() : 0;
}

Material Mesh::material(std::size_t i) const noexcept
{
    return i < material_count() ? to_public(data_->mesh().materials[i]) : Material();
}

const MeshArrays& Mesh::Data::arrays_made() const noexcept
{
    if (is_made_.load(std::memory_order_acquire)) return arrays_;
    static const MeshArrays none;
    const std::lock_guard lock(mutex_);
    if (is_made_.load(std::memory_order_relaxed)) return arrays_;
    try {
        make_arrays();
    } catch (const std::bad_alloc&) {
        return none;
    } catch (const std::length_error&) {
        return none;
    }
    is_made_.store(true, std::memory_order_release);
    return arrays_;
}

void Mesh::Data::make_arrays() const
{
    const core::IndexedMesh& mesh = this->mesh();
    const std::size_t vertices = mesh.vertices.size(), triangles = mesh.triangles.size();
    positions_.resize(vertices);
    normals_.resize(vertices);
    uvs_.resize(vertices);
    for (std::size_t v = 0; v < vertices; ++v) {
        positions_[v] = to_public(mesh.vertices[v].position);
        normals_[v] = to_public(mesh.vertices[v].normal);
        uvs_[v] = {mesh.vertices[v].uv.x, mesh.vertices[v].uv.y};
    }
    kinds_.resize(triangles);
    materials_.resize(triangles);
    solids_.resize(triangles);
    for (const core::TriangleGroup& group : mesh.groups)
        for (std::size_t t = group.first; t < std::size_t{group.first} + group.count; ++t) {
            kinds_[t] = static_cast<TriangleKind>(group.kind);
            materials_[t] = group.material;
            solids_[t] = group.solid;
        }
    const std::span<const std::uint32_t> indices(triangles > 0 ? mesh.triangles[0].data() : nullptr, 3 * triangles);
    arrays_ = {positions_, normals_,     uvs_,   mesh.points, mesh.point_count,
               indices,    mesh.sources, kinds_, materials_,  solids_};
}

}  // namespace kerf
