#include <algorithm>
#include <cstddef>
#include <limits>

#include "common/drawings/write_drawing.h"

namespace kerf::core::drawings {

namespace {

/// What of the plane is shown, in millimetres, y downwards as in the file.
struct Window
{
    double lo_x = std::numeric_limits<double>::infinity(), lo_y = lo_x, hi_x = -lo_x, hi_y = -lo_x;

    void add(const glm::dvec2& p)
    {
        lo_x = std::min(lo_x, p.x);
        lo_y = std::min(lo_y, p.y);
        hi_x = std::max(hi_x, p.x);
        hi_y = std::max(hi_y, p.y);
    }
};

glm::dvec2 on_page(const Drawing& drawing, const glm::dvec2& place)
{
    return {place.x * drawing.millimetres, -place.y * drawing.millimetres};
}

Window window_of(const Drawing& drawing)
{
    Window window;
    for (const DrawnLayer& layer : drawing.layers)
        for (const DrawnPath& path : layer.paths)
            for (const glm::dvec2& place : path.places) window.add(on_page(drawing, place));
    if (window.lo_x > window.hi_x) return {0.0, 0.0, 1.0, 1.0};
    // Programs show nothing of a page without width or height: a straight chain has one of them.
    const double least = std::max(window.hi_x - window.lo_x, window.hi_y - window.lo_y) / 1000.0;
    if (window.hi_x == window.lo_x) window.hi_x += least > 0.0 ? least : 1.0;
    if (window.hi_y == window.lo_y) window.hi_y += least > 0.0 ? least : 1.0;
    return window;
}

std::string outline_text(const Drawing& drawing, const DrawnPath& path)
{
    std::string text;
    for (std::size_t i = 0; i < path.places.size(); ++i) {
        const glm::dvec2 p = on_page(drawing, path.places[i]);
        text.append(i == 0 ? "M" : "L").append(number_text(p.x)).append(" ").append(number_text(p.y));
    }
    if (path.is_closed) text += "Z";
    return text;
}

/// The numbers of a layer's paths, those of one shape one after the other.
std::vector<std::size_t> by_shape(const DrawnLayer& layer)
{
    std::vector<std::size_t> order(layer.paths.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return layer.paths[a].shape < layer.paths[b].shape; });
    return order;
}

void write_shapes(io::ByteSink& file, const Drawing& drawing, const DrawnLayer& layer)
{
    const std::vector<std::size_t> order = by_shape(layer);
    for (std::size_t first = 0, last; first < order.size(); first = last) {
        const DrawnPath& path = layer.paths[order[first]];
        last = first + 1;
        if (!path.is_closed) {
            file.write("<path class=\"chain\" fill=\"none\" stroke=\"#333\" vector-effect=\"non-scaling-stroke\" d=\"");
            file.write(outline_text(drawing, path));
            file.write("\"/>\n");
            continue;
        }
        file.write("<path d=\"");
        file.write(outline_text(drawing, path));
        for (; last < order.size(); ++last) {
            const DrawnPath& hole = layer.paths[order[last]];
            if (!hole.is_closed || hole.shape != path.shape) break;
            file.write("\n");
            file.write(outline_text(drawing, hole));
        }
        file.write("\"/>\n");
    }
}

/// Layers that lie on one another are contours: filled ones would hide all but the widest.
std::string paint_of(const Drawing& drawing, const Window& window)
{
    constexpr double kStroke = 1e-3;  // of the drawing's larger side
    if (drawing.layers.size() < 2) return "fill=\"#333\"";
    const double side = std::max(window.hi_x - window.lo_x, window.hi_y - window.lo_y);
    return "fill=\"none\" stroke=\"#333\" stroke-width=\"" + number_text(kStroke * side) + "\"";
}

}  // namespace

void write_svg(io::ByteSink& file, const Drawing& drawing)
{
    const Window window = window_of(drawing);
    const std::string width = number_text(window.hi_x - window.lo_x), height = number_text(window.hi_y - window.lo_y);
    std::string head = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<!-- Written by Kerf; one unit of the mesh is 1 ";
    head.append(drawing.unit).append(", one unit of the drawing 1 mm -->\n");
    head.append("<svg xmlns=\"http://www.w3.org/2000/svg\" version=\"1.1\" width=\"").append(width);
    head.append("mm\" height=\"").append(height).append("mm\" viewBox=\"").append(number_text(window.lo_x)).append(" ");
    head.append(number_text(window.lo_y)).append(" ").append(width).append(" ").append(height);
    head.append("\" data-unit=\"").append(drawing.unit).append("\">\n");
    file.write(head);
    const std::string paint = paint_of(drawing, window);
    for (std::size_t i = 0; i < drawing.layers.size(); ++i) {
        const DrawnLayer& layer = drawing.layers[i];
        std::string group = "<g id=\"layer-";
        group.append(std::to_string(i + 1)).append("\" data-height=\"").append(number_text(layer.height));
        file.write(group.append("\" " + paint + " fill-rule=\"evenodd\">\n"));
        write_shapes(file, drawing, layer);
        file.write("</g>\n");
    }
    file.write("</svg>\n");
}

}  // namespace kerf::core::drawings
