#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <string_view>
#include <vector>

namespace kerf::maker {

/// A closed polygon of the surface, counter-clockwise seen from outside. It need not be quite flat; it is shaded as
/// one flat facet unless `smoothing` joins it to its neighbours.
struct Facet
{
    std::vector<int> points;              ///< point of each corner
    std::vector<glm::dvec2> uvs;          ///< texture coordinate of each corner; empty: projected along an axis
    std::string_view material = "ivory";  ///< a name of models.mtl
    int smoothing = 0;                    ///< 0: flat; facets of equal non-zero number share averaged normals
};

/// The polygons that a model is built from. Points are shared, so a surface made of strips that use the same points
/// is watertight by construction. Y points up.
struct PolyMesh
{
    std::vector<glm::dvec3> points;
    std::vector<Facet> facets;

    int add_point(const glm::dvec3& p);

    /// Adds a facet; equal consecutive points are merged, and nothing is added when fewer than three are left. So a
    /// grid may collapse to a line or a point where a shape ends.
    void add_facet(std::vector<int> loop, std::string_view material, std::vector<glm::dvec2> uvs = {},
                   int smoothing = 0);

    /// Puts a new point at the middle of the edge a-b into both facets beside it: two triangles more. O(facets).
    /// Returns the new point; throws std::logic_error where there is no such edge.
    int split_edge(int a, int b);

    /// Mean of the facets' vector areas, normalised (Newell).
    glm::dvec3 facet_normal(const Facet& facet) const;

    /// Moves every point by `offset` after multiplying by `scale`.
    void transform(double scale, const glm::dvec3& offset);

    /// Scales so that the longest side of the bounding box is `size` and puts the box's centre in the origin.
    void fit(double size);
};

/// Area vector of a polygon, whose length is the area (Newell).
glm::dvec3 newell(const std::vector<glm::dvec3>& loop);

}  // namespace kerf::maker
