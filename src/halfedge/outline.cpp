#include "halfedge/outline.h"

#include <algorithm>
#include <unordered_map>

#include "common/outgoing_edges.h"

namespace kerf::halfedge {

namespace {

/// Classes of coinciding points: union-find over cut points and, as they turn up, vertices of the half-edge mesh.
class PointClasses
{
public:
    explicit PointClasses(const CutScratch& scratch) : position_(scratch.cut_points), parent_(position_.size())
    {
        for (Index i = 0; i < parent_.size(); ++i) parent_[i] = i;
    }

    Index of_vertex(const SurfaceMesh& mesh, Index vertex)
    {
        const auto [entry, is_new] = of_vertex_.try_emplace(vertex, static_cast<Index>(parent_.size()));
        if (is_new) {
            parent_.push_back(entry->second);
            position_.push_back(mesh.point(vertex));
        }
        return entry->second;
    }

    Index find(Index i)
    {
        while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
        return i;
    }

    void unite(Index a, Index b)
    {
        a = find(a);
        b = find(b);
        // The smaller one stays, whatever the order of the calls.
        if (a != b) parent_[std::max(a, b)] = std::min(a, b);
    }

    std::size_t size() const { return parent_.size(); }
    const glm::vec3& position(Index i) const { return position_[i]; }

private:
    std::vector<glm::vec3> position_;
    std::vector<Index> parent_;
    std::unordered_map<Index, Index> of_vertex_;
};

/// The element of a corner of a crossing triangle.
Index element_of_code(const Universe& u, const Crossing& c, std::uint8_t code, PointClasses& classes)
{
    if (code == TriangleSplit::kCutNext) return c.n_cut();
    if (code == TriangleSplit::kCutPrevious) return c.p_cut();
    return classes.of_vertex(u.mesh, c.point[code]);
}

void unite_coinciding(const Universe& u, const CutScratch& s, PointClasses& classes)
{
    for (const Crossing& c : s.crossings) {
        if (c.n_cut() != kNone) classes.unite(c.n_cut(), element_of_code(u, c, c.split.next_code, classes));
        if (c.p_cut() != kNone) classes.unite(c.p_cut(), element_of_code(u, c, c.split.previous_code, classes));
    }
}

/// Collects the seams with the classes of their ends, and says which cut points are shared.
void collect_seams(const Universe& u, CutScratch& s)
{
    PointClasses classes(s);
    unite_coinciding(u, s, classes);
    const auto add = [&](SeamIndex seam, Index from, Index to) {
        from = classes.find(from);
        to = classes.find(to);
        if (from != to) s.outline.push_back({seam, from, to});
    };
    for (SeamIndex i = 0; i < s.crossings.size(); ++i) {
        const Crossing& c = s.crossings[i];
        if (!c.split.has_section_edge()) continue;
        const Index from = element_of_code(u, c, c.split.section_from, classes);
        add(i, from, element_of_code(u, c, c.split.section_to, classes));
    }
    for (SeamIndex i = 0; i < s.in_plane.size(); ++i) {
        // As seen in the positive side's surface.
        const Index h = s.in_plane[i].positive_halfedge;
        const Index from = classes.of_vertex(u.mesh, u.mesh.from(h));
        add(static_cast<SeamIndex>(s.crossings.size()) + i, from, classes.of_vertex(u.mesh, u.mesh.to(h)));
    }
    // A cut point that is alone is one vertex on each side.
    std::vector<Index> members(classes.size(), 0);
    for (Index i = 0; i < classes.size(); ++i) ++members[classes.find(i)];
    for (Index i = 0; i < s.cut_points.size(); ++i) s.shared_cut[i] = members[classes.find(i)] > 1 ? 1 : 0;
    s.any_shared = true;
    s.outline_points.resize(classes.size());
    for (Index i = 0; i < classes.size(); ++i) s.outline_points[i] = classes.position(i);
}

/// Takes out pairs of seams that run forth and back.
void cancel_seams(CutScratch& s)
{
    std::vector<OutlineSeam>& seams = s.outline;
    std::vector<Index> order(seams.size());
    for (Index i = 0; i < order.size(); ++i) order[i] = i;
    const auto key = [&](Index i) { return std::minmax(seams[i].from, seams[i].to); };
    std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) { return key(a) < key(b); });
    std::vector<bool> gone(seams.size(), false);
    for (std::size_t first = 0, last; first < order.size(); first = last) {
        for (last = first + 1; last < order.size() && key(order[last]) == key(order[first]);) ++last;
        std::size_t back = first;
        for (std::size_t i = first; i < last; ++i) {
            const OutlineSeam& e = seams[order[i]];
            if (e.from > e.to) continue;
            while (back < last && seams[order[back]].from < seams[order[back]].to) ++back;
            if (back == last) break;
            s.cancelled.push_back({e.seam, seams[order[back]].seam});
            gone[order[i]] = gone[order[back++]] = true;
        }
    }
    std::size_t kept = 0;
    for (Index i = 0; i < seams.size(); ++i)
        if (!gone[i]) seams[kept++] = seams[i];
    seams.resize(kept);
}

/// Follows unused seams from point to point, those of one tag after one another. Where the path comes back to a point
/// that it has passed, the loop between is cut off, so loops are simple and a pinch separates two loops.
template <class Tag>
class OutlineLinker
{
public:
    OutlineLinker(const Universe& universe, CutScratch& scratch, Tag tag)
        : u_(universe),
          s_(scratch),
          tag_of_{scratch, tag},
          outgoing_(
              scratch.outline_points.size(), scratch.outline.size(), [&](Index i) { return scratch.outline[i].from; },
              tag_of_),
          position_on_path_(scratch.outline_points.size(), kNone)
    {
    }

