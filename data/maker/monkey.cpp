// A monkey's head: two height fields over one outline, the face in front and the back of the head behind, so that they
// can't cross. Points lie along the features - rims of eyes, mask, muzzle, mouth, ears - and the rest is filled evenly
// until the number of triangles is right. One half is made and mirrored.

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>
#include <vector>

#include "maker/delaunay.h"
#include "maker/facets.h"
#include "maker/models.h"

namespace kerf::maker {
namespace {

using std::numbers::pi;

constexpr int kHalfTriangles = 484;
constexpr std::size_t kFillBehind = 30;

struct Ellipse
{
    glm::dvec2 centre, radius;

    /// 1 on the ellipse, less inside.
    double at(const glm::dvec2& p) const { return glm::length((p - centre) / radius); }

    glm::dvec2 rim(double angle, double scale = 1.0) const
    {
        return centre + radius * scale * glm::dvec2{std::cos(angle), std::sin(angle)};
    }

    /// Height of an ellipsoid over it, `top` in the middle, 0 on the rim.
    double dome(const glm::dvec2& p, double top) const { return top * std::sqrt(std::max(0.0, 1.0 - at(p) * at(p))); }
};

constexpr Ellipse kSkull{{0.0, 0.03}, {0.88, 1.0}};
constexpr Ellipse kEye{{0.27, 0.25}, {0.165, 0.185}};
constexpr Ellipse kPupil{{0.25, 0.235}, {0.08, 0.09}};
constexpr Ellipse kEyeLobe{{0.27, 0.26}, {0.36, 0.36}};
constexpr Ellipse kMuzzle{{0.0, -0.46}, {0.55, 0.41}};
constexpr Ellipse kBridge{{0.0, 0.33}, {0.34, 0.28}};  // of the nose, up to the brows
constexpr Ellipse kNose{{0.0, -0.17}, {0.17, 0.10}};
constexpr Ellipse kEar{{1.09, 0.16}, {0.34, 0.38}};
constexpr int kEarPoints = 11;
constexpr double kEarOpening = 0.79 * pi;  // from +x to where the ear meets the head

double ear_angle(int i)
{
    return kEarOpening * (1.0 - 2.0 * i / (kEarPoints - 1));
}

/// The right half of the outline, from the crown down; the ear stands out.
const std::vector<glm::dvec2>& outline()
{
    static const std::vector<glm::dvec2> points = [] {
        std::vector<glm::dvec2> all{{0.0, 1.04},  {0.13, 1.03}, {0.27, 0.99}, {0.40, 0.93},
                                    {0.55, 0.82}, {0.68, 0.68}, {0.77, 0.54}};
        for (int i = 0; i < kEarPoints; ++i) all.push_back(kEar.rim(ear_angle(i)));
        all.insert(all.end(), {{0.84, -0.22},
                               {0.80, -0.38},
                               {0.73, -0.54},
                               {0.63, -0.68},
                               {0.51, -0.80},
                               {0.35, -0.90},
                               {0.18, -0.96},
                               {0.0, -0.98}});
        return all;
    }();
    return points;
}

constexpr double kSkinEdge = 1.03;  ///< where the mask ends and the fur begins
constexpr double kEarLevel = -0.06;

bool in_ear(const glm::dvec2& p)
{
    return p.x > 0.87 && kEar.at(p) < 1.01;
}

/// The higher of two heights, blended over `width`.
double smooth_max(double a, double b, double width)
{
    const double h = std::clamp(0.5 + 0.5 * (a - b) / width, 0.0, 1.0);
    return glm::mix(b, a, h) + width * h * (1.0 - h);
}

/// Below 1 in the bare skin round eyes and muzzle.
double mask(const glm::dvec2& p)
{
    return -smooth_max(-std::min(kEyeLobe.at(p), kBridge.at(p)), -0.95 * kMuzzle.at(p), 0.12);
}

double front(const glm::dvec2& p)
{
    if (in_ear(p)) return kEarLevel + (kEar.at(p) < 0.7 ? 0.01 : 0.13);
    double z = kSkull.dome(p, 0.62);
    if (kMuzzle.at(p) < 1.0) z = smooth_max(z, 0.2 + kMuzzle.dome(p, 0.66), 0.12);
    if (kNose.at(p) < 1.0) z = std::max(z, 0.45 + kNose.dome(p, 0.38));
    const glm::dvec2 brow = (p - glm::dvec2{0.26, 0.52}) / glm::dvec2{0.26, 0.10};
    z += 0.10 * std::exp(-glm::dot(brow, brow));
    if (kEye.at(p) < 1.02) return z - 0.05 + kEye.dome(p, 0.11);
    const double m = mask(p);
    return m < kSkinEdge ? z - 0.05 : z + 0.05 * std::clamp((1.6 - m) / 0.4, 0.0, 1.0);
}

double back(const glm::dvec2& p)
{
    return std::min(in_ear(p) ? kEarLevel - 0.09 : 0.0, -kSkull.dome(p, 0.80));
}

/// The mouth: a smile, lowest in the middle.
glm::dvec2 mouth(double t, double across)
{
    return {0.40 * t, -0.60 + 0.15 * t * t + across * (1.0 - 0.75 * t * t)};
}
constexpr double kMouthWidth = 0.035;

std::string_view material(const glm::dvec2& p)
{
    if (in_ear(p)) return kEar.at(p) < 0.76 ? "skin" : "fur";
    if (kPupil.at(p) < 1.0) return "pupil";
    if (kEye.at(p) < 1.0) return "eye";
    if (kNose.at(p) < 0.97) return "pupil";
    const double t = p.x / 0.40;
    if (t < 0.97 && std::abs(p.y - mouth(t, 0.0).y) < kMouthWidth * (1.0 - 0.75 * t * t) * 0.9) return "mouth";
    return mask(p) < 0.97 ? "skin" : "fur";
}

/// Where the plane's points go before they are triangulated: the skull unrolled about its middle, so that triangles
/// near the outline, where it is steep, keep their shape.
glm::dvec2 unrolled(const glm::dvec2& p)
{
    constexpr double kSteep = 0.97;
    const double e = kSkull.at(p);
    if (e == 0.0) return {0.0, 0.0};
    const double arc = std::asin(std::min(e, kSteep)) + std::max(0.0, e - kSteep) * 1.5;
    return (p - kSkull.centre) * (arc / e);
}

/// One of the two height fields of the half head.
class Field
{
public:
    explicit Field(double (*height)(const glm::dvec2&)) : height_(height) {}

