#include "common/fracture/cell_diagram.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <map>
#include <utility>

#include "common/fracture/near_sites.h"

namespace kerf::core {

namespace {

/// Cells are cut off that far beyond the sites and the solid, as a share of the diagonal: farther than rounding moves a
/// corner, and so near that cells at the rim soon have all their neighbours.
constexpr double kMargin = 0.01;

/// A plane of a cell: half way to a site, or a side of the box, which is negative.
using PlaneName = std::int64_t;

struct CellCorner
{
    glm::dvec3 position;
    std::array<PlaneName, 3> planes;
};

/// A run of numbers in a list.
struct CellFace
{
    PlaneName plane;
    std::size_t first = 0, count = 0;
};

/// A convex body.
struct Cell
{
    std::vector<CellCorner> corners;
    std::vector<CellFace> faces;
    std::vector<std::size_t> around;  ///< corners of the faces, each counter-clockwise, seen from outside

    std::span<const std::size_t> corners_of(const CellFace& face) const
    {
        return std::span(around).subspan(face.first, face.count);
    }

    void begin_face(PlaneName plane) { faces.push_back({plane, around.size(), 0}); }
    void add_corner(std::size_t corner)
    {
        around.push_back(corner);
        ++faces.back().count;
    }
    /// A face that has fewer than three corners is none.
    void end_face()
    {
        if (faces.back().count > 2) return;
        around.resize(faces.back().first);
        faces.pop_back();
    }

