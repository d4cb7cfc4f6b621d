#include "common/fracture/near_sites.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace kerf::core {

namespace {

constexpr double kSitesInACell = 2.0;
/// Cells are found by a division that rounds: a site may lie in the next one by this share of a cell's side.
constexpr double kRounding = 1e-6;

}  // namespace

NearSites::NearSites(std::span<const glm::dvec3> sites) : sites_(sites)
{
    glm::dvec3 hi(0.0);
    if (!sites.empty()) lo_ = hi = sites.front();
    for (const glm::dvec3& site : sites) {
        lo_ = glm::min(lo_, site);
        hi = glm::max(hi, site);
    }
    const glm::dvec3 extent = hi - lo_;
    const double longest = std::max({extent.x, extent.y, extent.z});
    // As if they filled the box: flat ones get fewer cells along the axis that they have no extent in.
    const double along = std::ceil(std::cbrt(double(sites.size()) / kSitesInACell));
    // One cell, where there is no extent, or more than a number can say.
    if (longest > 0.0 && std::isfinite(longest)) {
        side_ = longest / along;
        for (int axis = 0; axis < 3; ++axis) size_[std::size_t(axis)] = std::int64_t(extent[axis] / side_) + 1;
    }

    const auto cell_of = [&](const glm::dvec3& point) {
        const Place place = place_of(point);
        return std::size_t((place[2] * size_[1] + place[1]) * size_[0] + place[0]);
    };
    starts_.assign(std::size_t(size_[0] * size_[1] * size_[2]) + 1, 0);
    for (const glm::dvec3& site : sites) ++starts_[cell_of(site) + 1];
    for (std::size_t i = 1; i < starts_.size(); ++i) starts_[i] += starts_[i - 1];
    order_.resize(sites.size());
    std::vector<std::uint32_t> next(starts_.begin(), starts_.end() - 1);
    for (std::uint32_t i = 0; i < sites.size(); ++i) order_[next[cell_of(sites[i])]++] = i;
}

NearSites::Place NearSites::place_of(const glm::dvec3& point) const
{
    Place place{};
    for (int axis = 0; axis < 3; ++axis) {
        const std::size_t i = std::size_t(axis);
        if (size_[i] > 1)
            place[i] = std::clamp(std::int64_t((point[axis] - lo_[axis]) / side_), std::int64_t(0), size_[i] - 1);
    }
    return place;
}

void NearSites::around(std::uint32_t site)
{
    site_ = site;
    middle_ = place_of(sites_[site]);
    shell_ = 0;
    found_.clear();
    taken_ = sorted_ = 0;
}

void NearSites::take_row(const Place& first, std::int64_t cells)
{
    const auto begin = std::size_t((first[2] * size_[1] + first[1]) * size_[0] + first[0]);
    for (std::uint32_t i = starts_[begin]; i < starts_[begin + std::size_t(cells)]; ++i) {
        const std::uint32_t other = order_[i];
        if (other == site_) continue;
        const glm::dvec3 away = sites_[other] - sites_[site_];
        found_.emplace_back(glm::dot(away, away), other);
    }
}

/// The cells that are `shell_` cells away along some axis, and no farther along the others.
void NearSites::take_shell()
{
    const std::int64_t r = shell_++;
    const auto from = [&](std::size_t axis) { return std::max(middle_[axis] - r, std::int64_t(0)); };
    const auto to = [&](std::size_t axis) { return std::min(middle_[axis] + r, size_[axis] - 1); };
    for (std::int64_t z = from(2); z <= to(2); ++z)
        for (std::int64_t y = from(1); y <= to(1); ++y) {
            if (std::abs(z - middle_[2]) == r || std::abs(y - middle_[1]) == r) {
                take_row({from(0), y, z}, to(0) - from(0) + 1);
                continue;
            }
            if (middle_[0] - r >= 0) take_row({middle_[0] - r, y, z}, 1);
            if (middle_[0] + r < size_[0]) take_row({middle_[0] + r, y, z}, 1);
        }
}

bool NearSites::next(std::pair<double, std::uint32_t>& found)
{
    while (taken_ == sorted_) {
        const bool is_last = shell_ > std::max({size_[0], size_[1], size_[2]});
        if (is_last && taken_ == found_.size()) return false;
        if (!is_last) take_shell();
        // What is nearer than the cells beyond is all there.
        const double reach = std::max(0.0, (double(shell_ - 1) - kRounding) * side_);
        const auto first = found_.begin() + std::ptrdiff_t(taken_);
        const auto end =
            is_last ? found_.end()
                    : std::partition(first, found_.end(), [&](const auto& one) { return one.first < reach * reach; });
        std::sort(first, end);
        sorted_ = std::size_t(end - found_.begin());
    }
    found = found_[taken_++];
    return true;
}

}  // namespace kerf::core