    /// Adds a point unless another is nearer than `spacing`; points at x = 0 become part of the border.
    void add(const glm::dvec2& p, double raise = 0.0, double spacing = 0.045)
    {
        if (p.x < 0.0 || (p.x > 0.0 && p.x < 0.6 * spacing)) return;
        for (const glm::dvec2& q : outline())
            if (glm::distance(p, q) < spacing) return;
        for (const auto* list : {&middle, &inside})
            for (const glm::dvec3& q : *list)
                if (glm::distance(p, glm::dvec2{q.x, q.y}) < spacing) return;
        (p.x == 0.0 ? middle : inside).push_back({p.x, p.y, height_(p) + raise});
    }

    /// Adds the candidate that is farthest from all points, `count` times.
    void fill(std::size_t count)
    {
        constexpr double kStep = 0.02;
        std::vector<glm::dvec3> candidates;
        double y = -0.98;
        for (int row = 0; row < 104; ++row, y += kStep) {
            double x = 2 * kStep;
            for (int column = 0; column < 68; ++column, x += kStep)
                if (is_inside({x, y})) candidates.push_back({x, y, height_({x, y})});
        }
        std::vector<double> distance(candidates.size(), 1e9);
        const auto take = [&](const glm::dvec3& p) {
            for (std::size_t i = 0; i < candidates.size(); ++i)
                distance[i] = std::min(distance[i], glm::distance(p, candidates[i]));
        };
        for (const glm::dvec2& p : outline()) take({p.x, p.y, in_ear(p) ? kEarLevel : 0.0});
        for (const auto* list : {&middle, &inside})
            for (const glm::dvec3& p : *list) take(p);
        for (std::size_t k = 0; k < count; ++k) {
            const auto far = std::size_t(std::max_element(distance.begin(), distance.end()) - distance.begin());
            inside.push_back(candidates[far]);
            take(candidates[far]);
        }
    }

    std::vector<glm::dvec3> middle;  ///< on the plane of symmetry, without the outline's ends
    std::vector<glm::dvec3> inside;

private:
    /// Inside the outline by a margin, by the crossing number.
    static bool is_inside(const glm::dvec2& p)
    {
        bool in = false;
        for (std::size_t i = 0; i < outline().size(); ++i) {
            const glm::dvec2 &a = outline()[i], &b = outline()[(i + 1) % outline().size()];
            if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) in = !in;
            const double t = std::clamp(glm::dot(p - a, b - a) / glm::dot(b - a, b - a), 0.0, 1.0);
            if (i + 1 < outline().size() && glm::distance(p, a + (b - a) * t) < 0.03) return false;
        }
        return in;
    }

