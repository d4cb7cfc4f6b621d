// A saloon car in one shell: a grid of stations along the car and rows round its section, mirrored; panels sunk into
// it; wheels that hang on their axles in the wheel wells. Metres; z points forward, the ground is y = 0.

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <numbers>

#include "maker/facets.h"
#include "maker/lathe.h"
#include "maker/models.h"
#include "maker/panels.h"

namespace kerf::maker {
namespace {

constexpr double kWheelBase = 1.36;    // half, from the middle to an axle
constexpr double kWheelHeight = 0.33;  // of the axle
constexpr double kArchRadius = 0.4;
constexpr double kWellDepth = 0.6;  // x of the wall at the wheel's back
constexpr int kArchSegments = 8;

struct Key
{
    double z, value;
};

/// Through the keys, straight between them.
double polyline(const std::vector<Key>& keys, double z)
{
    std::size_t k = 1;
    while (k + 1 < keys.size() && keys[k].z < z) ++k;
    const Key &a = keys[k - 1], &b = keys[k];
    return glm::mix(a.value, b.value, std::clamp((z - a.z) / (b.z - a.z), 0.0, 1.0));
}

/// The rows of the section, from the middle of the floor outwards and up to the middle of the roof.
enum Row
{
    kFloor,
    kWellFoot,  ///< coincides with kWellTop where there is no wheel
    kWellTop,
    kSill,
    kFlank,
    kShoulder,
    kBelt,    ///< lower edge of the side windows; edge of the bonnet
    kRail,    ///< upper edge of the side windows
    kPillar,  ///< edge of windscreen and rear window
    kCrown,
    kRidge,
    kRows
};

/// Height of the wheel arch over the axle's station, or of the sill.
double arch_height(double z, double sill)
{
    const double along = std::abs(std::abs(z) - kWheelBase);
    if (along >= kArchRadius - 1e-9) return sill;
    return kWheelHeight + std::sqrt(kArchRadius * kArchRadius - along * along);
}

std::array<glm::dvec3, kRows> section(double z)
{
    const double width = polyline({{-2.26, 0.70},
                                   {-2.2, 0.80},
                                   {-2.02, 0.855},
                                   {-1.36, 0.885},
                                   {-0.6, 0.895},
                                   {0.6, 0.895},
                                   {1.36, 0.88},
                                   {1.9, 0.845},
                                   {2.12, 0.775},
                                   {2.24, 0.63}},
                                  z);
    const double bottom =
        polyline({{-2.26, 0.36}, {-2.02, 0.30}, {-1.76, 0.25}, {1.76, 0.25}, {2.12, 0.25}, {2.24, 0.28}}, z);
    const double belt = polyline({{-2.26, 0.90},
                                  {-2.2, 0.955},
                                  {-1.76, 0.975},
                                  {-0.9, 0.965},
                                  {0.96, 0.90},
                                  {1.36, 0.865},
                                  {1.9, 0.80},
                                  {2.12, 0.74},
                                  {2.24, 0.70}},
                                 z);
    const double shoulder = belt - polyline({{-2.26, 0.22}, {-2.02, 0.16}, {-1.6, 0.10}, {1.6, 0.10}, {2.24, 0.13}}, z);
    const double ridge = polyline({{-2.26, 0.93},
                                   {-2.2, 1.0},
                                   {-1.512, 1.035},
                                   {-0.74, 1.385},
                                   {-0.35, 1.425},
                                   {-0.03, 1.428},
                                   {0.26, 1.405},
                                   {0.96, 0.965},
                                   {1.36, 0.93},
                                   {1.9, 0.855},
                                   {2.12, 0.79},
                                   {2.24, 0.73}},
                                  z);
    // How far the body has turned from bonnet or boot (0) to roof (1).
    const double roof = polyline({{-1.512, 0.0}, {-0.74, 1.0}, {0.26, 1.0}, {0.96, 0.0}}, z);
    const double arch = arch_height(z, bottom);
    const double lip = width - (arch > bottom ? 0.005 : 0.045);
    const double flank = glm::mix(arch, shoulder, 0.48);
    const double belt_x = width - 0.075;
    const double rail_x = glm::mix(belt_x - 0.055, 0.60, roof), crown_x = glm::mix(0.46 * width, 0.36, roof);
    const double rail = glm::mix(glm::mix(belt, ridge, 0.42), ridge - 0.062, roof);
    const double pillar_x = rail_x - 0.055, pillar = glm::mix(rail, ridge, glm::mix(0.25, 0.45, roof));
    const double well = std::min(kWellDepth, width - 0.14);
    return {{{0.0, bottom, z},
             {well, bottom, z},
             {well, arch, z},
             {lip, arch, z},
             {width, flank, z},
             {width - 0.012, shoulder, z},
             {belt_x, belt, z},
             {rail_x, rail, z},
             {pillar_x, pillar, z},
             {crown_x, glm::mix(pillar, ridge, 0.75), z},
             {0.0, ridge, z}}};
}

/// Rear to front. The wheel arches have the most.
std::vector<double> stations()
{
    std::vector<double> z{-2.26, -2.2, -2.02, -0.74, -0.35, -0.045, -0.015, 0.26, 0.62, 1.9, 2.12, 2.24};
    for (const double axle : {-kWheelBase, kWheelBase})
        for (int i = 0; i <= kArchSegments; ++i)
            z.push_back(axle - kArchRadius * std::cos(std::numbers::pi * i / kArchSegments));
    std::sort(z.begin(), z.end());
    return z;
}

/// A wheel on its axle, from the edge of the hole in the well's wall to the hub cap. The lathe's axis becomes x.
void add_wheel(PolyMesh& mesh, const std::vector<int>& well, double axle_z)
{
    const auto first_point = mesh.points.size();
    constexpr int kSegments = 16, kAxleSegments = 8;
    Lathe axle(mesh, kAxleSegments, "iron");
    const Ring hole = axle.ring(0.06, kWellDepth, 0.0), back = axle.ring(0.06, 0.665, 0.1);
    axle.band(hole, back);
    Lathe wheel(mesh, kSegments, "iron");
    const Ring drum = wheel.ring(0.2, 0.665, 0.1);
    const auto turn = [&](const Ring& from, std::string_view material, std::initializer_list<Profile::Point> through) {
        const glm::dvec3 p = mesh.points[std::size_t(from.points[0])];
        Profile profile(p.x, p.y);
        for (const auto& q : through) profile.line(q.radius, q.height);
        wheel.use(material);
        return wheel.turn(from, profile);
    };
    const Ring bead = turn(drum, "rubber", {{0.315, 0.67}, {0.325, 0.83}, {0.295, 0.868}, {0.232, 0.868}});
    const Ring dish = turn(bead, "chrome", {{0.215, 0.862}, {0.2, 0.835}});
    const Ring hub = wheel.ring(0.07, 0.852, dish.v + 0.13);
    wheel.use("chrome");
    wheel.band(dish, hub, [](int i) { return i % 2 == 0; });
    wheel.fan(hub, 0.862, true);
    wheel.use("iron");
    wheel.band(dish, hub, [](int i) { return i % 2 == 1; });
    bridge(mesh, reversed(drum.points), reversed(back.points), "iron");

    for (auto p = first_point; p < mesh.points.size(); ++p) {
        const glm::dvec3 at = mesh.points[p];
        mesh.points[p] = {at.y, kWheelHeight + at.z, axle_z + at.x};
    }
    bridge(mesh, well, hole.points, "iron");
}

/// The body shell, built in steps that must run in the order in which they are declared.
class Body
{
public:
    explicit Body(PolyMesh& mesh) : mesh_(mesh), z_(stations()), columns_(z_.size() - 1) {}

