#pragma once

#include <OpenMesh/Core/Mesh/Handles.hh>
#include <compare>
#include <cstdint>

#include "common/mesh/index.h"

// Numbers that can't be mistaken for one another: at run time each is 32 bits. Only a triangle of the index buffer holds
// vertices as plain numbers, because the GPU reads them.

namespace kerf::core::halfedge {

// Of the half-edge mesh. A point is what OpenMesh calls a vertex: several vertices of the vertex buffer may lie at it.
using PointId = OpenMesh::VertexHandle;
using HalfedgeId = OpenMesh::HalfedgeHandle;
using EdgeId = OpenMesh::EdgeHandle;
using FaceId = OpenMesh::FaceHandle;

inline Index number_of(const OpenMesh::BaseHandle& handle)
{
    return Index(handle.idx());
}

/// The half-edge of the same edge that runs the other way.
inline HalfedgeId opposite(HalfedgeId h)
{
    return HalfedgeId(h.idx() ^ 1);
}

inline EdgeId edge_of(HalfedgeId h)
{
    return EdgeId(h.idx() >> 1);
}

/// The first half-edge of an edge; the second one is opposite to it.
inline HalfedgeId first_halfedge(EdgeId e)
{
    return HalfedgeId(2 * e.idx());
}

/// A number of one kind.
template <class Kind>
class Id
{
public:
    constexpr Id() = default;
    explicit constexpr Id(Index number) : number_(number) {}

    constexpr Index number() const { return number_; }
    constexpr bool is_valid() const { return number_ != kNone; }

    constexpr auto operator<=>(const Id&) const = default;
    constexpr Id& operator++()
    {
        ++number_;
        return *this;
    }
    constexpr Id operator++(int)
    {
        const Id before = *this;
        ++number_;
        return before;
    }
    friend constexpr Id operator+(Id id, Index count) { return Id(id.number_ + count); }
    friend constexpr Index operator-(Id a, Id b) { return a.number_ - b.number_; }

private:
    Index number_ = kNone;
};

template <class Kind>
constexpr Index number_of(Id<Kind> id)
{
    return id.number();
}

constexpr std::size_t number_of(std::size_t number)
{
    return number;
}

/// A vertex of the vertex buffer, as the GPU numbers them.
using VertexId = Id<struct VertexKind>;
/// A triangle's place in the index buffer.
using SlotId = Id<struct SlotKind>;
/// A node of the tree.
using NodeId = Id<struct NodeKind>;
/// A draw group: triangles of one material, solid and kind.
using GroupId = Id<struct GroupKind>;

}  // namespace kerf::core::halfedge