    void run()
    {
        // Chains first: they start where more seams leave than arrive.
        std::vector<int> excess(s_.outline_points.size(), 0);
        for (const OutlineSeam& e : s_.outline) {
            ++excess[e.from];
            --excess[e.to];
        }
        for (Index i = 0; i < excess.size(); ++i) {
            if (excess[i] <= 0) continue;
            for (const Index seam : outgoing_.leaving(i)) {
                if (excess[i] <= 0) break;
                if (outgoing_.is_used(seam)) continue;
                --excess[i];
                follow(seam);
            }
        }
        for (Index i = 0; i < s_.outline.size(); ++i)
            if (!outgoing_.is_used(i)) follow(i);
    }

private:
    struct TagOfNumber
    {
        const CutScratch& scratch;
        Tag tag;
        auto operator()(Index i) const { return tag(scratch.outline[i]); }
    };

    void follow(Index first)
    {
        const auto tag = tag_of_(first);
        path_.clear();
        for (Index i = first; i != kNone;) {
            outgoing_.use(i);
            position_on_path_[s_.outline[i].from] = static_cast<Index>(path_.size());
            path_.push_back(i);
            const Index at = s_.outline[i].to;
            if (position_on_path_[at] != kNone) emit(position_on_path_[at], true);
            i = outgoing_.next(at, tag);
        }
        if (!path_.empty()) emit(0, false);
    }

    /// Takes the path from position `first` on as a loop or chain.
    void emit(Index first, bool closed)
    {
        Loop loop;
        loop.first = s_.loop_seams.size();
        loop.count = path_.size() - first;
        loop.closed = closed;
        const SeamIndex seam = s_.outline[path_[first]].seam;
        const bool crossing = seam < s_.crossings.size();
        loop.solid =
            u_.groups[crossing ? s_.crossings[seam].group : s_.in_plane[seam - s_.crossings.size()].group].solid;
        loop.shell = crossing ? s_.crossings[seam].shell : s_.in_plane[seam - s_.crossings.size()].shell;
        for (std::size_t i = first; i < path_.size(); ++i) {
            const OutlineSeam& e = s_.outline[path_[i]];
            s_.loop_seams.push_back(e.seam);
            s_.loop_points.push_back(s_.outline_points[e.from]);
            position_on_path_[e.from] = kNone;
        }
        if (!closed) loop.end = s_.outline_points[s_.outline[path_.back()].to];
        s_.loops.push_back(loop);
        path_.resize(first);
    }

    const Universe& u_;
    CutScratch& s_;
    TagOfNumber tag_of_;
    OutgoingEdges<TagOfNumber> outgoing_;
    std::vector<Index> path_;
    std::vector<Index> position_on_path_;  // of the seam that leaves a point
};

}  // namespace

void link_outline(const Universe& universe, CutScratch& scratch)
{
    collect_seams(universe, scratch);
    cancel_seams(scratch);
    OutlineLinker(universe, scratch, [](const OutlineSeam&) { return 0; }).run();
}

void relink_outline(const Universe& universe, CutScratch& scratch)
{
    scratch.loops.clear();
    scratch.loop_seams.clear();
    scratch.loop_points.clear();
    OutlineLinker(universe, scratch, [&](const OutlineSeam& e) { return scratch.bundles_of_seam(e.seam); }).run();
}

std::vector<std::array<Index, 2>> targets_that_share_edges(const Universe& u, const CutScratch& s)
{
    PointClasses classes(s);
    unite_coinciding(u, s, classes);
    struct Place
    {
        Side side;
        Index from, to, target;
        auto operator<=>(const Place&) const = default;
    };
    std::vector<Place> places;
    const auto add = [&](Side side, Index a, Index b, Index target) {
        a = classes.find(a);
        b = classes.find(b);
        places.push_back({side, std::min(a, b), std::max(a, b), target});
    };
    for (const Crossing& c : s.crossings)
        for (std::size_t i = 0; i < c.split.piece_count; ++i) {
            const TriangleSplit::Piece& piece = c.split.pieces[i];
            for (std::size_t corner = 0; corner < 3; ++corner) {
                const Index from = element_of_code(u, c, piece.corners[corner], classes);
                add(piece.side, from, element_of_code(u, c, piece.corners[(corner + 1) % 3], classes),
                    c.target[static_cast<std::size_t>(piece.side)]);
            }
        }
    const auto add_halfedge = [&](Side side, Index h, Index target) {
        const Index from = classes.of_vertex(u.mesh, u.mesh.from(h));
        add(side, from, classes.of_vertex(u.mesh, u.mesh.to(h)), target);
    };
    for (const InPlaneEdge& e : s.in_plane) {
        add_halfedge(Side::negative, e.negative_halfedge, e.target[0]);
        add_halfedge(Side::positive, e.positive_halfedge, e.target[1]);
    }
    for (const FlushEdge& e : s.flush) add_halfedge(e.side, e.halfedge, e.target);

    std::sort(places.begin(), places.end());
    std::vector<std::array<Index, 2>> pairs;
    for (std::size_t i = 1; i < places.size(); ++i) {
        const Place &a = places[i - 1], &b = places[i];
        if (a.side == b.side && a.from == b.from && a.to == b.to && a.target != b.target)
            pairs.push_back({a.target, b.target});
    }
    return pairs;
}

}  // namespace kerf::halfedge