    double squared_radius(const glm::dvec3& centre) const
    {
        double most = 0.0;
        for (const CellCorner& corner : corners) {
            const glm::dvec3 away = corner.position - centre;
            most = std::max(most, glm::dot(away, away));
        }
        return most;
    }
};

Cell box_cell(const glm::dvec3& lo, const glm::dvec3& hi)
{
    Cell cell;
    for (int i = 0; i < 8; ++i) {
        const bool x = (i & 1) != 0, y = (i & 2) != 0, z = (i & 4) != 0;
        cell.corners.push_back(
            {{x ? hi.x : lo.x, y ? hi.y : lo.y, z ? hi.z : lo.z}, {x ? -2 : -1, y ? -4 : -3, z ? -6 : -5}});
    }
    constexpr std::array<std::array<std::size_t, 4>, 6> kSides{
        {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};
    for (std::size_t side = 0; side < kSides.size(); ++side) {
        cell.begin_face(-1 - static_cast<PlaneName>(side));
        for (const std::size_t corner : kSides[side]) cell.add_corner(corner);
    }
    return cell;
}

/// Cuts cells off. Its lists are used again, because there are some thirty cuts a cell.
class CellCutter
{
public:
    /// Cuts off what lies beyond a plane through a point, where its normal leads. Whether that is anything.
    bool cut(Cell& cell, PlaneName plane, const glm::dvec3& point, const glm::dvec3& normal)
    {
        // (The difference first: sites may be nearer to one another than the squares of their coordinates tell.)
        const auto height = [&](const CellCorner& corner) { return glm::dot(normal, corner.position - point); };
        if (std::ranges::none_of(cell.corners, [&](const CellCorner& corner) { return height(corner) > 0.0; }))
            return false;
        heights_.clear();
        for (const CellCorner& corner : cell.corners) heights_.push_back(height(corner));
        made_.clear();
        lid_.clear();
        rest_.faces.clear();
        rest_.around.clear();
        for (const CellFace& face : cell.faces) cut_face(cell, face, plane);
        add_lid(plane);
        cell.faces.swap(rest_.faces);
        cell.around.swap(rest_.around);
        drop_unused(cell);
        return true;
    }

private:
    struct Made
    {
        std::size_t a, b, corner;
    };
    struct LidStep
    {
        std::size_t from, to;
    };

    void cut_face(Cell& cell, const CellFace& face, PlaneName plane)
    {
        rest_.begin_face(face.plane);
        LidStep step{};
        bool is_crossed = false;
        for (std::size_t i = 0; i < face.count; ++i) {
            const std::size_t a = cell.around[face.first + i], b = cell.around[face.first + (i + 1) % face.count];
            const bool keeps_a = heights_[a] <= 0.0, keeps_b = heights_[b] <= 0.0;
            if (keeps_a) rest_.add_corner(a);
            if (keeps_a == keeps_b) continue;
            is_crossed = true;
            const std::size_t between = corner_between(cell, a, b, plane);
            (keeps_a ? step.to : step.from) = between;
            rest_.add_corner(between);
        }
        if (is_crossed) lid_.push_back(step);
        rest_.end_face();
    }

    /// The new face runs along the others the other way.
    void add_lid(PlaneName plane)
    {
        if (lid_.empty()) return;
        rest_.begin_face(plane);
        std::size_t at = lid_.front().from;
        for (std::size_t i = 0; i < lid_.size(); ++i) {
            rest_.add_corner(at);
            const auto step = std::ranges::find(lid_, at, &LidStep::from);
            if (step == lid_.end() || step->to == lid_.front().from) break;
            at = step->to;
        }
        rest_.end_face();
    }

    std::size_t corner_between(Cell& cell, std::size_t a, std::size_t b, PlaneName plane)
    {
        if (heights_[a] > 0.0) std::swap(a, b);
        const auto known = std::ranges::find_if(made_, [&](const Made& m) { return m.a == a && m.b == b; });
        if (known != made_.end()) return known->corner;
        const CellCorner &in = cell.corners[a], &out = cell.corners[b];
        const double t = heights_[a] / (heights_[a] - heights_[b]);
        CellCorner corner{in.position + t * (out.position - in.position), {plane, plane, plane}};
        std::size_t common = 0;
        for (const PlaneName p : in.planes)
            if (common < 2 && std::ranges::find(out.planes, p) != out.planes.end()) corner.planes[common++] = p;
        made_.push_back({a, b, cell.corners.size()});
        cell.corners.push_back(corner);
        return made_.back().corner;
    }

    void drop_unused(Cell& cell)
    {
        const std::size_t none = cell.corners.size();
        number_.assign(cell.corners.size(), none);
        rest_.corners.clear();
        for (std::size_t& corner : cell.around) {
            if (number_[corner] == none) {
                number_[corner] = rest_.corners.size();
                rest_.corners.push_back(cell.corners[corner]);
            }
            corner = number_[corner];
        }
        cell.corners.swap(rest_.corners);
    }

    Cell rest_;  ///< what is left of the cell
    std::vector<double> heights_;
    std::vector<Made> made_;
    std::vector<LidStep> lid_;
    std::vector<std::size_t> number_;
};

void cut_to_cell(std::uint32_t site, std::span<const glm::dvec3> sites, NearSites& near, CellCutter& cutter, Cell& cell)
{
    near.around(site);
    double reach = 4.0 * cell.squared_radius(sites[site]);
    std::pair<double, std::uint32_t> next;
    while (near.next(next)) {
        const auto& [squared, other] = next;
        if (squared > reach) break;
        const glm::dvec3 towards = sites[other] - sites[site];
        if (cutter.cut(cell, other, sites[site] + 0.5 * towards, towards))
            reach = 4.0 * cell.squared_radius(sites[site]);
    }
}

/// A corner's sites with the cell's own, or nothing at the box.
std::optional<SiteQuadruple> sites_of(const CellCorner& corner, std::uint32_t site)
{
    SiteQuadruple sites{site, 0, 0, 0};
    for (std::size_t i = 0; i < 3; ++i) {
        if (corner.planes[i] < 0) return std::nullopt;
        sites[i + 1] = static_cast<std::uint32_t>(corner.planes[i]);
    }
    std::ranges::sort(sites);
    return sites;
}

/// Puts the parts that cells have in common together.
class DiagramMaker
{
public:
    explicit DiagramMaker(std::span<const glm::dvec3> sites) { diagram_.sites.assign(sites.begin(), sites.end()); }

    void add(std::uint32_t site, const Cell& cell)
    {
        std::vector<std::uint32_t>& neighbours = diagram_.neighbours.emplace_back();
        for (const CellFace& face : cell.faces)
            if (face.plane >= 0) neighbours.push_back(static_cast<std::uint32_t>(face.plane));
        std::ranges::sort(neighbours);
        for (const CellCorner& corner : cell.corners) {
            const auto sites = sites_of(corner, site);
            if (!sites) continue;
            auto& [position, cells] = corners_.try_emplace(*sites, corner.position, 0).first->second;
            ++cells;
        }
        for (const CellFace& face : cell.faces)
            for (std::size_t i = 0; face.plane >= 0 && i < face.count; ++i) {
                const std::span<const std::size_t> corners = cell.corners_of(face);
                add_edge(site, face.plane, cell.corners[corners[i]], cell.corners[corners[(i + 1) % face.count]]);
            }
    }

    std::optional<CellDiagram> take()
    {
        std::map<SiteQuadruple, std::uint32_t> numbers;
        for (const auto& [sites, corner] : corners_) {
            if (corner.second != 4) return std::nullopt;
            numbers[sites] = static_cast<std::uint32_t>(diagram_.corners.size());
            diagram_.corners.push_back({sites, corner.first});
        }
        for (auto& [sites, edge] : edges_) {
            for (auto [end, number] : {std::pair{&edge.ends[0], &edge.edge.from}, {&edge.ends[1], &edge.edge.to}})
                if (*end) *number = numbers.at(**end);
            diagram_.edges.push_back(edge.edge);
        }
        return std::move(diagram_);
    }

private:
    struct Edge
    {
        DiagramEdge edge;
        std::array<std::optional<SiteQuadruple>, 2> ends;
    };

    void add_edge(std::uint32_t site, PlaneName plane, const CellCorner& a, const CellCorner& b)
    {
        // The other plane that both lie in; along the box it is a side of it.
        const auto other = std::ranges::find_if(
            a.planes, [&](PlaneName p) { return p != plane && std::ranges::find(b.planes, p) != b.planes.end(); });
        if (other == a.planes.end() || *other < 0) return;
        SiteTriple sites{site, static_cast<std::uint32_t>(plane), static_cast<std::uint32_t>(*other)};
        std::ranges::sort(sites);
        if (sites[0] != site) return;  // once is enough
        Edge edge;
        edge.edge.sites = sites;
        edge.edge.direction = glm::cross(diagram_.sites[sites[1]] - diagram_.sites[site],
                                         diagram_.sites[sites[2]] - diagram_.sites[site]);
        const bool is_forward = glm::dot(edge.edge.direction, b.position - a.position) >= 0.0;
        edge.ends = {sites_of(is_forward ? a : b, site), sites_of(is_forward ? b : a, site)};
        edges_.try_emplace(sites, edge);
    }

    CellDiagram diagram_;
    std::map<SiteQuadruple, std::pair<glm::dvec3, int>> corners_;  ///< with the number of cells that have it
    std::map<SiteTriple, Edge> edges_;
};

}  // namespace

std::optional<CellDiagram> make_cell_diagram(std::span<const glm::dvec3> sites, const Box& bounds,
                                             const ProgressOfStep& progress)
{
    glm::dvec3 lo(bounds.lo), hi(bounds.hi);
    for (const glm::dvec3& site : sites) {
        lo = glm::min(lo, site);
        hi = glm::max(hi, site);
    }
    const glm::dvec3 margin(kMargin * glm::length(hi - lo));
    const Cell whole = box_cell(lo - margin, hi + margin);
    DiagramMaker maker(sites);
    NearSites near(sites);
    CellCutter cutter;
    Cell cell;
    constexpr std::uint32_t kBetweenQuestions = 64;
    for (std::uint32_t site = 0; site < sites.size(); ++site) {
        if (site % kBetweenQuestions == 0) progress.at(double(site) / double(sites.size()));
        cell = whole;
        cut_to_cell(site, sites, near, cutter, cell);
        maker.add(site, cell);
    }
    return maker.take();
}

}  // namespace kerf::core
