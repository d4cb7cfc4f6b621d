#pragma once

#include <span>
#include <vector>

#include "common/cutting/breakable.h"
#include "halfedge/handover/border.h"
#include "halfedge/universe/universe.h"

namespace kerf::core::halfedge {

/// Sews borders of pieces into the half-edge mesh: adds their new points, vertices, edges and faces. Where a new triangle
/// has a whole side of a divided one it takes over the half-edge of that, so that what lies beyond need not be touched.
class Sewing
{
public:
    /// Finds the half-edges that are taken over, before any of them is. O(c) for c new triangles.
    Sewing(const Universe& universe, const Border& border, std::span<const PieceBorder> pieces);

    /// Makes room for all that run() adds. May throw std::bad_alloc.
    void make_room(Universe& universe) const;
    /// Can't fail. The new triangles of the pieces, one piece after the other, are faces from the first new one on.
    void run(Universe& universe) const;

    /// The index buffer's triangle and the face of new triangle `t` of piece `p`.
    Triangle triangle(std::size_t p, std::size_t t) const;
    FaceId face(std::size_t p, std::size_t t) const { return FaceId(int(places_[p].face + t)); }

private:
    /// Where what is new of a piece begins.
    struct Place
    {
        std::size_t point = 0, vertex = 0, edge = 0, face = 0;
        std::size_t halfedge = 0;  ///< in halfedges_
    };

    HalfedgeId taken_over(const Border& border, const PieceBorder& piece, std::size_t halfedge) const;
    void sew(Universe& universe, std::size_t p) const;
    void add_vertices(Universe& universe, std::size_t p) const;

    const Universe& u_;
    std::span<const PieceBorder> pieces_;
    std::vector<Place> places_;          ///< of the pieces, and the end
    std::vector<HalfedgeId> halfedges_;  ///< of their triangles
    std::vector<Index> vertices_;        ///< of the universe, for the vertices of all pieces
    std::vector<PointId> points_;        ///< the same for points
    std::vector<std::size_t> first_vertex_, first_point_;
};

}  // namespace kerf::core::halfedge
