#pragma once

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <optional>
#include <vector>

#include "common/mesh/indexed_mesh.h"
#include "common/mesh/plane.h"
#include "support/backends.h"

// CGAL's own clip as a referee of the cut: another method, exact predicates, other people's code.

namespace kerf::core::test {

using CgalKernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using CgalMesh = CGAL::Surface_mesh<CgalKernel::Point_3>;

/// A mesh by its points, for CGAL.
CgalMesh to_cgal(const IndexedMesh& mesh);

/// What lies on the negative side of a plane, closed; empty when CGAL gives up.
std::optional<CgalMesh> cgal_clipped(CgalMesh mesh, const Plane& plane);

/// Back ends that are not slow on purpose.
std::vector<NamedBackend> fast_backends();

}  // namespace kerf::core::test
