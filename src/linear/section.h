#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "common/caps/outline_loops.h"
#include "common/cutting/cut.h"
#include "common/geometry/pair_table.h"
#include "linear/crossing.h"

// The baseline's section: outline edges of its crossing triangles, linked into paths.

namespace kerf::core::linear {

/// A point of the section's outline: a point that existed before the cut, or a new one.
struct SectionPoint
{
    glm::vec3 position;
    std::uint32_t existing;   ///< point id in the mesh before the cut, or kNone
    std::uint32_t cut_point;  ///< if not existing: the id of its class of cut points
};

/// An edge of the outline, directed as it runs in the surface of the positive side.
struct SectionEdge
{
    std::uint32_t from, to;  ///< section points
    std::uint32_t
        crossing;  ///< the crossing triangle that it divides, or kNone for an edge of the mesh that lies in the plane
    std::uint32_t triangle;               ///< the triangle it was found in
    std::uint8_t from_corner, to_corner;  ///< its ends as corner codes of that triangle
    std::uint32_t solid;
    std::uint32_t source;  ///< of the triangle; of an edge in the plane the smaller one of the triangles at it, so that
                           ///< a flipped plane has the same
    std::uint32_t material = 0;  ///< of the triangle; of an edge in the plane that of one on the negative side
};

/// The section: every edge between a triangle kept on one side and a triangle kept on the other.
struct Section
{
    std::vector<SectionPoint> points;
    std::vector<SectionEdge> edges;
    bool has_cancelled_edges = false;  ///< some ran forth and back, and are gone

    void clear()
    {
        points.clear();
        edges.clear();
        has_cancelled_edges = false;
    }
};

/// A polyline of section edges that visits no point twice.
struct SectionPath
{
    std::vector<std::uint32_t> edges;  ///< in order, each starting where the one before ends
    bool closed = true;                ///< false: a chain that ends at the boundary of an open mesh
};

/// A directed edge of an untouched triangle whose ends are both exactly on the plane; `corner` is where it starts.
struct EdgeInPlane
{
    std::uint32_t triangle;
    std::uint32_t group;
    std::uint8_t corner;
};

/// The section in the form of the common code, without the parts that it bounds.
/// @{
std::vector<OutlineEdge> outline_of(const Section& section);
void list_outline(const Section& section, std::vector<OutlineEdge>& outline);
/// @}

/// The positions of the section's points.
/// @{
std::vector<glm::vec3> positions_of(const Section& section);
void list_positions(const Section& section, std::vector<glm::vec3>& positions);
/// @}

/// Collects outlines. Keeps its memory.
class SectionFinder
{
public:
    /// Fills `section` from the crossing triangles and from the edges in the plane of both sides. Edges that run forth
    /// and back cancel. O(k) expected. May throw std::bad_alloc.
    void find(const IndexedMesh& mesh, Crossings& crossings, std::span<const EdgeInPlane> in_plane_of_negative,
              std::span<const EdgeInPlane> in_plane_of_positive, Section& section);

private:
    /// An edge in the plane as it runs on the positive side, with what is known of all triangles at it.
    struct SectionEdgeInPlane
    {
        EdgeInPlane edge;
        std::uint32_t source;    ///< the least
        std::uint32_t material;  ///< of the one on the negative side with the least source
    };
    /// What is known of an edge in the plane.
    struct Row
    {
        std::int32_t below = 0, above = 0;       ///< edges that ascend less those that do not
        std::uint32_t source = kNoSource;        ///< the least
        std::uint32_t source_below = kNoSource;  ///< the least on the negative side
        std::uint32_t group_below = kNone;       ///< and its group
    };

    void pair_edges_in_plane(const IndexedMesh& mesh, std::span<const EdgeInPlane> negative,
                             std::span<const EdgeInPlane> positive);
    Row& row_of(const IndexedMesh& mesh, const EdgeInPlane& edge, std::int32_t& direction);
    void cancel_opposite_edges(Section& section);

    std::vector<std::uint32_t> of_cut_point_;  ///< the section point at each class of cut points
    PairTable of_existing_;                    ///< that at points of the mesh, each by its number twice
    PairTable row_at_;                         ///< by the edge's points, the smaller one first
    std::vector<Row> rows_;
    std::vector<SectionEdgeInPlane> in_plane_;
    std::vector<OutlineEdge> outline_;
    OppositeEdges opposite_;
};

/// The same, once.
Section find_section(const IndexedMesh& mesh, Crossings& crossings, std::span<const EdgeInPlane> in_plane_of_negative,
                     std::span<const EdgeInPlane> in_plane_of_positive);

/// Links edges into simple loops and chains, as divide_outline() does; only edges of equal tag follow one another.
/// `tags` has one entry per edge. O(k log k).
std::vector<SectionPath> link_paths(const Plane& plane, const Section& section, std::span<const std::uint64_t> tags);

/// The area of the closed paths among these, by section_area().
double area_of(const Section& section, std::span<const SectionPath> paths, const Plane& plane);

/// The path in the form of the contract.
SectionLoop to_loop(const Section& section, const SectionPath& path);

}  // namespace kerf::core::linear
