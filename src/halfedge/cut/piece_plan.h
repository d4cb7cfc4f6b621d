#pragma once

#include "halfedge/cut/caps.h"
#include "halfedge/cut/planned_pieces.h"
#include "halfedge/cut/section.h"

namespace kerf::core::halfedge {

class OutlineLinker;

/// Makes the first targets: one for each side of each shell that is cut.
void make_first_targets(const Found& found, Pieces& pieces);

/// One fragment a side: one piece shell for each side of each solid that is cut.
void plan_sides(const Found& found, const Section& section, Pieces& pieces);

/// One fragment for each connected piece, as core::group_pieces() decides; targets must have been separated. An
/// irregular outline is linked once more, so each loop lies between two piece shells.
void plan_pieces(const Universe& universe, const Plane& plane, Found& found, OutlineLinker& linker, Section& section,
                 Pieces& pieces);

/// Puts loops that lie between the same two piece shells into one set; each set can then be closed by itself.
void plan_cap_sets(const Found& found, const Pieces& pieces, Section& section);

/// Hands the caps to the piece shells.
void hand_out_caps(const Found& found, const Section& section, Caps& caps, Pieces& pieces);

/// Divides the piece shells into sets of triangles, caps included, that are connected by half-edges: a piece may have
/// several shells.
void divide_piece_shells(const Found& found, const Section& section, Caps& caps, Pieces& pieces);

}  // namespace kerf::core::halfedge
