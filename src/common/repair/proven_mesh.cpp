#include "common/repair/proven_mesh.h"

#include "common/mesh/coordinate_grain.h"
#include "common/repair/halfedges_by_edge.h"

namespace kerf::core {

namespace {

/// The half-edges, by point, of a mesh that has passed check(); finds faults in how they meet.
class Neighbourhood
{
public:
    explicit Neighbourhood(const IndexedMesh& mesh)
        : mesh_(mesh), corners_(mesh.triangles.size()), opposite_(3 * mesh.triangles.size(), kNone)
    {
        for (std::size_t t = 0; t < corners_.size(); ++t)
            for (std::size_t i = 0; i < 3; ++i) corners_[t][i] = mesh.points[mesh.triangles[t][i]];
    }

    /// Empty, or one sentence that names the first fault.
    std::string find_fault()
    {
        std::string fault = find_unused();
        if (fault.empty()) fault = pair_edges();
        if (fault.empty()) fault = find_loose_fan();
        return fault;
    }

    /// Only for a mesh without a fault.
    Adjacency take_adjacency()
    {
        Adjacency adjacency;
        adjacency.opposite = std::move(opposite_);
        adjacency.shell_count = label_shells(adjacency.opposite, adjacency.shell);
        return adjacency;
    }

private:
    std::uint32_t start(std::uint32_t h) const { return corners_[h / 3][h % 3]; }

    std::string find_unused() const
    {
        Buffer<std::uint8_t> is_used(mesh_.vertices.size(), 0);
        for (const Triangle& triangle : mesh_.triangles)
            for (const std::uint32_t v : triangle) is_used[v] = 1;
        for (std::size_t v = 0; v < is_used.size(); ++v)
            if (!is_used[v]) return "vertex " + std::to_string(v) + " belongs to no triangle; take it out";
        return {};
    }

    /// For each triangle the solid of its group; empty if there is only one.
    Buffer<std::uint32_t> solids() const
    {
        Buffer<std::uint32_t> solid;
        for (const TriangleGroup& group : mesh_.groups)
            if (group.solid != mesh_.groups.front().solid) solid.resize(mesh_.triangles.size());
        if (!solid.empty())
            for (const TriangleGroup& group : mesh_.groups)
                std::fill_n(solid.begin() + group.first, group.count, group.solid);
        return solid;
    }

    std::string pair_edges()
    {
        const Buffer<std::uint32_t> solid = solids();
        std::string fault;
        HalfedgesByEdge(mesh_.point_count, corners_).for_each([&](std::span<const HalfedgesByEdge::Entry> edge) {
            if (edge.size() == 1 || !fault.empty()) return;
            const std::uint32_t g = edge[0].halfedge, h = edge[1].halfedge;
            const auto name_both = [&](std::uint32_t s, std::uint32_t t) {
                return "triangles " + std::to_string(s / 3) + " and " + std::to_string(t / 3);
            };
            if (edge.size() > 2 || start(g) == start(h)) {
                // Of three, two have the same direction.
                std::uint32_t first = g, second = h;
                if (start(first) != start(second)) {
                    second = edge[2].halfedge;
                    if (start(first) != start(second)) first = h;
                }
                fault = name_both(first, second) + " run along the edge from point " + std::to_string(start(first)) +
                        " to point " + std::to_string(start(next_halfedge(first))) +
                        " in the same direction; turn one over, take it out, or give the triangles to repair()";
            } else if (!solid.empty() && solid[g / 3] != solid[h / 3]) {
                fault = name_both(g, h) + " share an edge but not their solid; put both into one";
            } else {
                opposite_[g] = h;
                opposite_[h] = g;
            }
        });
        return fault;
    }

    /// Counts a fan's triangles, rotating around its point both ways from the half-edge `first`, which leaves it.
    std::size_t count_fan(std::uint32_t first) const
    {
        std::size_t count = 0;
        std::uint32_t h = first;
        do {
            ++count;
            h = opposite_[previous_halfedge(h)];
        } while (h != first && h != kNone);
        if (h == first) return count;
        for (h = opposite_[first]; h != kNone; h = opposite_[next_halfedge(h)]) ++count;
        return count;
    }

    std::string find_loose_fan() const
    {
        Buffer<std::uint32_t> corners_at(mesh_.point_count, 0), leaving(mesh_.point_count);
        for (std::uint32_t h = 0; h < opposite_.size(); ++h) {
            ++corners_at[start(h)];
            leaving[start(h)] = h;
        }
        for (std::uint32_t point = 0; point < mesh_.point_count; ++point)
            if (count_fan(leaving[point]) != corners_at[point])
                return "the triangles around point " + std::to_string(point) +
                       " form several vertex fans; give each a point of its own, or give the triangles to repair()";
        return {};
    }

    const IndexedMesh& mesh_;
    Buffer<Triangle> corners_;  ///< point ids
    Buffer<std::uint32_t> opposite_;
};

}  // namespace

Proof prove(IndexedMesh mesh)
{
    Proof proof;
    proof.error = check(mesh);
    if (!proof.error.empty()) return proof;
    Neighbourhood neighbourhood(mesh);
    proof.error = neighbourhood.find_fault();
    if (!proof.error.empty()) return proof;
    const double shortest = shortest_edge(mesh.vertices, mesh.triangles);
    const Box bounds = mesh.bounds();
    Adjacency adjacency = neighbourhood.take_adjacency();
    const bool is_closed =
        std::find(adjacency.opposite.begin(), adjacency.opposite.end(), kNone) == adjacency.opposite.end();
    proof.mesh = ProvenMesh(std::move(mesh), std::move(adjacency), bounds, shortest, is_closed);
    return proof;
}

}  // namespace kerf::core
