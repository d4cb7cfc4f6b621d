#pragma once

#include <kerf/object.h>
#include <kerf/proxy.h>

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

namespace kerf::sim {

/// What a body may collide as.
enum class ProxyKind : std::uint8_t
{
    box,           ///< along the axes
    sphere,        ///< around all vertices: box centre, farthest vertex
    bounded_hull,  ///< of the vertices that are farthest along fixed directions
    full_hull,     ///< of all vertices
    points,        ///< the report's way: every vertex, and their hull is left to Bullet
};

/// All kinds, in the order of the viewer's menu.
inline constexpr std::array kProxyKinds{ProxyKind::bounded_hull, ProxyKind::full_hull, ProxyKind::box,
                                        ProxyKind::sphere, ProxyKind::points};

/// What the menu, options and scripts call a kind: its name, but "every_vertex" for `points`.
std::string_view proxy_name(ProxyKind kind);

/// The kind whose proxy_name() this is.
std::optional<ProxyKind> find_proxy(std::string_view name);

/// A convex body in mesh coordinates.
struct CollisionProxy
{
    ProxyKind kind = ProxyKind::box;
    Box box;                           ///< bounds of the object; every kind
    glm::vec3 centre{0.0f};            ///< of a sphere
    float radius = 0.0f;               ///< of a sphere
    std::vector<glm::vec3> points;     ///< of hulls
    std::shared_ptr<const Hull> hull;  ///< of hulls but `points`: knows their triangles, which only drawing asks for
};

/// The proxy of an object; `points` are made as the report's program does, which is quadratic.
/// @throws std::bad_alloc
CollisionProxy body_proxy(const Object& object, ProxyKind kind);

}  // namespace kerf::sim
