#include "halfedge/cut/irregular/irregular.h"

#include <algorithm>

namespace kerf::core::halfedge {

namespace {

/// Half-edges that leave one vertex, found by going around it.
class PointSplitter
{
public:
    PointSplitter(StitchPlan& plan, SurfaceMesh& mesh, const Found& found, const Section& section, const Caps& caps)
        : plan_(plan), mesh_(mesh), found_(found), section_(section), caps_(caps)
    {
    }

    void run()
    {
        for (Index c = 0; c < found_.crossings.size(); ++c) {
            if (!section_.is_shared(found_.crossings[c])) continue;
            for (const SubFace& sub : plan_.sub_faces(found_.crossings[c], c))
                if (sub.exists) start_orbits(sub.face);
        }
        for (Index t = 0; t < caps_.triangles.size(); ++t) {
            const auto& corner = caps_.triangles[t].corner;
            if (std::none_of(corner.begin(), corner.end(),
                             [&](Index p) { return is_shared_point(found_, section_, p); }))
                continue;
            for (const Side side : {Side::negative, Side::positive}) start_orbits(plan_.cap_face(side, t));
        }
        for (OutlineEdgeId edge(0); edge.number() < plan_.edge_is_closed.size(); ++edge) {
            if (!is_shared_edge(found_, section_, edge) || !found_.has_section_edge(edge)) continue;
            for (const Side side : {Side::negative, Side::positive}) {
                const FaceId face = mesh_.face(opposite(plan_.cap_halfedge(edge, side)));
                if (face.is_valid()) start_orbits(face);
            }
        }
        for (const HalfedgeId h : plan_.touched)
            if (!mesh_.is_boundary(h)) start_orbits(mesh_.face(h));
        hand_out_vertices();
    }

private:
    /// The first orbit with a label keeps it; all others with the same label get new vertices.
    void hand_out_vertices()
    {
        auto& label = plan_.orbit_label;
        auto& order = plan_.order;
        for (Index i = 0; i < label.size(); ++i) order.push_back(i);
        std::sort(order.begin(), order.end(),
                  [&](Index a, Index b) { return label[a] != label[b] ? label[a] < label[b] : a < b; });
        std::size_t points = mesh_.points();
        Index extra = static_cast<Index>(points);
        for (std::size_t i = 0; i < order.size(); ++i)
            if (label[order[i]] == kNone || (i > 0 && label_of_previous(i) == label[order[i]])) ++points;
        mesh_.resize(points, mesh_.edges(), mesh_.faces());
        Index before = kNone;
        for (const Index i : order) {
            const Index wanted = label[i];
            PointId point{int(wanted)};
            if (wanted == kNone || wanted == before) {
                const glm::vec3 position = wanted != kNone ? mesh_.position(point) : cap_corner(plan_.orbit_start[i]);
                point = PointId(int(extra++));
                mesh_.set_position(point, position);
            }
            before = wanted;
            HalfedgeId leaving, arriving;
            for_each_outgoing(mesh_, plan_.orbit_start[i], [&](HalfedgeId h) {
                mesh_.set_to(opposite(h), point);
                if (mesh_.is_boundary(h)) leaving = h;
                if (mesh_.is_boundary(opposite(h))) arriving = opposite(h);
            });
            mesh_.set_halfedge_of(point, leaving.is_valid() ? leaving : plan_.orbit_start[i]);
            // Where loops and chains meet at the boundary caps may put other boundary edges together than before.
            if (leaving.is_valid() && arriving.is_valid()) mesh_.link(arriving, leaving);
        }
    }

    Index label_of_previous(std::size_t i) const { return plan_.orbit_label[plan_.order[i - 1]]; }

    // While orbits are found, the point that a half-edge leads to is the number of the orbit that has reached it, above
    // all points: no mesh has that many.
    static constexpr int kFirstMark = 1 << 30;
    static PointId mark_of(std::size_t orbit) { return PointId(kFirstMark + int(orbit)); }
    static bool is_mark(PointId point) { return point.idx() >= kFirstMark; }

    /// Starts an orbit at each corner of a face that no orbit has reached yet. Reached half-edges get the orbit's
    /// number.
    void start_orbits(FaceId face)
    {
        HalfedgeId start = mesh_.halfedge_of(face);
        for (int i = 0; i < 3; ++i, start = mesh_.next(start)) {
            if (is_mark(mesh_.from(start))) continue;
            const PointId mark = mark_of(plan_.orbit_start.size());
            Index label = kNone;
            for_each_outgoing(mesh_, start, [&](HalfedgeId h) {
                // What faces of the surface say; corners of new caps don't know.
                if (!mesh_.is_boundary(h) && !plan_.is_of_cap(mesh_.face(h)))
                    label = std::min(label, number_of(unmarked_origin(h)));
            });
            for_each_outgoing(mesh_, start, [&](HalfedgeId h) { mesh_.set_to(opposite(h), mark); });
            plan_.orbit_start.push_back(start);
            plan_.orbit_label.push_back(label);
        }
    }

    /// The origin of h as its own face knows it.
    PointId unmarked_origin(HalfedgeId h) const { return mesh_.to(mesh_.prev(h)); }

    glm::vec3 cap_corner(HalfedgeId h) const
    {
        const FaceId face = mesh_.face(h);
        const bool positive = !(face < plan_.cap_face(Side::positive, 0));
        const FaceId first = plan_.cap_face(positive ? Side::positive : Side::negative, 0);
        const CapTriangle& cap = caps_.triangles[number_of(face) - number_of(first)];
        HalfedgeId at = mesh_.halfedge_of(face);
        std::size_t corner = 0;
        while (at != h) {
            at = mesh_.next(at);
            ++corner;
        }
        static constexpr std::array<std::size_t, 3> kMirrored{0, 2, 1};
        return section_.loop_points[cap.corner[positive ? kMirrored[corner] : corner]];
    }

    StitchPlan& plan_;
    SurfaceMesh& mesh_;
    const Found& found_;
    const Section& section_;
    const Caps& caps_;
};

}  // namespace

void split_points(const Found& found, const Section& section, const Caps& caps, StitchPlan& plan, SurfaceMesh& mesh)
{
    PointSplitter(plan, mesh, found, section, caps).run();
}

}  // namespace kerf::core::halfedge
