#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "common/cutting/cut.h"
#include "common/proxy/collision_proxy.h"

namespace kerf::sim {

/// What a body may collide as, in the order of the viewer's menu. `points` is the report's way: every vertex.
inline constexpr std::array kProxyKinds{ProxyKind::bounded_hull, ProxyKind::full_hull, ProxyKind::box,
                                        ProxyKind::sphere, ProxyKind::points};

/// What the menu, options and scripts call a kind: its name, but "every_vertex" for `points`.
std::string_view proxy_name(ProxyKind kind);

/// The kind whose proxy_name() this is.
std::optional<ProxyKind> find_proxy(std::string_view name);

/// The proxy of an object; `points` are made as the report's program does, which is quadratic.
CollisionProxy body_proxy(const Cuttable& object, ProxyKind kind);

}  // namespace kerf::sim
