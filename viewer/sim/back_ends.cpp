#include "viewer/sim/back_ends.h"

#include "baseline/report_back_ends.h"

namespace kerf::sim {

namespace {

/// The room that is asked for, as cuts through the middle: a swipe or two cuts what flies and its pieces a dozen times,
/// and a piece has fewer triangles in its section.
constexpr std::uint32_t kCutsOfAThrow = 8;

}  // namespace

const std::vector<std::string>& backend_names()
{
    static const std::vector<std::string> names = [] {
        std::vector<std::string> all;
        add_report_back_ends();
        for (std::size_t i = 0; i < back_end_count(); ++i) all.emplace_back(back_end(i).name);
        return all;
    }();
    return names;
}

std::string known_back_end(std::string_view name)
{
    add_report_back_ends();
    return find_back_end(std::string(name).c_str()).name;
}

Result<Object> prepare(const Mesh& mesh, const std::string& back_end)
{
    add_report_back_ends();
    PrepareOptions options;
    options.back_end_name = back_end.c_str();
    options.cuts_with_room = kCutsOfAThrow;
    return kerf::prepare(mesh, options);
}

}  // namespace kerf::sim
