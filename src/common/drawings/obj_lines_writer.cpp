#include <cstdint>

#include "common/drawings/write_drawing.h"

namespace kerf::core::drawings {

void write_obj_lines(io::ByteSink& file, const Drawing& drawing)
{
    file.write("# Written by Kerf\n");
    std::uint64_t next = 1;
    for (std::size_t i = 0; i < drawing.layers.size(); ++i) {
        file.write("g layer-");
        file.write(std::to_string(i + 1));
        file.write("\n");
        for (const DrawnPath& path : drawing.layers[i].paths) {
            std::string text;
            for (const glm::vec3& p : path.points) {
                text += "v";
                for (int axis = 0; axis < 3; ++axis) text.append(" ").append(number_text(p[axis]));
                text += "\n";
            }
            text += "l";
            for (std::size_t point = 0; point < path.points.size(); ++point)
                text.append(" ").append(std::to_string(next + point));
            if (path.is_closed) text.append(" ").append(std::to_string(next));
            text += "\n";
            file.write(text);
            next += path.points.size();
        }
    }
}

}  // namespace kerf::core::drawings
