#include "common/fracture/cell_diagram.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <map>
#include <numeric>
#include <utility>

#include "common/fracture/near_sites.h"

namespace kerf::core {

namespace {

/// A plane of a cell: half way to a site, or a side of the box, which is negative.
using PlaneName = std::int64_t;

struct CellCorner
{
    glm::dvec3 position;
    std::array<PlaneName, 3> planes;
};

struct CellFace
{
    PlaneName plane;
    std::vector<std::size_t> corners;  ///< counter-clockwise, seen from outside
};

/// A convex body.
struct Cell
{
    std::vector<CellCorner> corners;
    std::vector<CellFace> faces;

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
    cell.faces = {{-1, {0, 4, 6, 2}}, {-2, {1, 3, 7, 5}}, {-3, {0, 1, 5, 4}},
                  {-4, {2, 6, 7, 3}}, {-5, {0, 2, 3, 1}}, {-6, {4, 5, 7, 6}}};
    return cell;
}

/// Cuts off what lies where the heights are above 0.
class CellCutter
{
public:
    CellCutter(Cell& cell, PlaneName plane, std::vector<double> heights)
        : cell_(cell), plane_(plane), heights_(std::move(heights))
    {
    }

    void cut()
    {
        std::vector<CellFace> kept;
        std::map<std::size_t, std::size_t> next;  // along the new face
        for (CellFace& face : cell_.faces) {
            CellFace rest{face.plane, {}};
            std::size_t leaves = 0, enters = 0;
            bool is_crossed = false;
            for (std::size_t i = 0; i < face.corners.size(); ++i) {
                const std::size_t a = face.corners[i], b = face.corners[(i + 1) % face.corners.size()];
                const bool keeps_a = heights_[a] <= 0.0, keeps_b = heights_[b] <= 0.0;
                if (keeps_a) rest.corners.push_back(a);
                if (keeps_a == keeps_b) continue;
                is_crossed = true;
                (keeps_a ? leaves : enters) = corner_between(a, b);
                rest.corners.push_back(keeps_a ? leaves : enters);
            }
            if (is_crossed) next[enters] = leaves;
            if (rest.corners.size() > 2) kept.push_back(std::move(rest));
        }
        if (!next.empty()) {
            CellFace lid{plane_, {}};
            const std::size_t first = next.begin()->first;
            for (std::size_t at = first; lid.corners.empty() || (at != first && lid.corners.size() < next.size());) {
                lid.corners.push_back(at);
                at = next[at];
            }
            kept.push_back(std::move(lid));
        }
        cell_.faces = std::move(kept);
        drop_unused();
    }

private:
    std::size_t corner_between(std::size_t a, std::size_t b)
    {
        const auto [place, is_new] = made_.try_emplace(std::minmax(a, b), cell_.corners.size());
        if (!is_new) return place->second;
        if (heights_[a] > 0.0) std::swap(a, b);
        const CellCorner &in = cell_.corners[a], &out = cell_.corners[b];
        const double t = heights_[a] / (heights_[a] - heights_[b]);
        CellCorner corner{in.position + t * (out.position - in.position), {plane_, plane_, plane_}};
        std::size_t common = 0;
        for (const PlaneName p : in.planes)
            if (common < 2 && std::ranges::find(out.planes, p) != out.planes.end()) corner.planes[common++] = p;
        cell_.corners.push_back(corner);
        heights_.push_back(0.0);
        return place->second;
    }

    void drop_unused()
    {
        std::vector<std::size_t> number(cell_.corners.size(), cell_.corners.size());
        std::vector<CellCorner> used;
        for (CellFace& face : cell_.faces)
            for (std::size_t& corner : face.corners) {
                if (number[corner] == cell_.corners.size()) {
                    number[corner] = used.size();
                    used.push_back(cell_.corners[corner]);
                }
                corner = number[corner];
            }
        cell_.corners = std::move(used);
    }

    Cell& cell_;
    PlaneName plane_;
    std::vector<double> heights_;
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> made_;
};

Cell cell_of(std::uint32_t site, std::span<const glm::dvec3> sites, NearSites& near, Cell cell)
{
    near.around(site);
    std::pair<double, std::uint32_t> next;
    while (near.next(next)) {
        const auto& [squared, other] = next;
        if (squared > 4.0 * cell.squared_radius(sites[site])) break;
        const glm::dvec3 towards = sites[other] - sites[site];
        const double half_way = 0.5 * (glm::dot(sites[other], sites[other]) - glm::dot(sites[site], sites[site]));
        std::vector<double> heights;
        for (const CellCorner& corner : cell.corners) heights.push_back(glm::dot(towards, corner.position) - half_way);
        if (std::ranges::any_of(heights, [](double height) { return height > 0.0; }))
            CellCutter(cell, other, std::move(heights)).cut();
    }
    return cell;
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
            for (std::size_t i = 0; face.plane >= 0 && i < face.corners.size(); ++i)
                add_edge(site, face.plane, cell.corners[face.corners[i]],
                         cell.corners[face.corners[(i + 1) % face.corners.size()]]);
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

std::optional<CellDiagram> make_cell_diagram(std::span<const glm::dvec3> sites, const Box& bounds)
{
    glm::dvec3 lo(bounds.lo), hi(bounds.hi);
    for (const glm::dvec3& site : sites) {
        lo = glm::min(lo, site);
        hi = glm::max(hi, site);
    }
    const glm::dvec3 margin(glm::length(hi - lo));
    const Cell whole = box_cell(lo - margin, hi + margin);
    DiagramMaker maker(sites);
    NearSites near(sites);
    for (std::uint32_t site = 0; site < sites.size(); ++site) maker.add(site, cell_of(site, sites, near, whole));
    return maker.take();
}

}  // namespace kerf::core
