#include <vector>

#include "common/io/text_writer.h"
#include "common/io/write_formats.h"

namespace kerf::core::io {

void write_off(ByteSink& file, const IndexedMesh& mesh)
{
    TextWriter out(file);
    out << "OFF\n# Written by Kerf\n"
        << mesh.point_count << " " << static_cast<std::uint32_t>(mesh.triangles.size()) << " 0\n";
    // One line for each point, so that other programs see the same connectivity.
    std::vector<std::uint32_t> line_of_point(mesh.point_count, mesh.point_count);
    std::uint32_t lines = 0;
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
        std::uint32_t& line = line_of_point[mesh.points[v]];
        if (line != mesh.point_count) continue;
        line = lines++;
        const glm::vec3& p = mesh.vertices[v].position;
        out << p.x << " " << p.y << " " << p.z << "\n";
    }
    for (const Triangle& triangle : mesh.triangles) {
        out << "3";
        for (const std::uint32_t v : triangle) out << " " << line_of_point[mesh.points[v]];
        out << "\n";
    }
    out.flush();
}

}  // namespace kerf::core::io
