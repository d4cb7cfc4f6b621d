#include <kerf/mesh.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "api/mesh_data.h"

namespace kerf {

namespace {

/// A weight below is 0: a position in float is known to 6e-8 of the coordinates.
constexpr double kNoWeight = 1e-6;

/// What an input says of triangles, read with its strides.
class InputTriangles
{
public:
    explicit InputTriangles(const MeshInput& input) : input_(input) {}

    std::array<std::uint32_t, 3> corners(std::size_t triangle) const
    {
        const auto first = static_cast<std::uint32_t>(3 * triangle);
        if (input_.indices == nullptr) return {first, first + 1, first + 2};
        return {input_.indices[first], input_.indices[first + 1], input_.indices[first + 2]};
    }

    bool has(std::size_t triangle) const
    {
        if (triangle >= input_.triangle_count) return false;
        const auto c = corners(triangle);
        return std::all_of(c.begin(), c.end(), [&](std::uint32_t v) { return v < input_.vertex_count; });
    }

    glm::dvec3 position(std::uint32_t vertex) const
    {
        float p[3];
        std::memcpy(p, reinterpret_cast<const char*>(input_.positions) + vertex * input_.position_stride, sizeof(p));
        return {p[0], p[1], p[2]};
    }

private:
    const MeshInput& input_;
};

/// Weights of a and b in the point of the line that is nearest to p.
std::array<double, 2> weights_on_edge(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b)
{
    const glm::dvec3 ab = b - a;
    const double square = glm::dot(ab, ab), t = square > 0.0 ? std::clamp(glm::dot(p - a, ab) / square, 0.0, 1.0) : 0.0;
    return {1.0 - t, t};
}

/// Weights of the corners in the point of the triangle that is nearest to p (Ericson, "Real-Time Collision Detection",
/// 5.1.5).
std::array<double, 3> weights_in_triangle(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b,
                                          const glm::dvec3& c)
{
    for (const auto& [corner, weights] :
         {std::pair{a, std::array{1.0, 0.0, 0.0}}, std::pair{b, std::array{0.0, 1.0, 0.0}},
          std::pair{c, std::array{0.0, 0.0, 1.0}}})
        if (p == corner) return weights;
    const glm::dvec3 ab = b - a, ac = c - a, ap = p - a, bp = p - b, cp = p - c;
    const double d1 = glm::dot(ab, ap), d2 = glm::dot(ac, ap);
    const double d3 = glm::dot(ab, bp), d4 = glm::dot(ac, bp);
    const double d5 = glm::dot(ab, cp), d6 = glm::dot(ac, cp);
    const double va = d3 * d6 - d5 * d4, vb = d5 * d2 - d1 * d6, vc = d1 * d4 - d3 * d2;
    if (va > 0.0 && vb > 0.0 && vc > 0.0) {
        const double sum = va + vb + vc;
        return {va / sum, vb / sum, vc / sum};
    }
    // On an edge, or a triangle without area: the nearest of the three edges.
    const auto ends_ab = weights_on_edge(p, a, b), ends_bc = weights_on_edge(p, b, c),
               ends_ca = weights_on_edge(p, c, a);
    const std::array<std::array<double, 3>, 3> found{
        {{ends_ab[0], ends_ab[1], 0.0}, {0.0, ends_bc[0], ends_bc[1]}, {ends_ca[1], 0.0, ends_ca[0]}}};
    const auto distance = [&](const std::array<double, 3>& w) {
        const glm::dvec3 away = (w[0] * a + w[1] * b + w[2] * c) - p;
        return glm::dot(away, away);
    };
    return *std::min_element(found.begin(), found.end(),
                             [&](const auto& x, const auto& y) { return distance(x) < distance(y); });
}

VertexOrigin origin_of(const glm::dvec3& p, std::size_t triangle, const InputTriangles& input)
{
    const auto corners = input.corners(triangle);
    const auto weights =
        weights_in_triangle(p, input.position(corners[0]), input.position(corners[1]), input.position(corners[2]));
    // A point of an edge is beside it by what it was rounded to float.
    const auto counts = [](double weight) { return weight < kNoWeight ? 0.0 : weight; };
    const double sum = counts(weights[0]) + counts(weights[1]) + counts(weights[2]);
    VertexOrigin origin;
    for (std::size_t i = 0; i < 3; ++i) {
        origin.vertices[i] = corners[i];
        origin.weights[i] = static_cast<float>(counts(weights[i]) / sum);
    }
    return origin;
}

}  // namespace

Status vertex_origins(const Mesh& mesh, const MeshInput& input, std::span<VertexOrigin> origins) noexcept
{
    if (origins.size() != mesh.vertex_count() || input.positions == nullptr || !has_right_strides(input))
        return Status::invalid_argument;
    if (mesh.is_empty()) return Status::done;
    const core::IndexedMesh& inside = mesh.data()->mesh();
    const InputTriangles triangles(input);
    for (const std::uint32_t source : inside.sources)
        if (source != core::kNoSource && !triangles.has(source)) return Status::invalid_argument;

    std::fill(origins.begin(), origins.end(), VertexOrigin());
    for (std::size_t t = 0; t < inside.triangles.size(); ++t) {
        if (inside.sources[t] == core::kNoSource) continue;
        for (const std::uint32_t v : inside.triangles[t])
            if (origins[v].vertices[0] == kNone)
                origins[v] = origin_of(glm::dvec3(inside.vertices[v].position), inside.sources[t], triangles);
    }
    return Status::done;
}

}  // namespace kerf
