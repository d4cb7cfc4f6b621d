#include "common/io/soup_builder.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/io/read_formats.h"
#include "common/mesh/is_finite.h"

namespace kerf::core::io {

namespace {

/// Vertex and index numbers are 32 bits wide, and so is the number of corners.
constexpr std::size_t kMostVertices = std::numeric_limits<std::uint32_t>::max() - 1;
constexpr std::size_t kMostTriangles = std::numeric_limits<std::uint32_t>::max() / 3;

}  // namespace

std::uint32_t SoupBuilder::add_vertex(const Vertex& vertex)
{
    if (soup.vertices.size() >= kMostVertices)
        fail(path_, "the mesh has more than 2^32 vertices; divide it into several");
    soup.vertices.push_back(vertex);
    return static_cast<std::uint32_t>(soup.vertices.size() - 1);
}

void SoupBuilder::add_face(std::span<const std::uint32_t> corners)
{
    const std::uint64_t face = faces_++;
    if (corners.size() < 3) {
        ++faces_without_surface_;
        return;
    }
    for (const std::uint32_t corner : corners)
        if (corner >= soup.vertices.size())
            fail(path_, "face " + std::to_string(face) + " names vertex " + std::to_string(corner) +
                            ", but there are only " + std::to_string(soup.vertices.size()) +
                            ", counted from 0; mend the face or take it out");
    if (soup.triangles.size() + (corners.size() - 2) > kMostTriangles)
        fail(path_, "the mesh has more than 2^32 corners; divide it into several");
    if (!triangulate_polygon(corners, soup.vertices, soup.triangles, concave_budget_))
        fail(path_, "face " + std::to_string(face) + " has " + std::to_string(corners.size()) +
                        " corners and is not convex, which is too long, or one too many of such length (counted from "
                        "0); divide it");
    if (material_ != kNone) soup.triangle_materials.resize(soup.triangles.size(), material_);
}

void SoupBuilder::use_material(const std::string& name)
{
    // Faces before the first material have one without a name.
    if (material_ == kNone && !soup.triangles.empty()) {
        material_of_name_.emplace(std::string(), 0);
        soup.materials.emplace_back();
        soup.triangle_materials.resize(soup.triangles.size(), 0);
    }
    const auto [found, is_new] = material_of_name_.emplace(name, static_cast<std::uint32_t>(soup.materials.size()));
    if (is_new) soup.materials.emplace_back().name = name;
    material_ = found->second;
}

TriangleSoup SoupBuilder::finish()
{
    if (soup.triangles.empty()) fail(path_, "there are no triangles in it; export it with faces");
    notes_.add("faces of fewer than three corners passed over", faces_without_surface_);
    finish_positions();
    finish_attributes();
    return std::move(soup);
}

void SoupBuilder::finish_positions()
{
    const auto is_bad = [](const Vertex& v) { return !is_finite(v.position); };
    if (std::any_of(soup.vertices.begin(), soup.vertices.end(), is_bad)) {
        for (const Triangle& triangle : soup.triangles)
            for (const std::uint32_t i : triangle)
                if (is_bad(soup.vertices[i])) fail_at_unfit(i);
        // A vertex that no face uses may lie anywhere; at the place of a used one it does not widen the bounds.
        const glm::vec3 place = soup.vertices[soup.triangles[0][0]].position;
        std::uint64_t unused = 0;
        for (Vertex& v : soup.vertices)
            if (is_bad(v)) {
                v.position = place;
                ++unused;
            }
        notes_.add(kUnusedVertices, unused);
    }
}

void SoupBuilder::fail_at_unfit(std::uint32_t vertex) const
{
    const auto place = std::find_if(unfit_.begin(), unfit_.end(), [&](const Unfit& u) { return u.vertex == vertex; });
    if (place == unfit_.end())
        fail(path_, "vertex " + std::to_string(vertex) +
                        " has a coordinate that is not finite or too large for single precision; give it another, or "
                        "take it and its faces out");
    float ignored = 0.0f;
    fail(path_, "line " + std::to_string(place->line) + ": " +
                    explain(parse_float(place->word, ignored), place->word, "a coordinate"));
}

void SoupBuilder::finish_attributes()
{
    const UnfitAttributes unfit = clean(soup);
    notes_.add(kBadNormals, unfit.normals);
    notes_.add(kBadUvs, unfit.uvs);
    notes_.add(kBadValues, clean_streams(soup));
}

}  // namespace kerf::core::io
