#include <algorithm>
#include <array>
#include <utility>

#include "common/drawings/write_drawing.h"

// DXF R12, which every program reads: groups of two lines, a code and a value (Autodesk, "DXF Reference", R12).

namespace kerf::core::drawings {

namespace {

constexpr const char* kOuter = "OUTER";
constexpr const char* kHoles = "HOLES";
constexpr const char* kChains = "CHAINS";

std::string group(int code, const std::string& value)
{
    return std::to_string(code) + "\n" + value + "\n";
}

std::string place_text(double x, double y, double z)
{
    return group(10, number_text(x)) + group(20, number_text(y)) + group(30, number_text(z));
}

const char* layer_of(const DrawnPath& path)
{
    if (!path.is_closed) return kChains;
    return path.is_hole ? kHoles : kOuter;
}

std::string header_text()
{
    return group(0, "SECTION") + group(2, "HEADER") + group(9, "$ACADVER") + group(1, "AC1009") + group(0, "ENDSEC");
}

std::string tables_text()
{
    std::string text = group(0, "SECTION") + group(2, "TABLES");
    text += group(0, "TABLE") + group(2, "LTYPE") + group(70, "1") + group(0, "LTYPE") + group(2, "CONTINUOUS") +
            group(70, "0") + group(3, "Solid line") + group(72, "65") + group(73, "0") + group(40, "0") +
            group(0, "ENDTAB");
    text += group(0, "TABLE") + group(2, "LAYER") + group(70, "3");
    constexpr std::array kColours{std::pair{kOuter, "7"}, std::pair{kHoles, "1"}, std::pair{kChains, "3"}};
    for (const auto& [name, colour] : kColours)
        text += group(0, "LAYER") + group(2, name) + group(70, "0") + group(62, colour) + group(6, "CONTINUOUS");
    return text + group(0, "ENDTAB") + group(0, "ENDSEC");
}

void write_polyline(io::ByteSink& file, const Drawing& drawing, const DrawnPath& path, double height)
{
    const std::string layer = group(8, layer_of(path));
    file.write(group(0, "POLYLINE") + layer + group(66, "1") + place_text(0.0, 0.0, height) +
               group(70, path.is_closed ? "1" : "0"));
    for (const glm::dvec2& place : path.places)
        file.write(group(0, "VERTEX") + layer +
                   place_text(place.x * drawing.millimetres, place.y * drawing.millimetres, height));
    file.write(group(0, "SEQEND") + layer);
}

}  // namespace

void write_dxf(io::ByteSink& file, const Drawing& drawing)
{
    file.write(
        group(999, "Written by Kerf; one unit of the mesh is 1 " + drawing.unit + ", one unit of the drawing 1 mm") +
        header_text() + tables_text() + group(0, "SECTION") + group(2, "ENTITIES"));
    // One section is a drawing; several stand above one another as they do in the mesh.
    const bool has_heights = drawing.layers.size() > 1;
    for (const DrawnLayer& layer : drawing.layers)
        for (const DrawnPath& path : layer.paths)
            write_polyline(file, drawing, path, has_heights ? layer.height * drawing.millimetres : 0.0);
    file.write(group(0, "ENDSEC") + group(0, "EOF"));
}

}  // namespace kerf::core::drawings
