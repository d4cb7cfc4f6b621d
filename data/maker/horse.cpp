// The chess knight: a horse's head drawn in profile, with a relief of half thicknesses for its sides, on a turned foot.

#include <algorithm>
#include <array>

#include "maker/delaunay.h"
#include "maker/facets.h"
#include "maker/lathe.h"
#include "maker/models.h"

namespace kerf::maker {
namespace {

/// A point of the profile: forwards, up, and how far the surface stands off the plane of symmetry there.
struct ProfilePoint
{
    double z, y, thickness;
};

constexpr double kFootHeight = 0.62;

// From the back of the neck's foot over mane, ears, nose, mouth and throat to the chest.
constexpr std::array<ProfilePoint, 34> kOutline{{
    {-0.53, kFootHeight, 0.22}, {-0.60, 0.88, 0.19},       {-0.66, 1.10, 0.13}, {-0.76, 1.27, 0.08},
    {-0.65, 1.38, 0.09},        {-0.76, 1.58, 0.08},       {-0.63, 1.69, 0.09}, {-0.69, 1.88, 0.08},
    {-0.55, 1.98, 0.09},        {-0.55, 2.15, 0.08},       {-0.41, 2.21, 0.10}, {-0.30, 2.36, 0.15},
    {-0.17, 2.66, 0.20},        {-0.01, 2.41, 0.16},       {0.14, 2.34, 0.15},  {0.28, 2.22, 0.14},
    {0.44, 2.00, 0.12},         {0.61, 1.80, 0.12},        {0.80, 1.62, 0.13},  {0.93, 1.47, 0.14},
    {0.94, 1.31, 0.14},         {0.85, 1.21, 0.12},        {0.62, 1.29, 0.10},  {0.79, 1.13, 0.11},
    {0.72, 1.01, 0.11},         {0.57, 1.00, 0.11},        {0.42, 1.09, 0.11},  {0.26, 1.15, 0.13},
    {0.12, 1.24, 0.15},         {0.07, 1.15, 0.19},        {0.18, 1.00, 0.23},  {0.32, 0.88, 0.26},
    {0.43, 0.75, 0.27},         {0.49, kFootHeight, 0.27},
}};
constexpr std::size_t kEarTip = 12;

// The foot of the sides, from the chest backwards.
constexpr std::array<ProfilePoint, 3> kSkirt{
    {{0.28, kFootHeight, 0.42}, {0.0, kFootHeight, 0.47}, {-0.30, kFootHeight, 0.41}}};

constexpr std::array<ProfilePoint, 35> kRelief{{
    {0.80, 1.45, 0.22},  {0.65, 1.57, 0.18},  {0.68, 1.38, 0.17},  {0.62, 1.14, 0.16},  // muzzle
    {0.24, 1.62, 0.33},  {0.10, 1.48, 0.32},  {0.30, 1.40, 0.30},  {0.10, 1.76, 0.32},
    {0.36, 1.68, 0.30},  // cheek
    {0.00, 1.62, 0.31},  {0.16, 1.32, 0.24},  {0.46, 1.80, 0.20},  {0.50, 1.55, 0.22},
    {0.48, 1.33, 0.18},                                                                 // bridge of the nose
    {0.20, 2.07, 0.30},  {0.27, 1.96, 0.21},  {0.30, 1.84, 0.27},  {0.10, 1.97, 0.27},  // eye under its brow
    {0.04, 2.22, 0.25},  {-0.14, 2.12, 0.26}, {-0.10, 1.88, 0.27}, {-0.14, 1.55, 0.27},
    {-0.12, 1.30, 0.33}, {-0.10, 1.05, 0.40}, {-0.08, 0.82, 0.43},  // neck
    {-0.36, 2.04, 0.20}, {-0.42, 1.86, 0.24}, {-0.46, 1.64, 0.24}, {-0.46, 1.40, 0.25},
    {-0.44, 1.14, 0.31},  // mane
    {-0.40, 0.86, 0.39}, {-0.57, 1.50, 0.15}, {-0.57, 1.78, 0.14}, {0.19, 0.87, 0.38},
    {0.33, 0.74, 0.37},  // chest
}};

}  // namespace

PolyMesh make_horse()
{
    PolyMesh mesh;
    Lathe lathe(mesh, 16, "ivory");
    Profile profile(0.9, 0.0);
    profile.line(0.9, 0.16).arc(0.78, 0.44, 0.4, 2).line(0.7, kFootHeight);
    const Ring bottom = lathe.ring(0.9, 0.0, 0.0);
    lathe.disc(bottom, false);
    const Ring top = lathe.turn(bottom, profile);

    // Both sides have the outline, the skirt and the relief, in this order.
    std::vector<ProfilePoint> all(kOutline.begin(), kOutline.end());
    all.insert(all.end(), kSkirt.begin(), kSkirt.end());
    const std::size_t border = all.size();
    all.insert(all.end(), kRelief.begin(), kRelief.end());
    std::array<std::vector<int>, 2> side;  // on +x and -x
    std::vector<glm::dvec2> polygon, inside;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const ProfilePoint& p = all[i];
        side[0].push_back(mesh.add_point({p.thickness, p.y, p.z}));
        side[1].push_back(mesh.add_point({-p.thickness, p.y, p.z}));
        // Seen from +x, forwards is to the left, and the outline runs counter-clockwise.
        (i < border ? polygon : inside).push_back({-p.z, p.y});
    }
    for (const auto& t : delaunay(polygon, inside)) {
        const auto a = std::size_t(t[0]), b = std::size_t(t[1]), c = std::size_t(t[2]);
        mesh.add_facet({side[0][a], side[0][b], side[0][c]}, "ivory");
        mesh.add_facet({side[1][c], side[1][b], side[1][a]}, "ivory");
    }

    // The strip between the sides; at the ears it dips to a notch between two tips.
    const int notch = mesh.add_point({0.0, 2.40, -0.16});
    for (std::size_t i = 0; i + 1 < kOutline.size(); ++i) {
        const int a = side[0][i + 1], b = side[0][i], c = side[1][i], d = side[1][i + 1];
        if (i + 1 == kEarTip || i == kEarTip) {
            mesh.add_facet({a, b, notch}, "ivory");
            mesh.add_facet({c, d, notch}, "ivory");
            if (i == kEarTip) mesh.add_facet({d, a, notch}, "ivory");
            if (i + 1 == kEarTip) mesh.add_facet({b, c, notch}, "ivory");
        } else {
            mesh.add_facet({a, b, c, d}, "ivory");
        }
    }

    std::vector<int> foot;  // round the neck, clockwise seen from above
    foot.push_back(side[0][kOutline.size() - 1]);
    foot.push_back(side[1][kOutline.size() - 1]);
    for (std::size_t i = 0; i < kSkirt.size(); ++i) foot.push_back(side[1][kOutline.size() + i]);
    foot.push_back(side[1][0]);
    foot.push_back(side[0][0]);
    for (std::size_t i = kSkirt.size(); i-- > 0;) foot.push_back(side[0][kOutline.size() + i]);
    bridge(mesh, top.points, reversed(foot), "ivory");
    pair_triangles(mesh, 25.0);
    mesh.fit(2.0);
    return mesh;
}

}  // namespace kerf::maker
