#include "halfedge/universe/numbering.h"

#include <algorithm>

namespace kerf::core::halfedge {

namespace {

/// How many triangles ahead memory is asked for: this pass reads all over the mesh, and its branches can't be foretold,
/// so the processor does not read ahead by itself.
constexpr std::size_t kTrianglesAhead = 12;
/// The same for what is then copied from all over the mesh.
constexpr Index kReadAhead = 16;

}  // namespace

Numbering::Numbering(const ProvenMesh& proven, std::size_t boundary)
    : mesh_(proven),
      opposite_(proven.adjacency().opposite),
      known_(opposite_.size(), HalfedgeId()),
      number_of_vertex_(mesh_.vertices.size(), kNone),
      number_of_point_(mesh_.point_count, kNone),
      old_vertex_(mesh_.vertices.size()),
      point_(mesh_.vertices.size()),
      halfedges_(mesh_.triangles.size())
{
    at_boundary_.reserve(boundary);
}

void Numbering::begin(std::span<const Index> order, Universe& universe)
{
    order_ = order;
    u_ = &universe;
}

NumberedChunk Numbering::next()
{
    NumberedChunk chunk;
    chunk.first = counts_.triangles;
    chunk.count = static_cast<Index>(std::min(order_.size() - counts_.triangles, NumberedChunk::kTriangles));
    const Index first_vertex = counts_.vertices;
    for (Index i = chunk.first; i < chunk.first + chunk.count; ++i) {
        prefetch_triangle(order_[std::min(i + 2 * kTrianglesAhead, order_.size() - 1)]);
        prefetch_neighbours(order_[std::min(i + kTrianglesAhead, order_.size() - 1)]);
        const Index old_triangle = order_[i];
        const Triangle& t = mesh_.triangles[old_triangle];
        Triangle& slot = u_->slots[SlotId(i)];
        for (std::size_t c = 0; c < 3; ++c) {
            slot[c] = vertex(t[c]);
            halfedges_[i][c] = halfedge(3 * old_triangle + Index(c));
        }
    }
    write_faces(chunk);
    write_vertices(first_vertex, counts_.vertices);
    counts_.triangles += chunk.count;
    chunk.vertices = counts_.vertices;
    chunk.points = counts_.points;
    chunk.edges = counts_.edges;
    return chunk;
}

void Numbering::prefetch_triangle(Index old_triangle) const
{
    __builtin_prefetch(&mesh_.triangles[old_triangle]);
    __builtin_prefetch(&opposite_[std::size_t{3} * old_triangle]);
    __builtin_prefetch(&known_[std::size_t{3} * old_triangle]);
}

void Numbering::prefetch_neighbours(Index old_triangle) const
{
    for (std::size_t c = 0; c < 3; ++c) {
        __builtin_prefetch(&number_of_vertex_[mesh_.triangles[old_triangle][c]]);
        const Index across = opposite_[std::size_t{3} * old_triangle + c];
        if (across != kNone) __builtin_prefetch(&known_[across], 1);
    }
}

Index Numbering::vertex(Index old_vertex)
{
    Index& number = number_of_vertex_[old_vertex];
    if (number != kNone) return number;
    Index& point = number_of_point_[mesh_.points[old_vertex]];
    if (point == kNone) point = counts_.points++;
    number = counts_.vertices++;
    old_vertex_[number] = old_vertex;
    point_[number] = point;
    return number;
}

HalfedgeId Numbering::halfedge(Index corner)
{
    const HalfedgeId fresh = first_halfedge(EdgeId(static_cast<int>(counts_.edges)));
    const Index across = opposite_[corner];
    if (across == kNone) {
        ++counts_.edges;
        at_boundary_.push_back(fresh);
        return fresh;
    }
    // Half of the edges are met for the first time here: a branch on it could not be foretold. What is known is written
    // again, which changes nothing.
    const HalfedgeId known = known_[corner];
    const bool is_first = !known.is_valid();
    counts_.edges += is_first ? 1 : 0;
    known_[is_first ? across : corner] = is_first ? opposite(fresh) : known;
    return is_first ? fresh : known;
}

void Numbering::write_faces(const NumberedChunk& chunk)
{
    const Index end = chunk.first + chunk.count;
    for (Index i = chunk.first; i < end; ++i) {
        __builtin_prefetch(&mesh_.sources[order_[std::min(i + kReadAhead, end - 1)]]);
        const FaceId face(static_cast<int>(i));
        u_->face_of_slot[SlotId(i)] = face;
        u_->stamp_of_face[face] = 0;
        u_->source_of_face[face] = mesh_.sources[order_[i]];
    }
}

void Numbering::write_vertices(Index first, Index end)
{
    for (Index v = first; v < end; ++v) {
        __builtin_prefetch(&mesh_.vertices[old_vertex_[std::min(v + kReadAhead, end - 1)]]);
        u_->vertices[v] = mesh_.vertices[old_vertex_[v]];
    }
}

}  // namespace kerf::core::halfedge
