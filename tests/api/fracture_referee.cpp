#include "api/fracture_referee.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace kerf::test {

namespace {

Place place_of(const Vec3f& p)
{
    return {p.x, p.y, p.z};
}

/// The triangle from its first corner in space on.
Corners turned(Corners corners)
{
    std::rotate(corners.begin(), std::ranges::min_element(corners), corners.end());
    return corners;
}

Corners reversed(const Corners& corners)
{
    return turned({corners[0], corners[2], corners[1]});
}

std::array<double, 3> cross_of(const Corners& t)
{
    std::array<double, 3> e{}, f{};
    for (std::size_t i = 0; i < 3; ++i) {
        e[i] = double(t[1][i]) - double(t[0][i]);
        f[i] = double(t[2][i]) - double(t[0][i]);
    }
    return {e[1] * f[2] - e[2] * f[1], e[2] * f[0] - e[0] * f[2], e[0] * f[1] - e[1] * f[0]};
}

double area_of(const Corners& t)
{
    const auto [x, y, z] = cross_of(t);
    return 0.5 * std::sqrt(x * x + y * y + z * z);
}

double volume_below(const Corners& t)
{
    const auto [x, y, z] = cross_of(t);
    return (double(t[0][0]) * x + double(t[0][1]) * y + double(t[0][2]) * z) / 6.0;
}

/// Whether edges and their reverses cancel.
bool is_closed(const std::vector<Corners>& triangles)
{
    std::vector<std::pair<std::array<Place, 2>, int>> edges;
    edges.reserve(3 * triangles.size());
    for (const Corners& corners : triangles)
        for (std::size_t i = 0; i < 3; ++i) {
            const Place &a = corners[i], &b = corners[(i + 1) % 3];
            if (a < b)
                edges.push_back({{a, b}, 1});
            else
                edges.push_back({{b, a}, -1});
        }
    std::ranges::sort(edges);
    for (std::size_t first = 0, last; first < edges.size(); first = last) {
        int balance = 0;
        for (last = first; last < edges.size() && edges[last].first == edges[first].first; ++last)
            balance += edges[last].second;
        if (balance != 0) return false;
    }
    return true;
}

}  // namespace

Triangles::Triangles(const Object& object)
{
    const Mesh mesh = *object.mesh();
    const MeshArrays arrays = mesh.arrays();
    std::vector<Corners> all;
    for (std::size_t t = 0; t < arrays.kinds.size(); ++t) {
        Corners corners;
        for (std::size_t i = 0; i < 3; ++i) corners[i] = place_of(arrays.positions[arrays.indices[3 * t + i]]);
        all.push_back(turned(corners));
        (arrays.kinds[t] == TriangleKind::cap ? caps : surface).push_back(all.back());
        volume += volume_below(corners);
    }
    closed = is_closed(all);
}

void expect_full(const Object& whole, Fracture& fracture)
{
    ASSERT_EQ(fracture.status(), Status::done) << fracture.reason();
    double volume = 0.0;
    for (std::uint32_t i = 0; i < fracture.count(); ++i) {
        const Triangles piece(*fracture.piece(i));
        EXPECT_TRUE(piece.closed) << "piece " << i;
        EXPECT_GT(piece.volume, 0.0) << "piece " << i;
        EXPECT_NEAR(fracture.piece(i)->mass_properties().volume, piece.volume, 1e-6 * piece.volume + 1e-12);
        EXPECT_FALSE(fracture.cells(i).empty());
        volume += piece.volume;
    }
    const double expected = Triangles(whole).volume;
    EXPECT_NEAR(volume, expected, 1e-6 * expected);
}

void expect_right(const Object& whole, Fracture& fracture)
{
    expect_full(whole, fracture);
    if (testing::Test::HasFatalFailure()) return;
    std::map<Corners, std::vector<std::uint32_t>> caps;
    for (std::uint32_t i = 0; i < fracture.count(); ++i)
        for (const Corners& cap : Triangles(*fracture.piece(i)).caps) caps[cap].push_back(i);

    // Each cap is there turned over, on another piece; their areas are those of the bonds.
    std::map<std::array<std::uint32_t, 2>, double> areas;
    for (const auto& [cap, of] : caps) {
        const auto across = caps.find(reversed(cap));
        ASSERT_NE(across, caps.end()) << "a cap of piece " << of.front() << " faces nothing";
        ASSERT_EQ(of.size(), 1u);
        ASSERT_EQ(across->second.size(), 1u);
        EXPECT_NE(of.front(), across->second.front());
        if (of.front() < across->second.front()) areas[{of.front(), across->second.front()}] += area_of(cap);
    }
    for (const FractureBond& bond : fracture.bonds()) {
        ASSERT_LT(bond.first, bond.second);
        ASSERT_LT(bond.second, fracture.count());
        const auto found = areas.find({bond.first, bond.second});
        const double seen = found == areas.end() ? 0.0 : found->second;
        EXPECT_NEAR(bond.area, seen, 1e-6 * seen + 1e-12) << bond.first << " and " << bond.second;
        if (found != areas.end()) areas.erase(found);
    }
    EXPECT_TRUE(areas.empty()) << "pieces touch without a bond";
}

}  // namespace kerf::test
