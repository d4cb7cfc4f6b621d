#include "halfedge/cap_arena.h"

// What CGAL's containers allocate with (CGAL/memory.h): defined before anything of CGAL is read.
#define CGAL_ALLOCATOR(T) kerf::halfedge::CapArenaAllocator<T>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <new>
#include <tuple>
#include <utility>

#include "halfedge/cap_triangulator.h"

// The only file that includes CGAL, whose triangulations are under the GPL.

namespace kerf::halfedge {

namespace {

/// Triangles for each point of an outline, and besides. Loops that do not cross need two, or as many as loops lie on
/// one another; a coil around one point needs points times turns, which is no price for a cap.
constexpr std::size_t kMostLayers = 4, kMostCovered = 32768;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

struct FaceInfo
{
    static constexpr int kUnknown = std::numeric_limits<int>::min();
    int winding = kUnknown;
    Index id = kNone;                                ///< order of the flood
    Index first = kNone;                             ///< first cap triangle
    std::array<Index, 3> seam{kNone, kNone, kNone};  ///< head of the list of seams along edge i
};

using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<Index, Kernel>;
using FaceBase =
    CGAL::Triangulation_face_base_with_info_2<FaceInfo, Kernel, CGAL::Constrained_triangulation_face_base_2<Kernel>>;
using DataStructure = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
using Triangulation =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, DataStructure,
                                               CGAL::No_constraint_intersection_requiring_constructions_tag>;
using FaceHandle = Triangulation::Face_handle;
using VertexHandle = Triangulation::Vertex_handle;

class ConstrainedTriangulator final : public CapTriangulator
{
public:
    bool triangulate(const CapOutline& outline, CapMesh& cap) override
    {
        cap.clear();
        // A triangulation of its own for each cap: one that ran out of memory half-way is fit for nothing but its
        // destructor, and clear() gives all memory back as well.
        const CapArena arena;
        Triangulation triangulation;
        triangulation_ = &triangulation;
        try {
            if (!insert_points(outline, cap) || triangulation.dimension() < 2 || !insert_seams(outline)) return false;
        } catch (const std::bad_alloc&) {
            throw;
        } catch (const std::exception&) {
            // Seams that cross one another: Intersection_of_constraints_exception.
            return false;
        }
        if (!flood(cap)) return false;
        link(cap);
        return true;
    }

private:
    /// False when points fall together that are two points in space.
    bool insert_points(const CapOutline& outline, CapMesh& cap)
    {
        sort_along_hilbert_curve(outline.points);
        vertices_.resize(outline.points.size());
        loops_at_.assign(outline.points.size(), 0);
        FaceHandle hint;
        VertexHandle v;
        for (const auto& [key, i] : order_) {
            const glm::dvec2& p = outline.points[i];
            // Points at one place follow one another. CGAL would find that it has them, and look around each again.
            if (v == VertexHandle() || outline.points[v->info()] != p) {
                v = triangulation_->insert(Kernel::Point_2(p.x, p.y), hint);
                v->info() = i;
            } else {
                if (outline.positions[v->info()] != outline.positions[i]) return false;
                cap.shared_points.push_back(v->info());
                cap.shared_points.push_back(i);
            }
            vertices_[i] = v;
            ++loops_at_[v->info()];
            hint = v->face();
        }
        return true;
    }

    /// Insertion in loop order makes long cascades of flips; neighbours on a space-filling curve are found at once.
    void sort_along_hilbert_curve(std::span<const glm::dvec2> points)
    {
        glm::dvec2 lo = points[0], hi = points[0];
        for (const glm::dvec2& p : points) {
            lo = glm::min(lo, p);
            hi = glm::max(hi, p);
        }
        const double longest = std::max(hi.x - lo.x, hi.y - lo.y);
        constexpr std::uint32_t kBits = 16;
        const double scale = longest > 0.0 ? ((1u << kBits) - 1) / longest : 0.0;
        order_.clear();
        for (Index i = 0; i < points.size(); ++i) {
            const glm::dvec2 cell = (points[i] - lo) * scale;
            order_.emplace_back(hilbert_index(std::uint32_t(cell.x), std::uint32_t(cell.y), kBits), i);
        }
        std::sort(order_.begin(), order_.end(), [&](const auto& a, const auto& b) {
            const glm::dvec2 &p = points[a.second], &q = points[b.second];
            return std::tie(a.first, p.x, p.y, a.second) < std::tie(b.first, q.x, q.y, b.second);
        });
    }

