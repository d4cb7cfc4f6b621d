#pragma once

#include <kerf/cut.h>

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "tools/cap_facts.h"
#include "tools/comparison_planes.h"
#include "tools/surface_keys.h"

// Cuts with both back ends and judges what comes out. What is judged is read off the fragments' meshes; none of it
// comes from the back ends' own statements, except times and the counters that are compared with one another.

namespace kerf::tools {

/// What to do with each mesh.
struct ComparisonOptions
{
    std::uint64_t planes = 20;
    std::uint64_t seed = 1;
    std::uint64_t depth = 1;  ///< cuts in a row: 1 cuts the whole only, 2 its two pieces as well, ...
    PlaneMix mix = PlaneMix::nasty;
    std::uint64_t first_plane = 0;  ///< where to begin in the sequence of planes
    bool was_closed = false;        ///< before the mesh was repaired: it must be closed now, too
    bool caps_alike = false;        ///< the first back end closes sections rightly, too: caps must have equal areas
};

/// Volumes and areas must agree to this, relative to the whole, and the half-edge cap with its section: what rounding
/// cut points to float costs (docs/cutting-rules.md). Volumes may be off by a unit in the last place times the surface
/// besides, which is more far from the origin and where shells cancel.
inline constexpr double kAgreement = 1e-6;

/// What one back end made of one cut.
struct BackEndRow
{
    Status status = Status::missed;
    std::uint64_t crossing = 0;
    std::uint64_t open_edges = 0;              ///< both fragments; of the caps' making when the object was closed
    std::uint64_t degenerate_triangles = 0;    ///< two corners at one position; both fragments
    std::uint64_t lost_numbers = 0;            ///< vertices with a number that is not finite; both fragments
    double volume_error = 0.0;                 ///< relative to ComparedMesh::judged_volume: sum of the fragments, and
                                               ///< what mass_properties() says of each
    bool says_caps_exceed = false;             ///< Cut::caps_exceed_section
    double overhang = 0.0;                     ///< how far a fragment reaches to the wrong side, mesh units
    std::array<std::uint64_t, 2> triangles{};  ///< of the fragments: + and - side
    std::array<double, 2> cap_area{};          ///< of this cut's cap, each triangle counted positive: + and - side
    double cap_excess = 0.0;                   ///< the worse cap's area less what it should cover, mesh units squared
    double least_angle = 180.0;                ///< smallest of the cap's triangles, degrees
    double overlap = 0.0;                      ///< area that the cap covers more than once, mesh units squared; looked
                                               ///< for only where it covers too much: see overlap_area()
    FlatCap cap;                               ///< the negative fragment's, which faces along the normal
    double ms = 0.0;                           ///< of the cut, nothing else
};

/// One cut by both back ends.
struct ComparisonRow
{
    std::uint64_t number = 0;  ///< of the plane that cut the whole
    std::string piece;         ///< which piece of it was cut: a + or - for each cut before; empty: the whole
    ChosenPlane plane;
    BackEndRow baseline, halfedge;
    std::array<SurfaceDifference, 2> surface;  ///< positive, negative side
    /// Both back ends take both sides apart into pieces of the same surface triangles. Looked at for cuts of the whole:
    /// those of a piece hang together by earlier caps, too.
    bool pieces_equal = true;
    double section_area = 0.0;  ///< signed sum of the section's loops
    std::uint64_t loops = 0, open_chains = 0;
    std::vector<std::vector<glm::dvec2>> outline;  ///< the section's closed loops in the coordinates of FlatCap
    bool fan_fits = true, cap_fits = true;
    /// Loops wind around something backwards or more than once: the surface intersects itself or is open, and the
    /// half-edge cap's area is not judged. Looked at only when it is not the section's.
    bool section_intersects_itself = false;
    /// False: it crosses itself too often to tell, and neither is the cap's area judged.
    bool section_is_judged = true;
    double covered_area =
        0.0;  ///< what caps should cover: the section's area, and what it winds around backwards twice
    /// What the error of the half-edge cap is relative to: the section's area, or where that is less the area that a
    /// unit in the last place along its outline is kAgreement of.
    double judged_area = 0.0;
    bool section_is_speck = false;            ///< no larger than rounding: errors relative to it say nothing
    bool earlier_caps_fit = true;             ///< whether the pieces of both back ends have the same shape
    std::vector<glm::dvec3> earlier_normals;  ///< of the cuts that made this piece
    std::vector<std::string> failures;        ///< what must not be, one clause each

    /// By both.
    bool was_cut() const
    {
        const auto is_cut = [](Status status) { return status == Status::done || status == Status::open_section; };
        return is_cut(baseline.status) && is_cut(halfedge.status);
    }
    bool surfaces_equal() const { return surface[0].none() && surface[1].none(); }
};

/// A mesh prepared by both.
struct ComparedMesh
{
    std::uint64_t triangles = 0;
    bool closed = false;
    double volume = 0.0;
    /// What volume errors are relative to: the volume, and what a unit in the last place times the surface is
    /// kAgreement of; more than 0 where shells cancel.
    double judged_volume = 0.0;
    double baseline_prepare_ms = 0.0, halfedge_prepare_ms = 0.0;
    std::vector<std::string> failures;  ///< of preparing
    std::uint64_t rows = 0, failed_rows = 0;
};

/// Prepares a mesh with both back ends, named as find_back_end() knows them, cuts it by every plane and hands each row
/// to `take_row` as soon as it is known. A piece that its plane misses is tried with a few other planes; pieces of
/// different surfaces are not cut again. O(n) for each row.
/// @throws std::runtime_error  the mesh cannot be prepared, or memory runs out; one sentence
ComparedMesh compare_mesh(const Mesh& mesh, const std::string& baseline, const std::string& halfedge,
                          const ComparisonOptions& options, const std::function<void(const ComparisonRow&)>& take_row);

}  // namespace kerf::tools
