#include "common/cutting/back_end_helpers.h"
#include "common/mesh/tolerances.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <tuple>
#include <utility>

namespace kerf::core {

void merge_ranges(std::vector<DrawRange>& ranges)
{
    const auto in_order = [](const DrawRange& a, const DrawRange& b) {
        return std::tie(a.kind, a.material, a.first_index) < std::tie(b.kind, b.material, b.first_index);
    };
    if (!std::is_sorted(ranges.begin(), ranges.end(), in_order)) std::sort(ranges.begin(), ranges.end(), in_order);
    std::size_t last = 0;
    for (std::size_t i = 1; i < ranges.size(); ++i) {
        DrawRange& before = ranges[last];
        const DrawRange& range = ranges[i];
        const bool follows = before.kind == range.kind && before.material == range.material &&
                             before.first_index + before.index_count == range.first_index;
        if (follows)
            before.index_count += range.index_count;
        else
            ranges[++last] = range;
    }
    if (!ranges.empty()) ranges.resize(last + 1);
}

namespace {

/// "cap" is 0, "cap.7" is 7. Others have none: no number is spelt in two ways.
std::optional<std::uint32_t> cap_number(std::string_view name)
{
    constexpr std::string_view kCap = "cap";
    if (name.substr(0, kCap.size()) != kCap) return std::nullopt;
    if (name == kCap) return 0;
    const std::string_view digits = name.substr(kCap.size() + 1);
    if (name[kCap.size()] != '.' || digits.empty() || digits.front() == '0') return std::nullopt;
    std::uint32_t number = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
    if (error != std::errc() || end != digits.data() + digits.size()) return std::nullopt;
    return number;
}

/// A number that no name has: there are more numbers than names, so some part of the numbers has fewer names than
/// numbers, and a part of that again. At most four passes (one for fewer than 256 materials: larger parts can't be full
/// then), without memory: back ends call this when nothing may fail any more.
std::uint32_t free_cap_number(const std::vector<Material>& materials)
{
    std::uint64_t first = 0;
    int bits = 24;
    while (bits > 0 && materials.size() < std::size_t(1) << bits) bits -= 8;
    for (; bits >= 0; bits -= 8) {
        std::array<std::uint64_t, 256> names{};
        for (const Material& material : materials)
            if (const auto number = cap_number(material.name); number && *number >= first)
                if (const std::uint64_t part = (*number - first) >> bits; part < names.size()) ++names[part];
        const std::uint64_t numbers = std::uint64_t(1) << bits;
        const auto part = std::find_if(names.begin(), names.end(), [&](std::uint64_t n) { return n < numbers; });
        first += static_cast<std::uint64_t>(part - names.begin()) << bits;
    }
    return static_cast<std::uint32_t>(first);
}

}  // namespace

std::uint32_t add_cap_material(std::vector<Material>& materials)
{
    const std::uint32_t number = free_cap_number(materials);
    std::string name = number == 0 ? "cap" : "cap." + std::to_string(number);  // as short as needs no memory
    materials.push_back({std::move(name), glm::vec4(1.0f), {}});
    return static_cast<std::uint32_t>(materials.size() - 1);
}

bool caps_exceed_section(double excess, double section_area, double section_length, double unit)
{
    return excess > std::max(kCapAgreement * std::abs(section_area), unit * section_length);
}
}  // namespace kerf::core
