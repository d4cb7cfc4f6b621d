#include "common/fracture/inside_edges.h"

#include <algorithm>
#include <glm/geometric.hpp>

namespace kerf::core {

namespace {

enum class Place : std::uint8_t
{
    unknown,
    outside,
    inside,
};

Place place_of(bool is_inside)
{
    return is_inside ? Place::inside : Place::outside;
}

class InsideFinder
{
public:
    InsideFinder(const CellDiagram& diagram, std::span<const glm::vec3> points, DividedSurface& surface)
        : diagram_(diagram),
          points_(points),
          surface_(surface),
          places_(diagram.corners.size(), Place::unknown),
          numbers_(diagram.corners.size(), DiagramEdge::kFarAway)
    {
    }

    std::optional<std::vector<InsideEdge>> find()
    {
        std::size_t pierced = 0;
        for (const DiagramEdge& edge : diagram_.edges)
            if (auto* piercings = piercings_of(edge)) {
                ++pierced;
                look_at(edge, *piercings);
            }
        // The surface is pierced where three cells meet, which the diagram knows of.
        if (pierced != surface_.piercings.size()) return std::nullopt;
        spread();
        if (is_contradictory_) return std::nullopt;
        std::vector<InsideEdge> found;
        for (const DiagramEdge& edge : diagram_.edges)
            if (!add_parts(edge, found)) return std::nullopt;
        return found;
    }

private:
    std::vector<Piercing>* piercings_of(const DiagramEdge& edge)
    {
        const auto found = surface_.piercings.find(edge.sites);
        return found == surface_.piercings.end() ? nullptr : &found->second;
    }

    glm::dvec3 position(std::uint32_t point) const
    {
        return glm::dvec3(point < points_.size() ? points_[point] : surface_.new_points[point - points_.size()]);
    }

    void set(std::uint32_t corner, Place place)
    {
        // Far away is outside.
        Place& known = corner == DiagramEdge::kFarAway ? far_away_ : places_[corner];
        if (known == Place::unknown) known = place;
        is_contradictory_ = is_contradictory_ || known != place;
    }

    /// Puts the piercings in order; they tell of both ends.
    void look_at(const DiagramEdge& edge, std::vector<Piercing>& piercings)
    {
        std::ranges::sort(piercings, {},
                          [&](const Piercing& piercing) { return glm::dot(edge.direction, position(piercing.point)); });
        for (std::size_t i = 1; i < piercings.size(); ++i)
            is_contradictory_ = is_contradictory_ || piercings[i].leaves == piercings[i - 1].leaves;
        set(edge.from, place_of(piercings.front().leaves));
        set(edge.to, place_of(!piercings.back().leaves));
    }

    /// Both ends of an edge that does not pierce the surface lie in one place.
    void spread()
    {
        for (bool has_changed = true; has_changed;) {
            has_changed = false;
            for (const DiagramEdge& edge : diagram_.edges) {
                if (piercings_of(edge) != nullptr) continue;
                const Place from = edge.from == DiagramEdge::kFarAway ? far_away_ : places_[edge.from];
                const Place to = edge.to == DiagramEdge::kFarAway ? far_away_ : places_[edge.to];
                if (from == to) continue;
                if (from != Place::unknown) set(edge.to, from);
                if (to != Place::unknown) set(edge.from, to);
                has_changed = !is_contradictory_;
            }
        }
    }

    std::uint32_t number_of(std::uint32_t corner)
    {
        if (numbers_[corner] == DiagramEdge::kFarAway) {
            numbers_[corner] = static_cast<std::uint32_t>(points_.size() + surface_.new_points.size());
            surface_.new_points.push_back(glm::vec3(diagram_.corners[corner].position) + 0.0f);
        }
        return numbers_[corner];
    }

    bool is_inside(std::uint32_t corner) const
    {
        return corner != DiagramEdge::kFarAway && places_[corner] == Place::inside;
    }

    bool add_parts(const DiagramEdge& edge, std::vector<InsideEdge>& found)
    {
        std::vector<std::uint32_t> line;
        if (is_inside(edge.from)) line.push_back(number_of(edge.from));
        if (const auto* piercings = piercings_of(edge))
            for (const Piercing& piercing : *piercings) line.push_back(piercing.point);
        if (is_inside(edge.to)) line.push_back(number_of(edge.to));
        for (std::size_t i = 0; i + 1 < line.size(); i += 2) found.push_back({edge.sites, {line[i], line[i + 1]}});
        return line.size() % 2 == 0;
    }

    const CellDiagram& diagram_;
    std::span<const glm::vec3> points_;
    DividedSurface& surface_;
    std::vector<Place> places_;           ///< of the corners
    std::vector<std::uint32_t> numbers_;  ///< of the points that corners have become
    Place far_away_ = Place::outside;
    bool is_contradictory_ = false;
};

}  // namespace

std::optional<std::vector<InsideEdge>> find_inside_edges(const CellDiagram& diagram, std::span<const glm::vec3> points,
                                                         DividedSurface& surface)
{
    return InsideFinder(diagram, points, surface).find();
}

}  // namespace kerf::core
