#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "common/cutting/cut_geometry.h"
#include "common/cutting/plane_section.h"
#include "linear/fragment.h"
#include "linear/section.h"
#include "linear/vertex_sides.h"

namespace kerf::core::linear {

/// What a plane does to the triangles of a fragment, as far as a section asks: which it crosses, which have edges in it.
/// Keeps its memory.
struct SortedTriangles
{
    Crossings crossings;
    BySide<std::vector<EdgeInPlane>> edges_in_plane;
    BySide<bool> keeps{};  ///< whether a side keeps a triangle as it is

    void clear();

    /// Notes a triangle; `class_of(vertex)` says where its corners lie (vertex_sides.h). They must come in the order in
    /// which a cut goes through them.
    template <class ClassOf>
    void add(const IndexedMesh& mesh, const Plane& plane, std::uint32_t triangle, std::uint32_t group, ClassOf class_of)
    {
        const Triangle& t = mesh.triangles[triangle];
        const std::array<std::uint8_t, 3> of{class_of(t[0]), class_of(t[1]), class_of(t[2])};
        const auto joined = static_cast<std::uint8_t>(of[0] | of[1] | of[2]);
        if (joined == kCrossing) {
            crossings.triangles.push_back({triangle, group, 0, 0, {}});
            return;
        }
        Side side = joined == kBelow ? Side::negative : Side::positive;
        if (joined == kOn)
            side = coplanar_side(plane, mesh.vertices[t[0]].position, mesh.vertices[t[1]].position,
                                 mesh.vertices[t[2]].position);
        keeps[side] = true;
        if (of[0] != kOn && of[1] != kOn && of[2] != kOn) return;
        for (std::uint8_t corner = 0; corner < 3; ++corner)
            if (of[corner] == kOn && of[(corner + 1u) % 3] == kOn)
                edges_in_plane[side].push_back({triangle, group, corner});
    }
};

/// From sorted triangles to the outline. Keeps its memory.
class OutlineFinder final : public PlaneSection::Scratch
{
public:
    /// That of a section, which gets one if it has none. May throw std::bad_alloc.
    static OutlineFinder& of(PlaneSection& section);

    SortedTriangles& sorted() { return sorted_; }
    VertexSides& classes() { return classes_; }
    std::vector<std::uint32_t>& group_order() { return group_order_; }

    /// Fills a section that is clear from what is sorted. O(k) expected. May throw std::bad_alloc.
    void finish(const IndexedMesh& mesh, const Plane& plane, PlaneSection& section);

private:
    const DividedOutline& divide(const Plane& plane);
    void copy_paths(const DividedOutline& divided, PlaneSection& to) const;
    void add_ends(const IndexedMesh& mesh, const Plane& plane, const DividedOutline& divided,
                  PlaneSection& section) const;

    SortedTriangles sorted_;
    VertexSides classes_;
    std::vector<std::uint32_t> group_order_;
    SectionFinder finder_;
    Section found_;
    std::vector<std::uint64_t> solids_;
    std::vector<OutlineEdge> outline_;
    std::vector<glm::vec3> positions_;
    OutlineDivider divider_;
};

/// The groups of a mesh in the order in which a cut goes through them.
void order_groups(const IndexedMesh& mesh, std::vector<std::uint32_t>& order);

/// The outline of a section without a cut: the steps of the Slicer (slicing_steps.h) that find it, and no copy of what
/// the plane does not cross. What it needs it keeps in the section. O(n). May throw std::bad_alloc.
///
/// @param section  clear
void find_outline(const Fragment& whole, const Plane& plane, PlaneSection& section);

}  // namespace kerf::core::linear
