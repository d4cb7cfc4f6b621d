#include <kerf/drawing.h>

#include <memory>

#include "api/convert.h"
#include "api/file_answers.h"
#include "common/drawings/write_drawing.h"

namespace kerf {

namespace {

constexpr const char* kNothingToDraw = "there is nothing to draw: no section has a loop or a chain";

/// The number that loops have in common which are filled together: that of an outer loop, which a hole lies in.
std::uint32_t shape_of(const Section& section, std::uint32_t path)
{
    const SectionPath loop = section.path(path);
    return loop.area < 0.0 && loop.parent != kNone ? loop.parent : path;
}

core::drawings::DrawnLayer layer_of(const Section& section)
{
    core::drawings::DrawnLayer layer;
    const SectionFrame& frame = section.frame;
    layer.height = frame.height;
    for (std::uint32_t i = 0; i < section.path_count(); ++i) {
        const SectionPath path = section.path(i);
        core::drawings::DrawnPath& drawn = layer.paths.emplace_back();
        drawn.is_closed = path.is_closed;
        drawn.is_hole = path.is_closed && path.area < 0.0;
        drawn.shape = shape_of(section, i);
        drawn.places.reserve(path.points.size());
        drawn.points.reserve(path.points.size());
        for (const Vec3f& p : path.points) {
            const Vec2d place = frame.to_plane(p);
            drawn.places.emplace_back(place.x, place.y);
            drawn.points.emplace_back(p.x, p.y, p.z);
        }
    }
    return layer;
}

core::drawings::Drawing drawing_of(std::span<const Section> sections, const DrawingOptions& options)
{
    core::drawings::Drawing drawing;
    drawing.millimetres = millimetres(options.unit);
    drawing.unit = text(options.unit);
    for (const Section& section : sections) drawing.layers.push_back(layer_of(section));
    return drawing;
}

bool is_empty(std::span<const Section> sections)
{
    return std::ranges::all_of(sections, [](const Section& section) { return section.path_count() == 0; });
}

}  // namespace

const char* text(LengthUnit unit) noexcept
{
    switch (unit) {
        case LengthUnit::millimetre:
            break;
        case LengthUnit::centimetre:
            return "cm";
        case LengthUnit::metre:
            return "m";
        case LengthUnit::inch:
            return "in";
        case LengthUnit::foot:
            return "ft";
    }
    return "mm";
}

double millimetres(LengthUnit unit) noexcept
{
    switch (unit) {
        case LengthUnit::millimetre:
            break;
        case LengthUnit::centimetre:
            return 10.0;
        case LengthUnit::metre:
            return 1000.0;
        case LengthUnit::inch:
            return 25.4;
        case LengthUnit::foot:
            return 304.8;
    }
    return 1.0;
}

Outcome write_drawing(std::span<const Section> sections, const char* path, const DrawingOptions& options) noexcept
{
    if (path == nullptr || *path == '\0') return {Status::invalid_argument, Sentence("there is no name of a file")};
    if (is_empty(sections)) return {Status::invalid_argument, Sentence(kNothingToDraw)};
    return answer_of_file<Outcome>([&] {
        core::drawings::write_drawing(path, drawing_of(sections, options));
        return Outcome();
    });
}

Result<FileBytes> drawing_bytes(std::span<const Section> sections, const char* format,
                                const DrawingOptions& options) noexcept
{
    if (format == nullptr) return {Status::invalid_argument, Sentence("there is no name of a format")};
    if (is_empty(sections)) return {Status::invalid_argument, Sentence(kNothingToDraw)};
    return answer_of_file<Result<FileBytes>>([&]() -> Result<FileBytes> {
        auto data = std::make_unique<FileBytes::Data>();
        data->text = core::drawings::drawing_bytes(drawing_of(sections, options), format);
        return FileBytes(data.release());
    });
}

}  // namespace kerf
