#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "common/mesh/indexed_mesh.h"
#include "common/mesh/plane.h"
#include "common/repair/repair.h"
#include "common/support/random.h"

namespace kerf::core::test {

/// A mesh with a name for failure messages.
struct NamedMesh
{
    std::string name;
    IndexedMesh mesh;
};

/// repair() for input that is known to be good; throws std::runtime_error otherwise.
IndexedMesh repaired(TriangleSoup soup);

/// Both, where they are.
TriangleSoup joined(TriangleSoup a, const TriangleSoup& b);

/// With a colour for each vertex, so that streams are there to be interpolated.
TriangleSoup with_colours(TriangleSoup soup);

/// With the upper and the lower half in two materials.
TriangleSoup with_two_materials(TriangleSoup soup);

/// Small closed shapes: convex, concave, with tunnels, hollow, of several shells, with seams and with streams.
const std::vector<NamedMesh>& closed_shapes();

/// A closed shape by name.
const IndexedMesh& closed_shape(const std::string& name);

/// Two triangles' worth of trouble each: meshes with boundary.
const std::vector<NamedMesh>& open_shapes();

/// core::Random with what tests draw from it.
class Random
{
public:
    explicit Random(std::uint64_t seed) : numbers_(seed) {}
    std::uint64_t next() { return numbers_.next(); }
    double uniform() { return numbers_.unit(); }  ///< in [0, 1)
    std::uint32_t below(std::uint32_t bound);
    glm::dvec3 direction();  ///< uniform on the sphere

private:
    core::Random numbers_;
};

/// A plane with a name for failure messages.
struct NamedPlane
{
    std::string name;
    Plane plane;
};

/// Planes worth testing on a mesh: `count` each of random ones through the middle, through a vertex, along an edge,
/// through three vertices, in the plane of a face; and the axis planes through the centre of the bounds. Brief builds have
/// half of `count`.
std::vector<NamedPlane> planes_for(const IndexedMesh& mesh, std::uint32_t count, std::uint64_t seed);

}  // namespace kerf::core::test
