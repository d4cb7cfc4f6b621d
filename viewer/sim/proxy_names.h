#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "common/proxy/collision_proxy.h"

namespace kerf::sim {

/// What the viewer offers, in the order of its menu.
inline constexpr std::array kProxyKinds{ProxyKind::bounded_hull, ProxyKind::full_hull, ProxyKind::box,
                                        ProxyKind::sphere, ProxyKind::every_vertex};

/// The kind whose name_of() this is.
inline std::optional<ProxyKind> find_proxy(std::string_view name)
{
    for (const ProxyKind kind : kProxyKinds)
        if (name_of(kind) == name) return kind;
    return std::nullopt;
}

}  // namespace kerf::sim
