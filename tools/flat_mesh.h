#pragma once

#include <kerf/mesh.h>
#include <kerf/object.h>
#include <kerf/plane.h>

#include <array>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <string>
#include <vector>

// A mesh as the program's own code measures it, and numbers of the library as GLM's.

namespace kerf::tools {

inline glm::vec3 to_glm(const Vec3f& v)
{
    return {v.x, v.y, v.z};
}
inline glm::dvec3 to_glm(const Vec3d& v)
{
    return {v.x, v.y, v.z};
}

/// Along the axes; empty, lo > hi, until something is added.
struct Bounds
{
    glm::vec3 lo{std::numeric_limits<float>::infinity()}, hi{-std::numeric_limits<float>::infinity()};

    void add(const glm::vec3& p)
    {
        lo = glm::min(lo, p);
        hi = glm::max(hi, p);
    }
    glm::dvec3 centre() const { return 0.5 * (glm::dvec3(lo) + glm::dvec3(hi)); }
};

struct Vertex
{
    glm::vec3 position, normal;
    glm::vec2 uv;
};

/// Three vertices, counter-clockwise seen from outside.
using Triangle = std::array<std::uint32_t, 3>;

/// A run of triangles that share their kind, material and solid.
struct TriangleGroup
{
    std::uint32_t first = 0, count = 0;
    std::uint32_t material = 0, solid = 0;
    TriangleKind kind = TriangleKind::surface;
};

struct VertexStream
{
    std::string name;
    std::uint32_t width = 1;
    std::vector<float> values;
};

struct MaterialLook
{
    std::string name;
    std::array<float, 4> colour{1.0f, 1.0f, 1.0f, 1.0f};
    std::string image;

    friend bool operator==(const MaterialLook&, const MaterialLook&) = default;
};

/// A mesh in arrays that can be changed.
struct FlatMesh
{
    std::vector<Vertex> vertices;
    std::vector<std::uint32_t> points;  ///< of each vertex
    std::uint32_t point_count = 0;
    std::vector<Triangle> triangles;
    std::vector<std::uint32_t> sources;  ///< of each triangle
    std::vector<TriangleGroup> groups;   ///< one behind the other, all triangles
    std::vector<VertexStream> streams;
    std::vector<MaterialLook> materials;

    Bounds bounds() const
    {
        Bounds bounds;
        for (const Vertex& v : vertices) bounds.add(v.position);
        return bounds;
    }
};

/// O(n).
FlatMesh flat(const Mesh& mesh);

/// The mesh of an object. O(n). Throws std::runtime_error with one sentence.
FlatMesh flat(const Object& object);

/// A loop or chain of a section.
struct Outline
{
    std::vector<glm::vec3> points;
    bool closed = true;
};

/// Those of the cut that made the object.
std::vector<Outline> outlines_of(const Object& object);

}  // namespace kerf::tools
