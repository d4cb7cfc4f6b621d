#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "common/cutting/status.h"
#include "common/mesh/indexed_mesh.h"
#include "common/mesh/side.h"

// What a plane meets of an object that it does not cut.

namespace kerf::core {

/// The section of an object: what cut() without CutOptions::split_components would give as section_loops(), bit for bit,
/// and where its edges come from. It keeps its memory when it is filled again.
struct PlaneSection
{
    /// The triangle that an edge of a section lies in: of two, if the edge is one of the mesh in the plane, the one that a
    /// cut would keep on the negative side.
    struct Edge
    {
        std::uint32_t source = 0;    ///< IndexedMesh::sources of the triangle; the smaller one of two
        std::uint32_t material = 0;  ///< index in Cuttable::materials()
    };

    /// A closed loop of a section, or a chain that ends at the boundary of an open mesh. Edge i leads from point i to the
    /// next one, and the last edge of a loop to its first point.
    struct Path
    {
        std::size_t first_point = 0, point_count = 0;  ///< in `points`
        std::size_t first_edge = 0, edge_count = 0;    ///< in `edges`: as many as points; of a chain one less
        std::uint32_t solid = 0;
        bool closed = true;
        /// Once they were asked for (sections/section_measures.h):
        /// @{
        double area = 0.0;    ///< of a loop, negative of a hole; mesh units squared
        double length = 0.0;  ///< mesh units
        /// @}
    };

    /// A stream of the object along the outline.
    struct EndStream
    {
        std::string name;
        std::uint32_t width = 1;
        std::vector<float> values;  ///< `width` for each of `ends`
    };

    /// What a back end needs to find a section, so that the next one takes no memory.
    class Scratch
    {
    public:
        virtual ~Scratch() = default;

    protected:
        Scratch() = default;
        Scratch(const Scratch&) = default;
        Scratch& operator=(const Scratch&) = default;
    };

    Status status = Status::missed;  ///< done, missed or open_section, as of a cut; invalid_argument, out_of_memory
    Side side_of_object = Side::negative;  ///< of a miss, as of a cut
    std::vector<glm::vec3> points;         ///< in mesh coordinates, path by path
    std::vector<Edge> edges;               ///< path by path
    /// Seen from the plane's positive side an outer loop runs counter-clockwise and a hole clockwise.
    std::vector<Path> paths;
    std::uint64_t crossing_triangles = 0;  ///< with vertices strictly on both sides of the plane
    std::uint64_t nodes_visited = 0;       ///< tree nodes looked at
    std::uint64_t triangles_touched = 0;   ///< triangle records read

    /// Asked for by the caller: `ends` and `end_streams` are filled. clear() leaves it.
    bool wants_ends = false;
    std::vector<Vertex> ends;  ///< of edge i those at 2 i and 2 i + 1, with the attributes that a cut gives them
    std::vector<EndStream> end_streams;  ///< for each stream of the object, if there are ends

    std::unique_ptr<Scratch> scratch;  ///< of the back end that found the last section, if it keeps any

    std::span<const glm::vec3> points_of(const Path& path) const
    {
        return std::span(points).subspan(path.first_point, path.point_count);
    }
    std::span<const Edge> edges_of(const Path& path) const
    {
        return std::span(edges).subspan(path.first_edge, path.edge_count);
    }

    /// Calls visit(i, p, q) for edge i of a path and its ends. O(edges).
    template <class Visit>
    void for_each_edge(const Path& path, Visit visit) const
    {
        const std::span<const glm::vec3> p = points_of(path);
        for (std::size_t i = 0; i < path.edge_count; ++i) visit(i, p[i], p[i + 1 < p.size() ? i + 1 : 0]);
    }

    /// One without paths, of an object of which nothing is known yet. Keeps the scratch and its memory.
    void clear()
    {
        status = Status::missed;
        side_of_object = Side::negative;
        points.clear();
        edges.clear();
        paths.clear();
        ends.clear();
        for (EndStream& stream : end_streams) stream.values.clear();
        crossing_triangles = nodes_visited = triangles_touched = 0;
    }
};

}  // namespace kerf::core
