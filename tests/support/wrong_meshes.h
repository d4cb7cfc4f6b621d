#pragma once

#include <span>
#include <string_view>

#include "common/mesh/indexed_mesh.h"
#include "support/fixtures.h"

// Meshes as a program may hand them over: each promise of IndexedMesh broken on purpose, and what is unusual but kept.

namespace kerf::core::test {

/// What prepare() must say to a mesh that was changed in some way.
enum class Verdict
{
    refused,  ///< a promise is broken
    cut,      ///< unusual, but all promises are kept
    either,   ///< depends on the numbers; a referee decides
};

/// One way to change a good mesh.
struct MeshChange
{
    std::string_view name;
    Verdict verdict;
    void (*apply)(IndexedMesh& mesh, Random& random);
};

/// All ways that are known, each under its own name.
std::span<const MeshChange> mesh_changes();

/// A mesh of 4 to some 60 triangles that keeps every promise: closed or open, of one shell or several, with seams,
/// materials and a stream now and then.
IndexedMesh small_mesh(Random& random);

}  // namespace kerf::core::test