    double (*height_)(const glm::dvec2&);
};

Field face()
{
    Field field(front);
    const auto ring = [&](const Ellipse& e, double scale, int count, double raise, auto wanted) {
        for (int i = 0; i < count; ++i) {
            glm::dvec2 p = e.rim(pi / 2 + 2 * pi * i / count, scale);
            if (std::abs(p.x) < 1e-9) p.x = 0.0;
            if (p.x >= 0.0 && wanted(p)) field.add(p, raise);
        }
    };
    const auto always = [](const glm::dvec2&) { return true; };
    field.add(kPupil.centre, 0.02);
    ring(kPupil, 1.0, 8, 0.0, always);
    ring(kEye, 0.98, 14, 0.0, always);
    ring(kEye, 1.22, 12, -0.02, always);
    for (int i = 0; i <= 5; ++i)
        for (const double across : {0.0, kMouthWidth, -kMouthWidth})
            if (across == 0.0 || i < 5)
                field.add(mouth(i / 5.0, across), across == 0.0 ? -0.09 * (1.0 - i * i / 25.0) : 0.0, 0.02);
    ring(kNose, 1.0, 10, -0.06, always);
    ring(kNose, 0.6, 6, 0.0, always);
    ring(kNose, 1.3, 10, 0.0, [](const glm::dvec2& p) { return p.y > -0.3; });
    for (const double scale : {0.95, 1.12}) {
        const auto on_rim = [scale](const glm::dvec2& p) { return mask(p) > scale - 0.03; };
        ring(kBridge, scale, 12, 0.0, on_rim);
        ring(kEyeLobe, scale, 20, 0.0, on_rim);
        ring(kMuzzle, scale / 0.95, 24, 0.0, on_rim);
    }
    ring(kMuzzle, 0.78, 16, 0.0, [](const glm::dvec2& p) { return p.y < -0.2; });
    ring(kMuzzle, 0.5, 10, 0.0, [](const glm::dvec2& p) { return p.y < -0.2; });
    for (int i = 1; i + 1 < kEarPoints; ++i) {
        field.add(kEar.rim(ear_angle(i), 0.82));
        if (i % 2 == 1) field.add(kEar.rim(ear_angle(i), 0.62));
    }
    for (const double y : {0.92, 0.78, 0.49, 0.36, 0.22, 0.08, -0.3, -0.38, -0.46, -0.74, -0.82, -0.9})
        field.add({0.0, y});
    return field;
}

}  // namespace

PolyMesh make_monkey()
{
    Field before = face(), behind(back);
    for (int i = 1; i < 9; ++i) behind.add({0.0, 1.0 - i * 0.22});
    behind.fill(kFillBehind);
    // A polygon of v corners with i points inside it has v + 2 i - 2 triangles.
    const auto count = [](const Field& field) {
        return int(outline().size() + field.middle.size() + 2 * field.inside.size()) - 2;
    };
    if ((kHalfTriangles - count(before) - count(behind)) % 2 != 0) before.add({0.0, 0.85});
    before.fill(std::size_t(kHalfTriangles - count(before) - count(behind)) / 2);

    PolyMesh mesh;
    std::vector<int> border;
    for (const glm::dvec2& p : outline()) border.push_back(mesh.add_point({p.x, p.y, in_ear(p) ? kEarLevel : 0.0}));
    for (Field* field : {&before, &behind}) {
        // Clockwise down the outline, up again on the plane of symmetry.
        std::sort(field->middle.begin(), field->middle.end(), [](const auto& a, const auto& b) { return a.y < b.y; });
        std::vector<int> numbers = border;
        for (const glm::dvec3& p : field->middle) numbers.push_back(mesh.add_point(p));
        std::reverse(numbers.begin(), numbers.end());
        std::vector<glm::dvec2> polygon, inside;
        const auto flat = [&](int p) {
            const glm::dvec3& at = mesh.points[std::size_t(p)];
            return glm::dvec2{at.x, at.y};
        };
        for (const int p : numbers) polygon.push_back(unrolled(flat(p)));
        for (const glm::dvec3& p : field->inside) {
            inside.push_back(unrolled({p.x, p.y}));
            numbers.push_back(mesh.add_point(p));
        }
        for (const auto& [i, j, k] : delaunay(polygon, inside)) {
            const int a = numbers[std::size_t(i)], b = numbers[std::size_t(j)], c = numbers[std::size_t(k)];
            const std::string_view of = field == &before ? material((flat(a) + flat(b) + flat(c)) / 3.0) : "fur";
            if (field == &before)
                mesh.add_facet({a, b, c}, of, {}, of == "eye" || of == "pupil" ? 1 : 0);
            else
                mesh.add_facet({c, b, a}, of);
        }
    }
    mirror_x(mesh);
    pair_triangles(mesh, 40.0);
    mesh.fit(2.2);
    return mesh;
}

}  // namespace kerf::maker
