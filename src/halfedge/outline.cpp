#include "halfedge/outline.h"

#include <algorithm>
#include <unordered_map>

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

struct Edge
{
    SeamIndex seam;
    Index from, to;
    bool used = false;
};

class OutlineLinker
{
public:
    OutlineLinker(const Universe& universe, CutScratch& scratch) : u_(universe), s_(scratch), classes_(scratch) {}

    void run()
    {
        collect();
        cancel();
        link();
    }

private:
    Index element_of_code(const Crossing& c, std::uint8_t code)
    {
        if (code == TriangleSplit::kCutNext) return c.n_cut();
        if (code == TriangleSplit::kCutPrevious) return c.p_cut();
        return classes_.of_vertex(u_.mesh, c.point[code]);
    }

    void collect()
    {
        for (const Crossing& c : s_.crossings) {
            if (c.n_cut() != kNone) classes_.unite(c.n_cut(), element_of_code(c, c.split.next_code));
            if (c.p_cut() != kNone) classes_.unite(c.p_cut(), element_of_code(c, c.split.previous_code));
        }
        for (SeamIndex i = 0; i < s_.crossings.size(); ++i) {
            const Crossing& c = s_.crossings[i];
            if (!c.split.has_section_edge()) continue;
            edges_.push_back({i, element_of_code(c, c.split.section_from), element_of_code(c, c.split.section_to)});
        }
        for (SeamIndex i = 0; i < s_.in_plane.size(); ++i) {
            // As seen in the positive side's surface.
            const Index h = s_.in_plane[i].positive_halfedge;
            edges_.push_back({static_cast<SeamIndex>(s_.crossings.size()) + i,
                              classes_.of_vertex(u_.mesh, u_.mesh.from(h)),
                              classes_.of_vertex(u_.mesh, u_.mesh.to(h))});
        }
        for (Edge& e : edges_) {
            e.from = classes_.find(e.from);
            e.to = classes_.find(e.to);
        }
        std::erase_if(edges_, [](const Edge& e) { return e.from == e.to; });
    }

    void cancel()
    {
        std::vector<Index> order(edges_.size());
        for (Index i = 0; i < order.size(); ++i) order[i] = i;
        const auto key = [&](Index i) { return std::minmax(edges_[i].from, edges_[i].to); };
        std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) { return key(a) < key(b); });
        for (std::size_t first = 0, last; first < order.size(); first = last) {
            for (last = first + 1; last < order.size() && key(order[last]) == key(order[first]);) ++last;
            std::size_t back = first;
            for (std::size_t i = first; i < last; ++i) {
                Edge& e = edges_[order[i]];
                if (e.from > e.to || e.used) continue;
                while (back < last && (edges_[order[back]].from < edges_[order[back]].to || edges_[order[back]].used))
                    ++back;
                if (back == last) break;
                Edge& f = edges_[order[back]];
                e.used = f.used = true;
                s_.cancelled.push_back({e.seam, f.seam});
            }
        }
        std::erase_if(edges_, [](const Edge& e) { return e.used; });
    }

    /// Follows unused edges from point to point. Where the path comes back to a point that it has passed, the loop
    /// between is cut off, so loops are simple and a pinch separates two loops.
    void link()
    {
        // Edges by their origin; `start` is indexed by class element.
        std::vector<Index> start(classes_.size() + 1, 0), out(edges_.size());
        std::vector<int> excess(classes_.size(), 0);
        for (const Edge& e : edges_) {
            ++start[e.from + 1];
            ++excess[e.from];
            --excess[e.to];
        }
        for (std::size_t i = 1; i < start.size(); ++i) start[i] += start[i - 1];
        std::vector<Index> cursor(start.begin(), start.end() - 1);
        for (Index i = 0; i < edges_.size(); ++i) out[cursor[edges_[i].from]++] = i;
        std::copy(start.begin(), start.end() - 1, cursor.begin());

        position_on_path_.assign(classes_.size(), kNone);
        const auto follow = [&](Index at) {
            path_.clear();
            position_on_path_[at] = 0;
            for (;;) {
                Index& next = cursor[at];
                if (next == start[at + 1]) break;
                const Index e = out[next++];
                path_.push_back(e);
                at = edges_[e].to;
                if (position_on_path_[at] == kNone) {
                    position_on_path_[at] = static_cast<Index>(path_.size());
                } else {
                    emit(position_on_path_[at], true);
                }
            }
            if (!path_.empty()) {
                const Index end = edges_[path_.back()].to;
                emit(0, false);
                position_on_path_[end] = kNone;
            }
            position_on_path_[at] = kNone;
        };
        // Chains first: they start where more edges leave than arrive.
        for (Index i = 0; i < excess.size(); ++i)
            for (int n = excess[i]; n > 0; --n) follow(i);
        for (const Edge& e : edges_)
            while (cursor[e.from] != start[e.from + 1]) follow(e.from);
    }

    /// Takes the path from position `first` on as a loop or chain.
    void emit(Index first, bool closed)
    {
        Loop loop;
        loop.first = s_.loop_seams.size();
        loop.count = path_.size() - first;
        loop.closed = closed;
        const SeamIndex seam = edges_[path_[first]].seam;
        const bool crossing = seam < s_.crossings.size();
        loop.solid =
            u_.groups[crossing ? s_.crossings[seam].group : s_.in_plane[seam - s_.crossings.size()].group].solid;
        loop.shell = crossing ? s_.crossings[seam].shell : s_.in_plane[seam - s_.crossings.size()].shell;
        for (std::size_t i = first; i < path_.size(); ++i) {
            const Edge& e = edges_[path_[i]];
            s_.loop_seams.push_back(e.seam);
            s_.loop_points.push_back(classes_.position(e.from));
            if (i > first) position_on_path_[e.from] = kNone;
        }
        if (!closed) {
            loop.end = classes_.position(edges_[path_.back()].to);
            position_on_path_[edges_[path_[first]].from] = kNone;
        }
        s_.loops.push_back(loop);
        path_.resize(first);
    }

    const Universe& u_;
    CutScratch& s_;
    PointClasses classes_;
    std::vector<Edge> edges_;
    std::vector<Index> path_;
    std::vector<Index> position_on_path_;
};

}  // namespace

void link_outline(const Universe& universe, CutScratch& scratch)
{
    OutlineLinker(universe, scratch).run();
}

}  // namespace kerf::halfedge
