#include <cmath>
#include <string>

#include "common/io/bytes.h"
#include "common/io/write_formats.h"

namespace kerf::core::io {

namespace {

/// Unit normal of a triangle; zero if it has no area, as the format asks for.
glm::vec3 facet_normal(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c)
{
    const glm::dvec3 e = glm::dvec3(b) - glm::dvec3(a), f = glm::dvec3(c) - glm::dvec3(a);
    const glm::dvec3 n{e.y * f.z - e.z * f.y, e.z * f.x - e.x * f.z, e.x * f.y - e.y * f.x};
    const double length = std::hypot(n.x, n.y, n.z);
    return length > 0.0 ? glm::vec3(n / length) : glm::vec3(0.0f);
}

}  // namespace

void write_stl(ByteSink& file, const IndexedMesh& mesh)
{
    constexpr std::size_t kHeaderBytes = 80, kFlushBytes = 1 << 20;
    // Not "solid": readers take that for text.
    std::string bytes = "binary STL, written by Kerf";
    bytes.resize(kHeaderBytes, ' ');
    store_little(bytes, static_cast<std::uint32_t>(mesh.triangles.size()));
    const auto store = [&](const glm::vec3& p) {
        for (int axis = 0; axis < 3; ++axis) store_little(bytes, p[axis]);
    };
    for (const Triangle& t : mesh.triangles) {
        const glm::vec3 &a = mesh.vertices[t[0]].position, &b = mesh.vertices[t[1]].position,
                        &c = mesh.vertices[t[2]].position;
        store(facet_normal(a, b, c));
        store(a);
        store(b);
        store(c);
        store_little(bytes, std::uint16_t{0});
        if (bytes.size() > kFlushBytes) {
            file.write(bytes);
            bytes.clear();
        }
    }
    file.write(bytes);
}

}  // namespace kerf::core::io