    static std::uint32_t hilbert_index(std::uint32_t x, std::uint32_t y, std::uint32_t bits)
    {
        std::uint32_t index = 0;
        for (std::uint32_t s = 1u << (bits - 1); s > 0; s >>= 1) {
            const std::uint32_t right = (x & s) != 0, up = (y & s) != 0;
            index = 4 * index + ((3 * right) ^ up);
            if (up != 0) continue;
            if (right != 0) {
                x = (2 * s - 1) - (x & (2 * s - 1));
                y = (2 * s - 1) - (y & (2 * s - 1));
            }
            std::swap(x, y);
        }
        return index;
    }

    /// False when a seam passes through a point of the outline.
    bool insert_seams(const CapOutline& outline)
    {
        crossed_.clear();
        for_each_seam(outline, [&](Index i, Index j) {
            const auto [from, to] = from_fewer_loops(i, j);
            FaceHandle f;
            int edge;
            if (triangulation_->is_edge(vertices_[from], vertices_[to], f, edge))
                triangulation_->insert_constraint(vertices_[from], vertices_[to]);
            else
                crossed_.push_back({from, to});
            return true;
        });
        // What a seam crosses is triangulated anew. In the order of a loop that can be half of all there is, seam after
        // seam (teeth that lean over one another); in random order those that are in shield those to come: O(n log^2 n)
        // expected. Shewchuk and Brown, "Fast segment insertion and incremental construction of constrained Delaunay
        // triangulations", 2015.
        shuffle(crossed_);
        for (const auto& [i, j] : crossed_) triangulation_->insert_constraint(vertices_[i], vertices_[j]);
        seam_next_.assign(vertices_.size(), kNone);
        return for_each_seam(outline, [&](Index i, Index j) {
            FaceHandle f;
            int edge;
            const auto [from, to] = from_fewer_loops(i, j);
            if (!triangulation_->is_edge(vertices_[from], vertices_[to], f, edge)) return false;
            seam_next_[i] = f->info().seam[std::size_t(edge)];
            f->info().seam[std::size_t(edge)] = i;
            const FaceHandle g = f->neighbor(edge);
            g->info().seam[std::size_t(triangulation_->mirror_index(f, edge))] = i;
            return true;
        });
    }

    /// The ends of a seam, that first where fewer loops run through: CGAL looks for the other one around it, and where
    /// thousands of loops meet, thousands of edges do.
    std::array<Index, 2> from_fewer_loops(Index i, Index j) const
    {
        return loops_at_[vertices_[i]->info()] <= loops_at_[vertices_[j]->info()] ? std::array{i, j} : std::array{j, i};
    }

    /// Fisher and Yates, with numbers that are the same on every run and everywhere.
    static void shuffle(std::vector<std::array<Index, 2>>& seams)
    {
        std::uint64_t state = seams.size();
        for (std::size_t i = seams.size(); i > 1; --i) {
            // Knuth's linear congruential generator; its high bits are the random ones.
            state = state * 6364136223846793005ull + 1442695040888963407ull;
            std::swap(seams[i - 1], seams[((state >> 32) * i) >> 32]);
        }
    }

    template <class Visit>
    static bool for_each_seam(const CapOutline& outline, Visit visit)
    {
        for (Index loop = 0; loop + 1 < outline.loop_starts.size(); ++loop)
            for (Index i = outline.loop_starts[loop]; i < outline.loop_starts[loop + 1]; ++i)
                if (!visit(i, outline.successor(i, loop))) return false;
        return true;
    }

    /// True when seam i runs with face f on its left along edge `edge`.
    bool leaves_on_left(Index i, FaceHandle f, int edge) const { return vertices_[i] == f->vertex(f->ccw(edge)); }

