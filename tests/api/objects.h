#pragma once

#include <kerf/kerf.h>

#include <array>
#include <string>
#include <vector>

// What the tests of the public interface make objects of.

namespace kerf::test {

/// Arrays of a program: what Mesh::make() is given and what it gives back.
struct Arrays
{
    std::vector<std::array<float, 3>> positions, normals;
    std::vector<std::array<float, 2>> uvs;
    std::vector<std::uint32_t> indices, materials;

    /// Borrows the arrays that are not empty.
    MeshInput input() const;
};

/// A cube from `lo` to `hi` along each axis, 8 vertices, 12 triangles.
Arrays cube_arrays(float lo = -1.0f, float hi = 1.0f);

/// Two cubes side by side along x, which do not touch.
Arrays two_cubes();

Mesh mesh_of(const Arrays& arrays);
Mesh shape(const std::string& name, std::uint64_t triangles = 2000);

/// Names of the back ends of this build, without halfedge/cgal, which is halfedge but for its caps.
std::vector<std::string> back_end_names();

Object object_of(const Mesh& mesh, const std::string& back_end);
Object cube(const std::string& back_end);

Plane plane_at(double x, double y, double z, double nx, double ny, double nz);

/// The arrays that a mesh gives, as one string of bytes: equal if the meshes are.
std::string bytes_of(const Mesh& mesh);

}  // namespace kerf::test
