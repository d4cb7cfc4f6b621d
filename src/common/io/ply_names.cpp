#include "common/io/ply_names.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <string_view>

namespace kerf::core::io {

namespace {

/// Names of the eight floats of a Vertex, in the order of its members.
constexpr std::array<std::string_view, 8> kCoreNames{"x", "y", "z", "nx", "ny", "nz", "s", "t"};
constexpr std::array<std::array<std::string_view, 2>, 4> kUvNames{
    {{"s", "t"}, {"u", "v"}, {"texture_u", "texture_v"}, {"texture_s", "texture_t"}}};
constexpr std::array<std::string_view, 4> kColourNames{"red", "green", "blue", "alpha"};
constexpr std::string_view kColourStream = "color";

bool has_property(const PlyElement& element, std::string_view name)
{
    return std::any_of(element.properties.begin(), element.properties.end(),
                       [&](const PlyProperty& p) { return !p.is_list && p.name == name; });
}

/// Largest value of an integer type: it stands for a full colour.
float full(PlyType type)
{
    switch (type) {
        case PlyType::int8:
            return 127.0f;
        case PlyType::uint8:
            return 255.0f;
        case PlyType::int16:
            return 32767.0f;
        case PlyType::uint16:
            return 65535.0f;
        case PlyType::int32:
            return 2147483648.0f;
        case PlyType::uint32:
            return 4294967296.0f;
        case PlyType::int64:
            return 9223372036854775808.0f;
        case PlyType::uint64:
            return 18446744073709551616.0f;
        case PlyType::float32:
        case PlyType::float64:
            break;
    }
    return 1.0f;
}

/// NAME_3 as "NAME" and 3.
struct Numbered
{
    std::string_view base;
    std::uint32_t number = 0;
};

std::optional<Numbered> numbered(std::string_view name)
{
    const std::size_t bar = name.rfind('_');
    if (bar == std::string_view::npos || bar == 0 || bar + 1 == name.size()) return std::nullopt;
    const std::string_view digits = name.substr(bar + 1);
    Numbered result{name.substr(0, bar), 0};
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), result.number);
    if (error != std::errc() || end != digits.data() + digits.size()) return std::nullopt;
    if (digits.size() > 1 && digits[0] == '0') return std::nullopt;
    return result;
}

class LayoutMaker
{
public:
    explicit LayoutMaker(const PlyElement& vertex) : vertex_(vertex)
    {
        for (const auto& names : kUvNames)
            if (uv_names_ == nullptr && has_property(vertex, names[0]) && has_property(vertex, names[1]))
                uv_names_ = &names;
        has_colour_ = has_property(vertex, "red") && has_property(vertex, "green") && has_property(vertex, "blue");
    }

    PlyVertexLayout make()
    {
        for (const PlyProperty& property : vertex_.properties)
            layout_.destinations.push_back(property.is_list ? PlyDestination{} : destination(property));
        layout_.has_position = has_property(vertex_, "x") && has_property(vertex_, "y") && has_property(vertex_, "z");
        return std::move(layout_);
    }

private:
    PlyDestination destination(const PlyProperty& property)
    {
        constexpr std::uint32_t kUv = 6;
        for (std::uint32_t i = 0; i < kUv; ++i)
            if (property.name == kCoreNames[i]) return {PlyDestination::kCore, i, 1.0f};
        for (std::uint32_t i = 0; i < 2; ++i)
            if (uv_names_ != nullptr && property.name == (*uv_names_)[i]) return {PlyDestination::kCore, kUv + i, 1.0f};
        for (std::uint32_t i = 0; i < kColourNames.size(); ++i)
            if (has_colour_ && property.name == kColourNames[i]) return colour(i, property.type);
        if (const auto part = numbered(property.name)) {
            std::vector<PlyStream>& streams = layout_.streams;
            if (part->number == 0) return {add_stream(std::string(part->base), 1), 0, 1.0f};
            if (!streams.empty() && streams.back().name == part->base && streams.back().width == part->number)
                return {streams.size() - 1, streams.back().width++, 1.0f};
        }
        return {add_stream(property.name, 1), 0, 1.0f};
    }

    PlyDestination colour(std::uint32_t channel, PlyType type)
    {
        if (!colour_stream_)
            colour_stream_ = add_stream(std::string(kColourStream), has_property(vertex_, "alpha") ? 4 : 3);
        return {*colour_stream_, channel, full(type)};
    }

    std::size_t add_stream(std::string name, std::uint32_t width)
    {
        layout_.streams.push_back({std::move(name), width});
        return layout_.streams.size() - 1;
    }

    const PlyElement& vertex_;
    const std::array<std::string_view, 2>* uv_names_ = nullptr;
    bool has_colour_ = false;
    std::optional<std::size_t> colour_stream_;
    PlyVertexLayout layout_;
};

/// True if a property of this name would not become a stream of this name and width 1.
bool is_taken(std::string_view name)
{
    const auto is_name = [&](std::string_view other) { return name == other; };
    return std::any_of(kCoreNames.begin(), kCoreNames.end(), is_name) ||
           std::any_of(kColourNames.begin(), kColourNames.end(), is_name) ||
           std::any_of(kUvNames.begin(), kUvNames.end(),
                       [&](const auto& pair) { return name == pair[0] || name == pair[1]; });
}

}  // namespace

PlyVertexLayout ply_vertex_layout(const PlyElement& vertex)
{
    return LayoutMaker(vertex).make();
}

std::vector<std::string> ply_property_names(const VertexStream& stream)
{
    std::vector<std::string> names;
    if (stream.name == kColourStream && (stream.width == 3 || stream.width == 4)) {
        names.assign(kColourNames.begin(), kColourNames.begin() + stream.width);
        return names;
    }
    std::string name = stream.name.empty() ? "stream" : stream.name;
    std::replace_if(
        name.begin(), name.end(), [](char c) { return c <= ' ' || c == '\x7f'; }, '_');
    if (stream.width == 1 && !is_taken(name) && !numbered(name)) return {name};
    for (std::uint32_t i = 0; i < stream.width; ++i) names.push_back(name + "_" + std::to_string(i));
    return names;
}

}  // namespace kerf::core::io
