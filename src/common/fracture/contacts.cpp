#include "common/fracture/contacts.h"

#include <glm/geometric.hpp>
#include <unordered_map>
#include <utility>

#include "common/caps/section_closer.h"

namespace kerf::core {

namespace {

/// The plane half way between two sites, positive towards the second one.
Plane plane_between(const glm::dvec3& one, const glm::dvec3& other)
{
    const glm::dvec3 towards = other - one;
    const double length = glm::length(towards);
    return {towards / length, 0.5 * (glm::dot(other, other) - glm::dot(one, one)) / length};
}

/// The outlines of all contacts: where the surface borders, and inside.
std::map<SitePair, std::vector<PointStep>> outlines_of(std::span<const InsideEdge> edges, const DividedSurface& surface)
{
    std::map<SitePair, std::vector<PointStep>> outlines = surface.borders;
    for (const auto& [sites, step] : edges) {
        const PointStep back{step.to, step.from};
        // Seen against the edge's direction, the cells turn counter-clockwise; a contact lies on the left of its outline.
        outlines[{sites[0], sites[1]}].push_back(step);
        outlines[{sites[0], sites[2]}].push_back(back);
        outlines[{sites[1], sites[2]}].push_back(step);
    }
    return outlines;
}

class ContactCloser
{
public:
    ContactCloser(std::span<const glm::vec3> points, DividedSurface& surface) : mesh_points_(points), surface_(surface)
    {
    }

    /// False if the outline is not closed.
    bool close(const Plane& plane, std::span<const PointStep> outline, std::vector<PointTriple>& triangles)
    {
        if (!find_loops(outline)) return false;
        caps_.clear();
        closer_.close(plane, loops_, CapQuality::fast, points_, caps_);
        for (std::size_t i = numbers_.size(); i < points_.size(); ++i) {
            numbers_.push_back(static_cast<std::uint32_t>(mesh_points_.size() + surface_.new_points.size()));
            surface_.new_points.push_back(points_[i] + 0.0f);
        }
        for (const CapTriangle& cap : caps_.triangles)
            triangles.push_back({numbers_[cap.corner[0]], numbers_[cap.corner[1]], numbers_[cap.corner[2]]});
        return true;
    }

private:
    bool find_loops(std::span<const PointStep> outline)
    {
        next_.clear();
        points_.clear();
        numbers_.clear();
        loops_.clear();
        for (const PointStep& step : outline)
            if (step.from != step.to && !next_.emplace(step.from, step.to).second) return false;
        for (const PointStep& step : outline) {
            if (!next_.contains(step.from)) continue;
            CapLoop loop{points_.size(), 0, 0};
            std::uint32_t at = step.from;
            for (auto found = next_.find(at); found != next_.end(); found = next_.find(at)) {
                numbers_.push_back(at);
                points_.push_back(position(at));
                at = found->second;
                next_.erase(found);
            }
            if (at != step.from) return false;
            loop.count = points_.size() - loop.first;
            loops_.push_back(loop);
        }
        return true;
    }

    const glm::vec3& position(std::uint32_t point) const
    {
        return point < mesh_points_.size() ? mesh_points_[point] : surface_.new_points[point - mesh_points_.size()];
    }

    std::span<const glm::vec3> mesh_points_;
    DividedSurface& surface_;
    std::unordered_map<std::uint32_t, std::uint32_t> next_;
    std::vector<glm::vec3> points_;
    std::vector<std::uint32_t> numbers_;  ///< of these
    std::vector<CapLoop> loops_;
    SectionCaps caps_;
    SectionCloser closer_;
};

}  // namespace

std::optional<std::vector<Contact>> close_contacts(const CellDiagram& diagram, std::span<const glm::vec3> points,
                                                   std::span<const InsideEdge> edges, DividedSurface& surface,
                                                   const ProgressOfStep& progress)
{
    ContactCloser closer(points, surface);
    std::vector<Contact> contacts;
    const auto outlines = outlines_of(edges, surface);
    constexpr std::size_t kBetweenQuestions = 64;
    for (const auto& [cells, outline] : outlines) {
        if (contacts.size() % kBetweenQuestions == 0) progress.at(double(contacts.size()) / double(outlines.size()));
        const Plane plane = plane_between(diagram.sites[cells[0]], diagram.sites[cells[1]]);
        if (!closer.close(plane, outline, contacts.emplace_back(Contact{cells, plane.normal, {}}).triangles))
            return std::nullopt;
    }
    return contacts;
}

}  // namespace kerf::core