    void lay_grid();     ///< the right half, open at both ends and at the wheels
    void hang_wheels();  ///< closes the wells' walls
    void add_left_half();
    void close_ends();
    void fit_panels();  ///< windows, lights, doors and what else is sunk in or raised

private:
    using Facets = std::vector<std::size_t>;

    bool has_well(std::size_t station) const { return grid_[station][kWellFoot] != grid_[station][kWellTop]; }
    std::size_t column(double z) const;
    Facets region(double from, double to, std::size_t low, std::size_t high) const;
    Facets image_of(Facets right) const;
    Facets with_image(Facets right) const;
    std::size_t add_end_band(bool front, std::size_t from, std::size_t to);
    void inset_on_each_side(const Facets& right, double margin, double depth, std::string_view material);
    void boss_on_each_side(double z, std::size_t row, const std::array<double, 4>& foot,
                           const std::vector<BossLayer>& layers, std::string_view material);

    PolyMesh& mesh_;
    std::vector<double> z_;                                 ///< of the stations
    std::size_t columns_;                                   ///< between stations
    std::vector<std::array<int, kRows>> grid_;              ///< point at [station][row]
    std::vector<std::array<std::size_t, kRows>> facet_at_;  ///< facet at [column][row], up to the next row
    std::size_t half_ = 0;                                  ///< how many facets the right half has
    std::vector<int> image_;                                ///< of each point of the right half

