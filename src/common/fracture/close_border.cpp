#include "common/fracture/close_border.h"

#include "common/geometry/disjoint_sets.h"
#include "common/geometry/pair_table.h"

namespace kerf::core {

namespace {

class BorderCloser
{
public:
    explicit BorderCloser(PieceBorder& border) : border_(border), mesh_(border.mesh) {}

    bool close() { return !mesh_.triangles.empty() && hangs_together() && pair() && has_single_fans(); }

private:
    std::uint32_t point(std::uint32_t halfedge) const
    {
        return mesh_.points[mesh_.triangles[halfedge / 3][halfedge % 3]];
    }
    static std::uint32_t next(std::uint32_t halfedge) { return halfedge % 3 == 2 ? halfedge - 2 : halfedge + 1; }
    static std::uint32_t previous(std::uint32_t halfedge) { return halfedge % 3 == 0 ? halfedge + 2 : halfedge - 1; }
    bool is_old(std::uint32_t point) const { return border_.old_point[point] != kNone; }

    /// By new points: each triangle has one, and caps have no others.
    bool hangs_together() const
    {
        DisjointSets sets(mesh_.point_count);
        for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
            std::uint32_t first = kNone;
            for (const std::uint32_t v : mesh_.triangles[t]) {
                const std::uint32_t p = mesh_.points[v];
                if (is_old(p) && t >= border_.surface_count) return false;
                if (is_old(p)) continue;
                if (first == kNone) first = p;
                sets.unite(first, p);
            }
        }
        std::uint32_t set = kNone;
        for (std::uint32_t p = 0; p < mesh_.point_count; ++p) {
            if (is_old(p)) continue;
            if (set == kNone) set = sets.find(p);
            if (sets.find(p) != set) return false;
        }
        return true;
    }

    bool pair()
    {
        const auto count = static_cast<std::uint32_t>(3 * mesh_.triangles.size());
        PairTable halfedges;
        halfedges.reset(count);
        for (std::uint32_t h = 0; h < count; ++h) {
            std::uint32_t& entry = halfedges(point(h), point(next(h)));
            if (entry != kNone) return false;
            entry = h;
        }
        border_.opposite.assign(count, kNone);
        for (std::uint32_t h = 0; h < count; ++h) {
            if (is_old(point(h)) && is_old(point(next(h)))) continue;
            border_.opposite[h] = halfedges.find(point(next(h)), point(h));
            if (border_.opposite[h] == kNone) return false;
        }
        return true;
    }

    /// Around an old point the triangles form what they formed before.
    bool has_single_fans() const
    {
        std::vector<std::uint32_t> corners(mesh_.point_count, 0), leaving(mesh_.point_count, kNone);
        for (std::uint32_t h = 0; h < border_.opposite.size(); ++h) {
            ++corners[point(h)];
            leaving[point(h)] = h;
        }
        for (std::uint32_t p = 0; p < mesh_.point_count; ++p) {
            if (is_old(p)) continue;
            std::uint32_t count = 0, h = leaving[p];
            do {
                ++count;
                h = border_.opposite[previous(h)];
            } while (h != leaving[p] && count <= corners[p]);
            if (count != corners[p]) return false;
        }
        return true;
    }

    PieceBorder& border_;
    const IndexedMesh& mesh_;
};

}  // namespace

bool close_border(PieceBorder& border)
{
    return BorderCloser(border).close();
}

}  // namespace kerf::core
