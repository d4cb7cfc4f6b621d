#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <utility>
#include <vector>

namespace kerf::core {

/// Sites by their distance from one of them, the nearest first: a grid of about two sites a cell, which is looked at in
/// shells around it (Bentley, Weide and Yao, "Optimal expected-time algorithms for closest point problems", 1980). As long
/// as few are asked for, O(1) each for sites that are spread evenly; O(m) for m sites in one cell.
class NearSites
{
public:
    /// @param sites  outlive this. O(m)
    explicit NearSites(std::span<const glm::dvec3> sites);

    /// Begins with the neighbours of a site.
    void around(std::uint32_t site);
    /// The next nearest one and its squared distance; of equal ones the smaller number. False: there is none left.
    bool next(std::pair<double, std::uint32_t>& found);

private:
    using Place = std::array<std::int64_t, 3>;  ///< a cell of the grid

    Place place_of(const glm::dvec3& point) const;
    void take_shell();
    void take_row(const Place& first, std::int64_t cells);

    std::span<const glm::dvec3> sites_;
    glm::dvec3 lo_{0.0};
    double side_ = 1.0;                          ///< of a cell
    Place size_{1, 1, 1};                        ///< cells along each axis
    std::vector<std::uint32_t> starts_, order_;  ///< sites by cells

    std::uint32_t site_ = 0;
    Place middle_{};
    std::int64_t shell_ = 0;  ///< the next one
    /// Of the shells so far, by distance from `taken_` on; the others come in no order.
    std::vector<std::pair<double, std::uint32_t>> found_;
    std::size_t taken_ = 0, sorted_ = 0;
};

}  // namespace kerf::core
