#include "linear/fragment_object.h"

#include <utility>

#include "common/cutting/back_end_helpers.h"
#include "common/mesh/mass_moments.h"
#include "common/mesh/plane_noise.h"
#include "common/mesh/support_points.h"
#include "linear/outline.h"
#include "linear/sweep.h"

namespace kerf::core::linear {

FragmentObject::FragmentObject(ProvenMesh&& mesh, const BufferListener& listener)
    : fragment_(fragment_of(std::move(mesh))), identity_(listener)
{
}

FragmentObject::FragmentObject(Fragment&& fragment, const BufferListener& listener)
    : fragment_(std::move(fragment)), identity_(listener)
{
}

DrawView FragmentObject::draw_view() const
{
    const IndexedMesh& mesh = fragment_.mesh;
    DrawView view;
    view.buffers = identity_.serial();
    view.vertices = mesh.vertices;
    static_assert(sizeof(Triangle) == 3 * sizeof(std::uint32_t));
    view.indices = {reinterpret_cast<const std::uint32_t*>(mesh.triangles.data()), mesh.triangles.size() * 3};
    view.materials = mesh.materials;
    for (const TriangleGroup& group : mesh.groups)
        view.ranges.push_back({3 * group.first, 3 * group.count, group.material, group.kind});
    merge_ranges(view.ranges);
    for (const VertexStream& stream : mesh.streams)
        view.streams.push_back({stream.name, stream.width, {stream.values.data(), stream.values.size()}});
    if (!is_uploaded_) {
        view.new_vertex_bytes.push_back({0, view.vertices.size_bytes()});
        view.new_index_bytes.push_back({0, view.indices.size_bytes()});
    }
    return view;
}

MassProperties FragmentObject::mass_properties() const
{
    const glm::dvec3 reference = mass_reference(fragment_.bounds);
    return mass_moments(fragment_.mesh.vertices, fragment_.mesh.triangles, reference).properties(reference);
}

std::array<glm::vec3, kSupportDirections> FragmentObject::support_points() const
{
    return core::support_points(fragment_.mesh.vertices);
}

std::uint32_t FragmentObject::add_material(const Material& material)
{
    fragment_.mesh.materials.push_back(material);
    return static_cast<std::uint32_t>(fragment_.mesh.materials.size() - 1);
}

void FragmentObject::find_section(const Plane& plane, PlaneSection& section) const
{
    find_outline(fragment_, plane, section);
}

std::unique_ptr<StackSearch> FragmentObject::search_stack(const glm::dvec3& normal, std::span<const double> offsets,
                                                          const ProgressOfStep& progress) const
{
    return sweep(fragment_, normal, offsets, progress);
}

Fragment fragment_of(ProvenMesh&& mesh)
{
    Fragment fragment;
    fragment.bounds = mesh.bounds();
    fragment.mesh = *std::move(mesh);
    fragment.noise = plane_noise(fragment.bounds.largest_coordinate());
    return fragment;
}

}  // namespace kerf::core::linear
