#include "viewer/app/proxy_lines.h"

#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/vec4.hpp>

namespace kerf::app {

namespace {

constexpr int kCircleSides = 48;

class Lines
{
public:
    Lines(const glm::mat4& model, std::vector<glm::vec3>& lines) : model_(model), lines_(lines) {}

    void add(const glm::vec3& a, const glm::vec3& b)
    {
        lines_.push_back(placed(a));
        lines_.push_back(placed(b));
    }

private:
    glm::vec3 placed(const glm::vec3& p) const { return glm::vec3(model_ * glm::vec4(p, 1.0f)); }

    glm::mat4 model_;
    std::vector<glm::vec3>& lines_;
};

void add_box(const Box& box, Lines& lines)
{
    const auto corner = [&](int i) {
        return glm::vec3((i & 1) != 0 ? box.hi.x : box.lo.x, (i & 2) != 0 ? box.hi.y : box.lo.y,
                         (i & 4) != 0 ? box.hi.z : box.lo.z);
    };
    for (int i = 0; i < 8; ++i)
        for (const int axis : {1, 2, 4})
            if ((i & axis) == 0) lines.add(corner(i), corner(i | axis));
}

void add_circle(const glm::vec3& centre, const glm::vec3& u, const glm::vec3& v, Lines& lines)
{
    const auto point = [&](int i) {
        const float angle = glm::two_pi<float>() * static_cast<float>(i) / static_cast<float>(kCircleSides);
        return centre + std::cos(angle) * u + std::sin(angle) * v;
    };
    for (int i = 0; i < kCircleSides; ++i) lines.add(point(i), point(i + 1));
}

void add_sphere(const glm::vec3& centre, float radius, Lines& lines)
{
    const glm::vec3 x(radius, 0, 0), y(0, radius, 0), z(0, 0, radius);
    add_circle(centre, x, y, lines);
    add_circle(centre, y, z, lines);
    add_circle(centre, z, x, lines);
}

void add_hull(const sim::CollisionProxy& proxy, Lines& lines)
{
    const std::span<const std::uint32_t> corners =
        proxy.hull ? proxy.hull->indices() : std::span<const std::uint32_t>();
    for (std::size_t face = 0; face + 3 <= corners.size(); face += 3)
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint32_t a = corners[face + i], b = corners[face + (i + 1) % 3];
            if (a < b) lines.add(proxy.points[a], proxy.points[b]);  // each edge has two faces
        }
    if (!corners.empty()) return;
    const glm::vec3 extent = glm::vec3(proxy.box.hi) - glm::vec3(proxy.box.lo);
    const float size = 0.01f * glm::max(extent.x, glm::max(extent.y, extent.z));
    for (const glm::vec3& p : proxy.points)
        for (const glm::vec3& axis : {glm::vec3(size, 0, 0), glm::vec3(0, size, 0), glm::vec3(0, 0, size)})
            lines.add(p - axis, p + axis);
}

}  // namespace

void append_proxy_lines(const sim::CollisionProxy& proxy, const glm::mat4& model, std::vector<glm::vec3>& out)
{
    Lines lines(model, out);
    switch (proxy.kind) {
        case sim::ProxyKind::box:
            add_box(proxy.box, lines);
            break;
        case sim::ProxyKind::sphere:
            add_sphere(proxy.centre, proxy.radius, lines);
            break;
        case sim::ProxyKind::bounded_hull:
        case sim::ProxyKind::full_hull:
        case sim::ProxyKind::points:
            add_hull(proxy, lines);
            break;
    }
}

}  // namespace kerf::app
