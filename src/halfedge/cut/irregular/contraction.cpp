#include "halfedge/cut/irregular/irregular.h"

namespace kerf::core::halfedge {

namespace {

class Contraction
{
public:
    Contraction(StitchPlan& plan, SurfaceMesh& mesh) : plan_(plan), mesh_(mesh) {}

    void open_in_plane_edge(const Found& found, Index number);
    void run(const std::vector<std::array<OutlineEdgeId, 2>>& cancelled);

private:
    void mark_waiting();
    void move_halfedge(HalfedgeId from, HalfedgeId to);
    void contract(HalfedgeId x, HalfedgeId y);
    void contract_face(FaceId face);

    StitchPlan& plan_;
    SurfaceMesh& mesh_;
};

void Contraction::open_in_plane_edge(const Found& found, Index number)
{
    const InPlaneEdge& e = found.in_plane[number];
    const OutlineEdgeId edge = found.edge_in_plane(number);
    const HalfedgeId copy = plan_.in_plane_copy(number);
    const PointId a = mesh_.from(e.negative_halfedge);
    move_halfedge(e.negative_halfedge, copy);
    move_outgoing(mesh_, a, e.negative_halfedge, copy);
    mesh_.set_to(opposite(copy), a);
    mesh_.set_face(e.negative_halfedge, FaceId());
    plan_.cap_halfedge(edge, Side::positive) = e.negative_halfedge;
    plan_.cap_halfedge(edge, Side::negative) = opposite(copy);
}

void Contraction::run(const std::vector<std::array<OutlineEdgeId, 2>>& cancelled)
{
    mark_waiting();
    for (const FaceId face : plan_.vanished) contract_face(face);
    for (const auto& [a, b] : cancelled)
        for (const Side side : kSides) contract(plan_.cap_halfedge(a, side), plan_.cap_halfedge(b, side));
}

void Contraction::mark_waiting()
{
    for (Index i = 0; i < plan_.cap_halfedges.size(); ++i)
        if (plan_.cap_halfedges[i].is_valid()) mesh_.set_face(plan_.cap_halfedges[i], plan_.waiting_face(i));
}

/// Half-edge `from` continues as half-edge `to`.
void Contraction::move_halfedge(HalfedgeId from, HalfedgeId to)
{
    const FaceId face = mesh_.face(from);
    mesh_.set_to(to, mesh_.to(from));
    mesh_.set_face(to, face);
    mesh_.set_face(from, FaceId());
    if (plan_.is_waiting(face)) {
        plan_.cap_halfedges[plan_.place_of_waiting(face)] = to;
        return;
    }
    if (!face.is_valid()) {
        // At a crossed edge of the boundary its neighbours are not known yet. What dies here is skipped then.
        plan_.boundary.push_back(to);
        return;
    }
    const HalfedgeId prev = mesh_.prev(from), next = mesh_.next(from);
    mesh_.link(to, next);
    mesh_.link(prev, to);
    if (mesh_.halfedge_of(face) == from) mesh_.set_halfedge_of(face, to);
}

/// Removes x and y, which bound nothing: what lies across x and what lies across y become opposite.
void Contraction::contract(HalfedgeId x, HalfedgeId y)
{
    const HalfedgeId a = opposite(x), b = opposite(y);
    mesh_.set_face(x, FaceId());
    mesh_.set_face(y, FaceId());
    if (a == y) return;
    move_halfedge(b, x);
    plan_.touched.push_back(a);
    plan_.touched.push_back(x);
}

void Contraction::contract_face(FaceId face)
{
    const HalfedgeId x = mesh_.halfedge_of(face), y = mesh_.next(x);
    mesh_.set_halfedge_of(face, HalfedgeId());
    contract(x, y);
}

}  // namespace

void open_in_plane_edges(const Found& found, StitchPlan& plan, SurfaceMesh& mesh)
{
    Contraction contraction(plan, mesh);
    for (Index i = 0; i < found.in_plane.size(); ++i) contraction.open_in_plane_edge(found, i);
}

void contract(const std::vector<std::array<OutlineEdgeId, 2>>& cancelled, StitchPlan& plan, SurfaceMesh& mesh)
{
    Contraction(plan, mesh).run(cancelled);
}

}  // namespace kerf::core::halfedge
