#include "maker/lathe.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>

#include "maker/triangulate.h"

namespace kerf::maker {
namespace {

using std::numbers::pi;

glm::dvec2 vec(const Profile::Point& p)
{
    return {p.radius, p.height};
}

/// Centripetal Catmull-Rom between b and c (Barry and Goldman 1988; Yuksel et al. 2011).
glm::dvec2 catmull_rom(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c, const glm::dvec2& d, double t)
{
    const double ta = 0.0, tb = ta + std::sqrt(glm::length(b - a)), tc = tb + std::sqrt(glm::length(c - b)),
                 td = tc + std::sqrt(glm::length(d - c));
    const double s = tb + t * (tc - tb);
    const auto mix = [s](const glm::dvec2& p, const glm::dvec2& q, double tp, double tq) {
        return p * ((tq - s) / (tq - tp)) + q * ((s - tp) / (tq - tp));
    };
    const glm::dvec2 ab = mix(a, b, ta, tb), bc = mix(b, c, tb, tc), cd = mix(c, d, tc, td);
    return mix(mix(ab, bc, ta, tc), mix(bc, cd, tb, td), tb, tc);
}

}  // namespace

Profile& Profile::line(double radius, double height, int bands)
{
    const glm::dvec2 from = vec(points_.back()), to{radius, height};
    for (int i = 1; i <= bands; ++i) {
        const glm::dvec2 p = i == bands ? to : glm::mix(from, to, double(i) / bands);
        points_.push_back({p.x, p.y});
    }
    return *this;
}

Profile& Profile::arc(double radius, double height, double bulge, int bands)
{
    const glm::dvec2 from = vec(points_.back()), to{radius, height};
    const glm::dvec2 half = (to - from) * 0.5, right{half.y, -half.x};
    // Half the angle of the arc is 2 atan(bulge); its centre lies on the chord's bisector.
    const double angle = 2.0 * std::atan(bulge);
    const double back = bulge == 0 ? 0 : 1.0 / std::tan(angle);
    const glm::dvec2 centre = (from + to) * 0.5 - right * back, start = from - centre;
    for (int i = 1; i < bands; ++i) {
        const double turn = 2.0 * angle * i / bands, c = std::cos(turn), s = std::sin(turn);
        const glm::dvec2 p = centre + glm::dvec2{start.x * c - start.y * s, start.x * s + start.y * c};
        points_.push_back({p.x, p.y});
    }
    points_.push_back({radius, height});
    return *this;
}

Profile& Profile::curve(const std::vector<Point>& through, int bands)
{
    std::vector<glm::dvec2> knots{vec(points_.back())};
    for (const Point& p : through) knots.push_back(vec(p));
    const std::size_t n = knots.size();
    std::vector<glm::dvec2> fine{knots[0]};
    constexpr int kSamples = 32;
    for (std::size_t i = 0; i + 1 < n; ++i) {
        const glm::dvec2 before = i > 0 ? knots[i - 1] : knots[0] * 2.0 - knots[1];
        const glm::dvec2 after = i + 2 < n ? knots[i + 2] : knots[n - 1] * 2.0 - knots[n - 2];
        for (int k = 1; k <= kSamples; ++k)
            fine.push_back(catmull_rom(before, knots[i], knots[i + 1], after, double(k) / kSamples));
    }
    std::vector<double> along{0.0};
    for (std::size_t i = 1; i < fine.size(); ++i) along.push_back(along.back() + glm::length(fine[i] - fine[i - 1]));
    for (int i = 1; i <= bands; ++i) {
        if (i == bands) {
            points_.push_back(through.back());
            break;
        }
        const double target = along.back() * i / bands;
        const auto next = std::size_t(std::lower_bound(along.begin(), along.end(), target) - along.begin());
        const double t = (target - along[next - 1]) / (along[next] - along[next - 1]);
        const glm::dvec2 p = glm::mix(fine[next - 1], fine[next], t);
        points_.push_back({p.x, p.y});
    }
    return *this;
}

glm::dvec3 Lathe::at(double radius, double height, double segment) const
{
    const double angle = 2.0 * pi * segment / segments_;
    return {radius * std::cos(angle), height, -radius * std::sin(angle)};
}

Ring Lathe::ring(double radius, double height, double v)
{
    return ring([&](int i) { return at(radius, height, i); }, v);
}

Ring Lathe::ring(const std::function<glm::dvec3(int)>& point, double v)
{
    Ring ring;
    for (int i = 0; i < segments_; ++i) ring.points.push_back(mesh_.add_point(point(i)));
    ring.v = v;
    return ring;
}

void Lathe::quad(const Ring& lower, const Ring& upper, int i)
{
    const auto a = std::size_t(i), b = std::size_t((i + 1) % segments_);
    const double u0 = double(i) / segments_, u1 = double(i + 1) / segments_;
    mesh_.add_facet({lower.points[a], lower.points[b], upper.points[b], upper.points[a]}, material_,
                    {{u0, lower.v}, {u1, lower.v}, {u1, upper.v}, {u0, upper.v}}, smoothing_);
}

void Lathe::band(const Ring& lower, const Ring& upper, const std::function<bool(int)>& wanted)
{
    for (int i = 0; i < segments_; ++i)
        if (!wanted || wanted(i)) quad(lower, upper, i);
}

Ring Lathe::turn(const Ring& first, const Profile& profile)
{
    Ring below = first;
    const auto& points = profile.points();
    for (std::size_t k = 1; k < points.size(); ++k) {
        // Texture runs on by length, not by height, so that flat parts are textured too.
        const double length = glm::length(vec(points[k]) - vec(points[k - 1]));
        const Ring above = ring(points[k].radius, points[k].height, below.v + length);
        band(below, above);
        below = above;
    }
    return below;
}

void Lathe::fan(const Ring& rim, double height, bool up)
{
    fan(rim, glm::dvec3{0.0, height, 0.0}, up);
}

void Lathe::fan(const Ring& rim, const glm::dvec3& place, bool up)
{
    const int apex = mesh_.add_point(place);
    const double reach = glm::length(mesh_.points[std::size_t(rim.points[0])] - mesh_.points[std::size_t(apex)]);
    const double v = up ? rim.v + reach : rim.v - reach;
    for (int i = 0; i < segments_; ++i) {
        const int a = rim.points[std::size_t(i)], b = rim.points[std::size_t((i + 1) % segments_)];
        const double u0 = double(i) / segments_, u1 = double(i + 1) / segments_, middle = 0.5 * (u0 + u1);
        if (up)
            mesh_.add_facet({a, b, apex}, material_, {{u0, rim.v}, {u1, rim.v}, {middle, v}}, smoothing_);
        else
            mesh_.add_facet({b, a, apex}, material_, {{u1, rim.v}, {u0, rim.v}, {middle, v}}, smoothing_);
    }
}

void Lathe::disc(const Ring& rim, bool up)
{
    mesh_.add_facet(up ? rim.points : reversed(rim.points), material_, {}, smoothing_);
}

std::vector<int> reversed(std::vector<int> loop)
{
    std::reverse(loop.begin(), loop.end());
    return loop;
}

void bridge(PolyMesh& mesh, const std::vector<int>& outer, const std::vector<int>& inner, std::string_view material,
            int smoothing)
{
    const auto position = [&](int p) { return mesh.points[std::size_t(p)]; };
    std::size_t at_outer = 0, at_inner = 0;
    const auto gap = [&](std::size_t i, std::size_t j) {
        return glm::distance(position(outer[i]), position(inner[j]));
    };
    for (std::size_t i = 0; i < outer.size(); ++i)
        for (std::size_t j = 0; j < inner.size(); ++j)
            if (gap(i, j) < gap(at_outer, at_inner)) at_outer = i, at_inner = j;
    // One loop: once round the outside, over the gap, backwards round the inside and back.
    std::vector<int> loop;
    for (std::size_t k = 0; k <= outer.size(); ++k) loop.push_back(outer[(at_outer + k) % outer.size()]);
    for (std::size_t k = 0; k <= inner.size(); ++k)
        loop.push_back(inner[(at_inner + inner.size() - k % inner.size()) % inner.size()]);
    std::vector<glm::dvec3> polygon;
    for (const int p : loop) polygon.push_back(position(p));
    for (const auto& t : triangulate(polygon))
        mesh.add_facet({loop[std::size_t(t[0])], loop[std::size_t(t[1])], loop[std::size_t(t[2])]}, material, {},
                       smoothing);
}

}  // namespace kerf::maker
