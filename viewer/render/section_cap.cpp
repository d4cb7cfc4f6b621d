#include "viewer/render/section_cap.h"

#include <memory>

namespace kerf::render {

void SectionCap::set(const Object& object, const Section& section)
{
    drawn_ = {};
    bytes_ = 0;
    const std::span<const std::uint32_t> corners = section.triangles();
    if (corners.empty()) return;
    vertices_.clear();
    for (const Vec3f& p : section.points()) {
        const Vec2d place = section.frame.to_plane(Vec3d(p.x, p.y, p.z));
        const Vec3d& n = section.frame.normal;
        vertices_.push_back({p,
                             {static_cast<float>(n.x), static_cast<float>(n.y), static_cast<float>(n.z)},
                             {static_cast<float>(place.x), static_cast<float>(place.y)}});
    }
    const auto vertices = std::as_bytes(std::span<const DrawVertex>(vertices_)), indices = std::as_bytes(corners);
    // What is drawn now may still be read: the bytes go into buffers of their own.
    auto buffers = std::make_shared<SharedBuffers>(SharedBuffers{GrowingBuffer(vertices.size(), Mapping::each_write),
                                                                 GrowingBuffer(indices.size(), Mapping::each_write),
                                                                 GlVertexArray::create()});
    buffers->vertices.write(0, vertices);
    buffers->indices.write(0, indices);
    describe_vertices(*buffers);
    bytes_ = vertices.size() + indices.size();

    std::vector<Material> materials;
    for (std::size_t i = 0; i < object.material_count(); ++i) materials.push_back(object.material(i));
    materials.push_back({"cap"});
    DrawBatch batch;
    batch.material = static_cast<std::uint32_t>(materials.size() - 1);
    batch.kind = TriangleKind::cap;
    batch.look = looks_.index_of(materials, batch.material, batch.kind);
    batch.runs.add(0, static_cast<std::uint32_t>(corners.size()));
    drawn_.buffers = std::move(buffers);
    drawn_.everything = batch.runs;
    drawn_.batches.push_back(std::move(batch));
    drawn_.triangles = corners.size() / 3;
    drawn_.bounds = section.bounds;
}

}  // namespace kerf::render