    /// False when there are too many places that are wound around too often.
    bool flood(CapMesh& cap)
    {
        const std::size_t most = kMostLayers * vertices_.size() + kMostCovered;
        queue_.clear();
        const auto reach = [&](FaceHandle f, int winding) {
            f->info().winding = winding;
            f->info().id = static_cast<Index>(queue_.size());
            queue_.push_back(f);
        };
        reach(triangulation_->infinite_face(), 0);
        for (std::size_t at = 0; at < queue_.size(); ++at) {
            const FaceHandle f = queue_[at];
            const int winding = f->info().winding;
            if (winding != 0) {
                f->info().first = static_cast<Index>(cap.triangles.size());
                const Index a = f->vertex(0)->info(), b = f->vertex(1)->info(), c = f->vertex(2)->info();
                if (winding != 1)
                    for (const Index i : {a, b, c}) cap.shared_points.push_back(i);
                if (cap.triangles.size() + std::size_t(std::abs(winding)) > most) return false;
                for (int copy = 0; copy < std::abs(winding); ++copy)
                    if (winding > 0)
                        cap.triangles.push_back({{a, b, c}, {kNone, kNone, kNone}});
                    else
                        cap.triangles.push_back({{a, c, b}, {kNone, kNone, kNone}});
            }
            for (int edge = 0; edge < 3; ++edge) {
                const FaceHandle g = f->neighbor(edge);
                if (g->info().winding != FaceInfo::kUnknown) continue;
                int across = winding;
                for (Index i = f->info().seam[std::size_t(edge)]; i != kNone; i = seam_next_[i])
                    across += leaves_on_left(i, f, edge) ? -1 : 1;
                reach(g, across);
            }
        }
        return true;
    }

    /// Pairs the half-edges along each edge: those of cap triangles on both sides and the seams' own.
    void link(CapMesh& cap)
    {
        for (const FaceHandle f : queue_)
            for (int edge = 0; edge < 3; ++edge) {
                const FaceHandle g = f->neighbor(edge);
                if (f->info().id > g->info().id) continue;
                const Index seam = f->info().seam[std::size_t(edge)];
                if (f->info().winding == 0 && g->info().winding == 0 && seam == kNone) continue;
                // `along` holds what runs with f on its left, `against` what runs with g on its left; a seam counts as
                // the surface's half-edge, which runs against it.
                along_.clear();
                against_.clear();
                for (Index i = seam; i != kNone; i = seam_next_[i])
                    if (leaves_on_left(i, f, edge)) against_.push_back(kSeamLink + i);
                append_copies(f, edge, along_, against_);
                append_copies(g, triangulation_->mirror_index(f, edge), against_, along_);
                for (Index i = seam; i != kNone; i = seam_next_[i])
                    if (!leaves_on_left(i, f, edge)) along_.push_back(kSeamLink + i);
                for (std::size_t i = 0; i < along_.size() && i < against_.size(); ++i)
                    connect(along_[i], against_[i], cap);
            }
    }

    static void append_copies(FaceHandle f, int edge, std::vector<Index>& left, std::vector<Index>& right)
    {
        // Edge `edge` of a face runs from corner edge + 1; in a triangle turned over it is another one.
        static constexpr std::array<Index, 3> kUpright{1, 2, 0}, kTurned{1, 0, 2};
        const int winding = f->info().winding;
        for (int copy = 0; copy < std::abs(winding); ++copy) {
            const Index t = 3 * (f->info().first + static_cast<Index>(copy));
            if (winding > 0)
                left.push_back(t + kUpright[std::size_t(edge)]);
            else
                right.push_back(t + kTurned[std::size_t(edge)]);
        }
    }

    static void connect(Index a, Index b, CapMesh& cap)
    {
        const bool a_is_seam = (a & kSeamLink) != 0, b_is_seam = (b & kSeamLink) != 0;
        if (!a_is_seam) cap.triangles[a / 3].link[a % 3] = b;
        if (!b_is_seam) cap.triangles[b / 3].link[b % 3] = a;
        if (a_is_seam && b_is_seam) {
            cap.cancelled.push_back({a - kSeamLink, b - kSeamLink});
        }
    }

    Triangulation* triangulation_ = nullptr;              // of the cap under way
    std::vector<std::pair<std::uint32_t, Index>> order_;  // place on the curve, point
    std::vector<VertexHandle> vertices_;
    std::vector<Index> loops_at_;                // by a vertex's point: points of the outline that lie there
    std::vector<std::array<Index, 2>> crossed_;  // seams that are no edges yet
    std::vector<Index> seam_next_;
    std::vector<FaceHandle> queue_;
    std::vector<Index> along_, against_;
};

}  // namespace

std::unique_ptr<CapTriangulator> make_constrained_triangulator()
{
    return std::make_unique<ConstrainedTriangulator>();
}

}  // namespace kerf::halfedge
