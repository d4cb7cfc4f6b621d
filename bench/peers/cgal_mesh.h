#pragma once

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <vector>

#include "bench/peers/peer_inputs.h"

namespace kerf::bench {

using CgalKernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using CgalMesh = CGAL::Surface_mesh<CgalKernel::Point_3>;

inline CgalMesh to_cgal(const BareMesh& input)
{
    CgalMesh mesh;
    std::vector<CgalMesh::Vertex_index> points;
    for (const Vec3f& p : input.points) points.push_back(mesh.add_vertex({p.x, p.y, p.z}));
    for (const auto& t : input.triangles) mesh.add_face(points[t[0]], points[t[1]], points[t[2]]);
    return mesh;
}

inline CgalKernel::Plane_3 to_cgal(const Plane& plane)
{
    const Normal normal = plane.normal();
    return {normal.x, normal.y, normal.z, -plane.offset()};
}

}  // namespace kerf::bench
