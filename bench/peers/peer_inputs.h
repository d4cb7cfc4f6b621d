#pragma once

#include <kerf/mesh.h>
#include <kerf/plane.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

// What other libraries are given: the meshes and planes of kerf_bench, as bare triangles that share their corners.

namespace kerf::bench {

/// A closed mesh without attributes.
struct BareMesh
{
    std::string name;
    std::vector<Vec3f> points;
    std::vector<std::array<std::uint32_t, 3>> triangles;  ///< index into `points`
};

/// The planes that cut a mesh, and what must come out.
struct PeerInput : BareMesh
{
    std::vector<Plane> planes;
    std::vector<double> volumes;  ///< of the negative side of each plane, by the baseline
    double volume = 0.0;          ///< of the whole
};

/// Sides must have the right volume to this share of the whole: what rounding cut points to float may change.
inline constexpr double kVolumeShare = 1e-6;

/// The asteroid of about so many triangles.
PeerInput asteroid_input(std::uint64_t triangles);

/// The report's fifteen models.
std::vector<PeerInput> model_inputs();

/// Planes that meet a mesh which stays whole, and what is there.
struct SectionInput : BareMesh
{
    struct Expected
    {
        double length = 0.0;  ///< of all loops
        std::size_t loops = 0;
    };
    /// Sections by level planes, each in the middle of one of as many layers.
    struct Stack
    {
        std::vector<double> heights;
        Expected expected;  ///< of all of them together
    };
    std::vector<Plane> planes;
    std::vector<Expected> expected;  ///< of each plane, by the linear back end
    std::vector<Stack> stacks;       ///< by the linear back end, too
};

/// The loops of a section must be as long to this share: what rounding their points to float may change.
inline constexpr double kLengthShare = 1e-5;

/// The asteroid of about so many triangles.
SectionInput asteroid_section_input(std::uint64_t triangles);

/// The meshes that are not round, of which there are some (bench/real_meshes.h); one at a time is made.
/// @{
std::size_t real_section_input_count();
SectionInput real_section_input(std::size_t number);
/// @}

}  // namespace kerf::bench
