#include "common/smooth_normals.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "common/fans.h"

namespace kerf {

namespace {

constexpr std::uint32_t kNoSector = std::numeric_limits<std::uint32_t>::max();

/// The direction of v; 0 where it has none.
glm::dvec3 direction(const glm::dvec3& v)
{
    // Float coordinates: their fourth powers neither overflow nor vanish in double.
    const double length = std::sqrt((v.x * v.x + v.y * v.y) + v.z * v.z);
    return length > 0.0 ? v / length : glm::dvec3(0.0);
}

}  // namespace

SmoothNormals smooth_normals(const LinkedSurface& surface, std::span<const glm::vec3> positions)
{
    constexpr double kDegree = 3.14159265358979323846 / 180.0;
    const double crease_cosine = std::cos(kCreaseAngle * kDegree);

    Buffer<glm::dvec3> face_normals(surface.corners.size());
    for (std::size_t t = 0; t < surface.corners.size(); ++t) {
        const auto& [a, b, c] = surface.corners[t];
        const glm::dvec3 p = positions[a], q = positions[b], r = positions[c];
        face_normals[t] = direction(glm::cross(q - p, r - p));
    }
    // A triangle without area has no normal and makes no crease.
    const auto is_crease = [&](std::uint32_t h) {
        const glm::dvec3 &a = face_normals[h / 3], &b = face_normals[surface.mates[h] / 3];
        return a != glm::dvec3(0.0) && b != glm::dvec3(0.0) && glm::dot(a, b) < crease_cosine;
    };
    const auto angle_at = [&](std::uint32_t corner) {
        const glm::dvec3 p = positions[surface.start(corner)];
        const glm::dvec3 e = direction(glm::dvec3(positions[surface.end(corner)]) - p);
        const glm::dvec3 f = direction(glm::dvec3(positions[surface.start(previous_half_edge(corner))]) - p);
        return std::acos(std::clamp(glm::dot(e, f), -1.0, 1.0));
    };

    SmoothNormals result;
    result.sector.assign(surface.mates.size(), kNoSector);
    for (std::uint32_t h = 0; h < surface.mates.size(); ++h) {
        if (result.sector[h] != kNoSector) continue;
        // Clockwise to where the sector begins: at a crease, at the boundary, or nowhere.
        std::uint32_t first = h;
        while (surface.mates[first] != kNoTwin && !is_crease(first)) {
            first = next_half_edge(surface.mates[first]);
            if (first == h) break;
        }
        const auto number = static_cast<std::uint32_t>(result.normals.size());
        glm::dvec3 sum{0.0};
        std::uint32_t corner = first;
        while (true) {
            result.sector[corner] = number;
            sum += face_normals[corner / 3] * angle_at(corner);
            const std::uint32_t side = previous_half_edge(corner);
            if (surface.mates[side] == kNoTwin || is_crease(side)) break;
            corner = surface.mates[side];
            if (corner == first) break;
        }
        glm::dvec3 normal = direction(sum);
        if (normal == glm::dvec3(0.0)) normal = {0.0, 0.0, 1.0};  // nothing around the point has any area
        result.normals.push_back(glm::vec3(normal));
    }
    return result;
}

}  // namespace kerf
