#include "baseline/report_proxy/every_vertex.h"

#include <BulletCollision/CollisionShapes/btConvexHullShape.h>

#include <vector>

namespace kerf::core::baseline {

CollisionProxy every_vertex(std::span<const Vertex> vertices)
{
    CollisionProxy proxy;
    proxy.kind = ProxyKind::points;
    btConvexHullShape shape;
    for (const Vertex& v : vertices) {
        proxy.box.add(v.position);
        shape.addPoint(btVector3(v.position.x, v.position.y, v.position.z));
    }
    proxy.points.reserve(vertices.size());
    for (int i = 0; i < shape.getNumPoints(); ++i) {
        const btVector3& p = shape.getUnscaledPoints()[i];
        proxy.points.emplace_back(float(p.x()), float(p.y()), float(p.z()));
    }
    return proxy;
}

CollisionProxy every_vertex(const Cuttable& object)
{
    std::vector<Vertex> room;
    return every_vertex(object.used_vertices(room));
}

}  // namespace kerf::core::baseline
