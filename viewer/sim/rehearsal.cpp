#include "viewer/sim/rehearsal.h"

#include <kerf/cut.h>
#include <kerf/draw.h>
#include <kerf/mass.h>
#include <kerf/proxy.h>
#include <kerf/shapes.h>

#include <cstdint>
#include <mutex>
#include <optional>
#include <set>

#include "viewer/sim/back_ends.h"

namespace kerf::sim {

namespace {

/// All that a game asks of the pieces of a cut. What fails here is not needed.
void cut_for_practice(const Object& whole, const Normal& normal)
{
    Result<Object> object = whole.clone();
    const std::optional<Plane> plane = Plane::at(Point(0.0, 0.0, 0.0), normal);
    if (!object || !plane) return;
    CutOptions options;
    options.components = true;
    Cut pieces = cut(*std::move(object), *plane, options);
    for (const Side side : {Side::positive, Side::negative})
        for (std::size_t i = 0; Object* const piece = pieces.piece(side, i); ++i) {
            DrawView view;
            static_cast<void>(piece->draw(view));
            static_cast<void>(piece->mass_properties());
            static_cast<void>(bounded_hull(*piece));
        }
}

}  // namespace

void rehearse(const std::string& back_end)
{
    constexpr std::uint64_t kTriangles = 5'000;  // more than the models have
    static std::mutex mutex;
    static std::set<std::string> done;
    const std::lock_guard lock(mutex);
    if (!done.insert(back_end).second) return;
    const Result<Mesh> ring = make_shape("torus", kTriangles);
    if (!ring) return;
    const Result<Object> whole = prepare(*ring, back_end);
    if (!whole) return;
    // One outline, two side by side, and one inside another.
    for (const Normal& normal : {Normal(1.0, 0.1, 0.2), Normal(0.1, 1.0, 0.2), Normal(0.2, 0.1, 1.0)})
        cut_for_practice(*whole, normal);
}

}  // namespace kerf::sim
