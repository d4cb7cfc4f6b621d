#include "common/repair/smooth_normals.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "common/repair/vertex_fans.h"

namespace kerf::core {

namespace {

constexpr std::uint32_t kNoSector = std::numeric_limits<std::uint32_t>::max();

/// Float coordinates: their fourth powers neither overflow nor vanish in double.
double length(const glm::dvec3& v)
{
    return std::sqrt((v.x * v.x + v.y * v.y) + v.z * v.z);
}

}  // namespace

SmoothNormals smooth_normals(const LinkedSurface& surface, std::span<const glm::vec3> positions, double crease_degrees)
{
    constexpr double kPi = 3.14159265358979323846;
    const double crease_cosine = std::cos(crease_degrees / 180.0 * kPi);

    Buffer<glm::dvec3> face_normals(surface.corners.size());
    Buffer<float> angles(surface.opposite.size());  // of the triangle at each corner
    for (std::size_t t = 0; t < surface.corners.size(); ++t) {
        const auto& [a, b, c] = surface.corners[t];
        const glm::dvec3 p = positions[a], q = positions[b], r = positions[c];
        const glm::dvec3 normal = glm::cross(q - p, r - p);
        const double area2 = length(normal);
        face_normals[t] = area2 > 0.0 ? normal / area2 : glm::dvec3(0.0);
        const double at_p = std::atan2(area2, glm::dot(q - p, r - p)), at_q = std::atan2(area2, glm::dot(r - q, p - q));
        angles[3 * t] = static_cast<float>(at_p);
        angles[3 * t + 1] = static_cast<float>(at_q);
        angles[3 * t + 2] = static_cast<float>(std::max(0.0, kPi - at_p - at_q));
    }
    // A triangle without area has no normal and makes no crease.
    const auto is_crease = [&](std::uint32_t h) {
        const glm::dvec3 &a = face_normals[h / 3], &b = face_normals[surface.opposite[h] / 3];
        return a != glm::dvec3(0.0) && b != glm::dvec3(0.0) && glm::dot(a, b) < crease_cosine;
    };
    SmoothNormals result;
    result.sector.assign(surface.opposite.size(), kNoSector);
    result.normals.reserve(positions.size());
    for (std::uint32_t h = 0; h < surface.opposite.size(); ++h) {
        if (result.sector[h] != kNoSector) continue;
        // Clockwise to where the sector begins: at a crease, at the boundary, or nowhere.
        std::uint32_t first = h;
        while (surface.opposite[first] != kNone && !is_crease(first)) {
            first = next_halfedge(surface.opposite[first]);
            if (first == h) break;
        }
        const auto number = static_cast<std::uint32_t>(result.normals.size());
        glm::dvec3 sum{0.0};
        std::uint32_t corner = first;
        while (true) {
            result.sector[corner] = number;
            sum += face_normals[corner / 3] * double(angles[corner]);
            const std::uint32_t side = previous_halfedge(corner);
            if (surface.opposite[side] == kNone || is_crease(side)) break;
            corner = surface.opposite[side];
            if (corner == first) break;
        }
        const double size = length(sum);
        // Perhaps no triangle around the point has any area.
        result.normals.push_back(size > 0.0 ? glm::vec3(sum / size) : glm::vec3(0.0f, 0.0f, 1.0f));
    }
    return result;
}

}  // namespace kerf::core
