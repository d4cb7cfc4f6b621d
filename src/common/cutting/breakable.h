#pragma once

#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <memory>
#include <span>
#include <vector>

#include "common/cutting/cut.h"
#include "common/mesh/box.h"
#include "common/mesh/index.h"
#include "common/mesh/indexed_mesh.h"
#include "common/mesh/triangle_search.h"

// An object that is broken into the cells of points without a look at all of its triangles. What lies inside one cell as
// a whole part of its tree is set aside; the rest, the border, is a mesh to divide.

namespace kerf::core {

/// What closes a piece that gets parts of a tree as they are.
struct PieceBorder
{
    std::uint32_t cell = 0;
    std::uint32_t solid = 0;
    std::vector<std::uint32_t> kept;  ///< triangles of the border that it gets as they are, ascending
    /// Its new triangles: `surface_count` parts of others, which lie in several cells, then caps. Each edge has two, or one
    /// and the side of a triangle that stays as it is.
    IndexedMesh mesh;
    std::uint32_t surface_count = 0;
    std::vector<std::uint32_t> divided;     ///< for each part the triangle of the border; ascending
    std::vector<std::uint32_t> old_vertex;  ///< for each vertex that of the border, or kNone
    std::vector<std::uint32_t> old_point;   ///< for each point that of the border, or kNone
    /// For each half-edge of `mesh` (3 * triangle + corner) the one along the same points the other way. kNone: it is a
    /// whole side of the divided triangle.
    std::vector<std::uint32_t> opposite;
};

/// A copy of an object, on its way to being pieces. Shares nothing with the object.
class Breakable : public TriangleSearch
{
public:
    /// The cell that a box lies in, however its points round, or kNone.
    using CellOfBox = std::function<std::uint32_t(const Box&)>;

    /// What of a cell was set aside.
    struct Whole
    {
        std::uint64_t triangles = 0;
        double volume = 0.0;                ///< below them, seen from reference(); cubed units of the mesh
        std::vector<std::uint32_t> shells;  ///< that they are of
        bool is_known = true;               ///< that their shells are connected, and their volume
    };

    /// Sets aside what lies in one cell as a whole, and fills the border with the rest. O(b log(n / b)) boxes for b leaves
    /// of the tree in the border. Can be called again. May throw std::bad_alloc.
    virtual void divide(std::size_t cells, const CellOfBox& cell_of) = 0;

    virtual const Whole& whole_of(std::uint32_t cell) const = 0;
    virtual std::uint64_t triangle_count() const = 0;
    /// Shows what was set aside of a cell: adds it to the border. O(t) for t triangles. May throw std::bad_alloc.
    virtual void show(std::uint32_t cell) = 0;

    /// Triangles that were set aside are not in it, so it is open. Its materials may be changed.
    virtual IndexedMesh& border() = 0;
    /// The shell of each triangle of the border; kNone if it is not known to be connected.
    virtual std::span<const std::uint32_t> border_shells() const = 0;
    /// Of a shell.
    virtual std::uint32_t solid_of(std::uint32_t shell) const = 0;
    /// Points of the border have smaller numbers, also when all is shown.
    virtual std::uint32_t most_points() const = 0;
    /// The point that volumes are summed about.
    virtual glm::dvec3 reference() const = 0;
    /// Of each stream of the object's vertices. O(n) if there are any.
    virtual std::vector<std::vector<double>> stream_means() const = 0;

    /// Makes objects of cells that were not shown and share buffers: each gets what was set aside of its cell, and its
    /// border. What the other cells have is gone; nothing may be asked afterwards. O(b + c) for b triangles of the border
    /// and c new ones. May throw std::bad_alloc.
    ///
    /// @param cap_material  of the border's materials
    virtual std::vector<std::unique_ptr<Cuttable>> hand_over(std::span<const PieceBorder> pieces,
                                                             std::uint32_t cap_material) = 0;
};

}  // namespace kerf::core
