#include "viewer/sim/body_proxies.h"

#include "baseline/report_proxy/every_vertex.h"

namespace kerf::sim {

std::string_view proxy_name(ProxyKind kind)
{
    return kind == ProxyKind::points ? "every_vertex" : name_of(kind);
}

std::optional<ProxyKind> find_proxy(std::string_view name)
{
    for (const ProxyKind kind : kProxyKinds)
        if (proxy_name(kind) == name) return kind;
    return std::nullopt;
}

CollisionProxy body_proxy(const Cuttable& object, ProxyKind kind)
{
    return kind == ProxyKind::points ? baseline::every_vertex(object) : collision_proxy(object, kind);
}

}  // namespace kerf::sim
