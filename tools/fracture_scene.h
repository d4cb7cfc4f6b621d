#pragma once

#include <kerf/fracture.h>

#include <string>
#include <vector>

#include "tools/fragment_facts.h"

// The pieces of a fracture as one GLB file, a node each.

namespace kerf::tools {

/// One piece, and what is said of it.
struct FracturePiece
{
    std::string name;  ///< "piece.007"
    Mesh mesh;
    std::vector<std::uint32_t> cells;
    FragmentFacts facts;
};

/// In the order of the fracture. O(n). Throws std::runtime_error with one sentence.
std::vector<FracturePiece> pieces_of(Fracture& fracture);

/// What is said of where two pieces touch.
Json contact_json(const FractureBond& bond);

/// The bytes of the file. The extras of a node say which cells its piece consists of, its volume and centre of mass, which
/// pieces it touches, over which area and where, and the material of its inside.
/// @param explode   each piece is moved away from `centre` by so many times its distance from there
/// @param material  of the inside
/// @throws std::runtime_error
std::string scene_of(const std::vector<FracturePiece>& pieces, std::span<const FractureBond> bonds,
                     const glm::dvec3& centre, double explode, const std::string& material);

}  // namespace kerf::tools