    struct End
    {
        std::size_t bumper;  ///< facet between the flank's and the shoulder's row
        std::size_t edge;    ///< and from there to the belt's
    };
    End front_{}, rear_{};
};

void Body::lay_grid()
{
    for (const double z : z_) {
        const auto points = section(z);
        std::array<int, kRows> numbers{};
        for (std::size_t r = 0; r < kRows; ++r)
            numbers[r] = r == kWellTop && points[r] == points[r - 1] ? numbers[r - 1] : mesh_.add_point(points[r]);
        grid_.push_back(numbers);
    }
    facet_at_.resize(columns_);
    for (std::size_t c = 0; c < columns_; ++c)
        for (std::size_t r = 0; r + 1 < kRows; ++r) {
            if (r == kWellFoot) continue;
            facet_at_[c][r] = mesh_.facets.size();
            const bool below = r == kFloor || r == kWellTop;
            mesh_.add_facet({grid_[c][r], grid_[c][r + 1], grid_[c + 1][r + 1], grid_[c + 1][r]},
                            below ? "iron" : "body");
        }
}

void Body::hang_wheels()
{
    for (std::size_t c = 0; c < columns_; ++c) {
        if (has_well(c) || !has_well(c + 1)) continue;
        std::size_t end = c + 1;
        while (has_well(end)) ++end;
        std::vector<int> wall;  // forwards along the arch, back along the floor
        for (std::size_t s = c; s <= end; ++s) wall.push_back(grid_[s][kWellTop]);
        for (std::size_t s = end - 1; s > c; --s) wall.push_back(grid_[s][kWellFoot]);
        add_wheel(mesh_, wall, 0.5 * (z_[c] + z_[end]));
    }
}

void Body::add_left_half()
{
    half_ = mesh_.facets.size();
    image_ = mirror_x(mesh_);
}

/// A flat facet across the car's first or last station, from one row to another.
std::size_t Body::add_end_band(bool front, std::size_t from, std::size_t to)
{
    const auto& station = front ? grid_.back() : grid_.front();
    std::vector<int> loop;
    for (std::size_t r = from; r <= to; ++r) loop.push_back(station[r]);
    for (std::size_t r = to + 1; r-- > from;) loop.push_back(image_[std::size_t(station[r])]);
    mesh_.add_facet(front ? loop : reversed(loop), "body");
    return mesh_.facets.size() - 1;
}

void Body::close_ends()
{
    for (const bool front : {false, true}) {
        End& end = front ? front_ : rear_;
        add_end_band(front, kFloor, kFlank);
        end.bumper = add_end_band(front, kFlank, kShoulder);
        end.edge = add_end_band(front, kShoulder, kBelt);
        add_end_band(front, kBelt, kRidge);
    }
}

void Body::fit_panels()
{
    inset(mesh_, with_image(region(0.26, 0.96, kPillar, kRidge)), 0.03, 0.015, "glass");     // windscreen
    inset(mesh_, with_image(region(-1.512, -0.74, kPillar, kRidge)), 0.04, 0.015, "glass");  // rear window
    inset_on_each_side(region(-0.015, 0.62, kBelt, kRail), 0.035, 0.015, "glass");
    inset_on_each_side(region(-0.74, -0.045, kBelt, kRail), 0.035, 0.015, "glass");
    inset_on_each_side(region(1.9, 2.24, kShoulder, kBelt), 0.02, 0.012, "headlight");
    inset_on_each_side(region(-2.26, -2.02, kShoulder, kBelt), 0.02, 0.012, "taillight");
    inset_on_each_side(region(-0.045, -0.015, kSill, kBelt), 0.0, 0.012, "iron");  // between the doors
    boss_on_each_side(0.62, kBelt, {0.12, 0.4, 0.25, 0.6}, {{1.0, 0.05}, {1.8, 0.07}, {1.6, 0.17}}, "body");  // mirrors
    boss_on_each_side(-0.015, kFlank, {0.15, 0.75, 0.74, 0.86}, {{0.95, 0.03}}, "chrome");                    // handles
    boss_on_each_side(-0.74, kFlank, {0.15, 0.58, 0.74, 0.86}, {{0.95, 0.03}}, "chrome");
    inset(mesh_, {front_.bumper, front_.edge}, 0.035, 0.03, "iron");  // grille
    inset(mesh_, {rear_.bumper}, 0.05, -0.008, "chrome");
    boss(mesh_, rear_.edge, {0.36, 0.64, 0.2, 0.75}, {{1.0, 0.012}, {0.94, 0.018}}, "chrome");  // number plate
}

/// The column that begins at the station nearest to `z`.
std::size_t Body::column(double z) const
{
    const auto nearer = [z](double a, double b) { return std::abs(a - z) < std::abs(b - z); };
    return std::size_t(std::min_element(z_.begin(), z_.end(), nearer) - z_.begin());
}

Body::Facets Body::region(double from, double to, std::size_t low, std::size_t high) const
{
    Facets facets;
    for (std::size_t c = column(from); c < column(to); ++c)
        for (std::size_t r = low; r < high; ++r) facets.push_back(facet_at_[c][r]);
    return facets;
}

Body::Facets Body::image_of(Facets right) const
{
    for (std::size_t& f : right) f += half_;
    return right;
}

Body::Facets Body::with_image(Facets right) const
{
    const Facets left = image_of(right);
    right.insert(right.end(), left.begin(), left.end());
    return right;
}

void Body::inset_on_each_side(const Facets& right, double margin, double depth, std::string_view material)
{
    inset(mesh_, right, margin, depth, material);
    inset(mesh_, image_of(right), margin, depth, material);
}

void Body::boss_on_each_side(double z, std::size_t row, const std::array<double, 4>& foot,
                             const std::vector<BossLayer>& layers, std::string_view material)
{
    const std::size_t right = facet_at_[column(z)][row];
    boss(mesh_, right, foot, layers, material);
    // The image's corners run the other way: s from the other end.
    boss(mesh_, right + half_, {1 - foot[1], 1 - foot[0], foot[2], foot[3]}, layers, material);
}

}  // namespace

PolyMesh make_car()
{
    PolyMesh mesh;
    Body body(mesh);
    body.lay_grid();
    body.hang_wheels();
    body.add_left_half();
    body.close_ends();
    body.fit_panels();
    fold_bent_facets(mesh, 1.0);
    mesh.fit(2.8);
    return mesh;
}

}  // namespace kerf::maker
