#pragma once

#include <span>

#include "halfedge/universe.h"

namespace kerf::halfedge {

/// A universe of their own for some shells: only what they use, in the order in which export_mesh() visits it, so that
/// the export of the copy has the same bytes; trees balanced and with full leaves; room reserved for cuts. Nothing is
/// sorted or searched. O(n) for n triangles of the shells, and memory of the size of the old universe for the moment
/// unless the shells are a small part of it.
Prepared compact_copy(const Universe& universe, std::span<const Shell> shells);

/// Runs of triangles under the shells: how many ranges they are drawn in, before neighbours are merged.
std::size_t count_runs(const Universe& universe, std::span<const Shell> shells);

}  // namespace kerf::halfedge
