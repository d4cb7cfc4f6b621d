#include "halfedge/universe/universe.h"

#include <utility>

namespace kerf::core::halfedge {

Universe::Universe(const Universe& other)
    : mesh(other.mesh),
      vertices(other.vertices),
      streams(other.streams),
      slots(other.slots),
      face_of_slot(other.face_of_slot),
      source_of_face(other.source_of_face),
      stamp_of_face(other.stamp_of_face),
      stamp_base(other.stamp_base),
      tree(other.tree),
      groups(other.groups),
      cap_material(other.cap_material),
      reference(other.reference),
      noise(other.noise),
      has_boundary(other.has_boundary),
      live_slots(0)
{
    set_materials(other.materials);
}

void Universe::set_materials(const std::vector<Material>& from)
{
    materials.reserve(from.size() + 1);
    materials = from;
}

void Universe::make_room_for_material()
{
    if (materials.size() < materials.capacity()) return;
    std::vector<Material> larger;
    larger.reserve(2 * (materials.size() + 1));
    larger.insert(larger.end(), materials.begin(), materials.end());
    outgrown_materials_.push_back(std::move(materials));
    materials = std::move(larger);
}

std::size_t Universe::bytes_reserved() const
{
    std::size_t bytes = mesh.bytes_reserved() + vertices.bytes_reserved() + slots.bytes_reserved() +
                        face_of_slot.bytes_reserved() + source_of_face.bytes_reserved() +
                        stamp_of_face.bytes_reserved() + tree.bytes_reserved();
    for (const Stream& stream : streams) bytes += stream.values.bytes_reserved();
    return bytes;
}

}  // namespace kerf::core::halfedge
