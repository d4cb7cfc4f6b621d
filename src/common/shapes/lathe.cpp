#include "common/shapes/lathe.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "common/shapes/corner_grid.h"

namespace kerf::core::shapes {

ProfileRun straight_run(double r0, double z0, double r1, double z1, std::uint32_t parts)
{
    ProfileRun run;
    parts = std::max(parts, 1u);
    require_room(6.0 * double(parts));
    for (std::uint32_t i = 0; i <= parts; ++i) {
        const double t = double(i) / double(parts);
        // The last point as given, so that the next run meets it bit for bit.
        const bool last = i == parts;
        run.push_back({last ? r1 : r0 + t * (r1 - r0), last ? z1 : z0 + t * (z1 - z0), z1 - z0, r0 - r1});
    }
    return run;
}

TriangleSoup turn(const std::vector<ProfileRun>& profile, std::uint32_t slices)
{
    slices = std::max(slices, 3u);
    double triangles = 0.0;
    for (const ProfileRun& run : profile) triangles += 2.0 * double(slices) * double(run.size() - 1);
    require_room(triangles);
    std::vector<double> cosine, sine;
    for (std::uint32_t j = 0; j < slices; ++j) {
        const double angle = 2.0 * std::numbers::pi * double(j) / double(slices);
        cosine.push_back(std::cos(angle));
        sine.push_back(std::sin(angle));
    }
    TriangleSoup soup;
    // One vertex for each slice boundary, the first one again at the end with u = 1; on the axis one in the middle of
    // each slice.
    const auto add_row = [&](const ProfilePoint& point, double v) {
        const auto first = std::uint32_t(soup.vertices.size());
        const bool on_axis = point.r == 0.0;
        for (std::uint32_t j = 0; j < (on_axis ? slices : slices + 1); ++j) {
            const double angle = 2.0 * std::numbers::pi * (double(j) + 0.5) / double(slices);
            const double c = on_axis ? std::cos(angle) : cosine[j % slices];
            const double s = on_axis ? std::sin(angle) : sine[j % slices];
            const glm::dvec3 normal{point.normal_r * c, point.normal_r * s, point.normal_z};
            const double u = (double(j) + (on_axis ? 0.5 : 0.0)) / double(slices);
            soup.vertices.push_back(make_vertex({point.r * c, point.r * s, point.z}, normal, {u, v}));
        }
        return first;
    };
    for (const ProfileRun& run : profile) {
        std::uint32_t below = add_row(run.front(), 0.0);
        for (std::size_t i = 1; i < run.size(); ++i) {
            const std::uint32_t above = add_row(run[i], double(i) / double(run.size() - 1));
            for (std::uint32_t j = 0; j < slices; ++j) {
                if (run[i - 1].r != 0.0) {
                    // Above may be the axis: then this is the only triangle of the slice.
                    soup.triangles.push_back({below + j, below + j + 1, run[i].r != 0.0 ? above + j + 1 : above + j});
                }
                if (run[i].r != 0.0) soup.triangles.push_back({below + j, above + j + 1, above + j});
            }
            below = above;
        }
    }
    return soup;
}

}  // namespace kerf::core::shapes
