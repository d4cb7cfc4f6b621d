// A game's loop: each frame draws what is there, while a worker cuts. Nobody waits for anybody: a view that was taken of
// an object stays what it is while relatives of the object are cut.

#include <kerf/kerf.h>
#include <kerf/shapes.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <optional>
#include <thread>
#include <vector>

namespace {

/// A piece on the stage, with the view by which it is drawn.
struct Body
{
    kerf::Object object;
    kerf::DrawView view;
};

/// What the worker is asked for, and what it gives back.
struct Work
{
    kerf::Object object;
    kerf::Plane plane;
    std::optional<kerf::Cut> result;
    std::atomic<bool> is_done = false;
};

/// Stands for the GPU: looks at every vertex that is drawn. Returns how many triangles those of finite vertices are.
std::size_t draw(const kerf::DrawView& view)
{
    std::size_t corners = 0;
    for (const kerf::DrawRange& range : view.ranges)
        for (const std::uint32_t i : view.indices.subspan(range.first_index, range.index_count))
            corners += std::isfinite(view.vertices[i].position.y) ? 1 : 0;
    return corners / 3;
}

bool add(std::vector<Body>& stage, kerf::Object&& object)
{
    Body body;
    body.object = std::move(object);
    if (body.object.draw(body.view) != kerf::Status::done) return false;
    body.object.mark_uploaded(body.view);  // a game uploads what is new of the view before it says so
    stage.push_back(std::move(body));
    return true;
}

/// Through the middle of an object, in a direction that depends on the number.
kerf::Plane plane_through(const kerf::Object& object, int number)
{
    const kerf::Box box = object.bounds();
    const kerf::Point middle(0.5 * (box.lo.x + box.hi.x), 0.5 * (box.lo.y + box.hi.y), 0.5 * (box.lo.z + box.hi.z));
    return *kerf::Plane::at(middle, kerf::Normal(std::cos(number), std::sin(number), 0.3));
}

}  // namespace

int main()
{
    const kerf::Result<kerf::Mesh> torus = kerf::make_shape("torus", 100'000);
    if (!torus) return std::fprintf(stderr, "%s\n", torus.reason()), 1;
    kerf::Result<kerf::Object> whole = kerf::prepare(*torus);
    if (!whole) return std::fprintf(stderr, "%s\n", whole.reason()), 1;

    std::vector<Body> stage;
    if (!add(stage, *std::move(whole))) return 1;
    int frames = 0, cuts = 0;
    std::size_t most_drawn = 0;
    while (cuts < 12) {
        // The oldest piece goes to the worker; its relatives stay on the stage, and are drawn.
        const kerf::Plane plane = plane_through(stage.front().object, cuts);
        Work work{std::move(stage.front().object), plane, {}, false};
        stage.erase(stage.begin());
        std::thread worker([&work] {
            kerf::CutOptions options;
            options.components = true;
            work.result = kerf::cut(std::move(work.object), work.plane, options);
            work.is_done = true;
        });
        do {
            std::size_t drawn = 0;
            for (const Body& body : stage) drawn += draw(body.view);
            most_drawn = std::max(most_drawn, drawn);
            ++frames;
        } while (!work.is_done);
        worker.join();
        ++cuts;

        for (const kerf::Side side : {kerf::Side::positive, kerf::Side::negative})
            for (std::size_t i = 0; kerf::Object* piece = work.result->piece(side, i); ++i)
                if (!add(stage, std::move(*piece))) return 1;
        if (!work.result->object.is_empty() && !add(stage, std::move(work.result->object))) return 1;
    }
    double volume = 0.0;
    for (const Body& body : stage) volume += body.object.mass_properties().volume;
    std::printf("%d cuts, %d frames meanwhile, %zu pieces, together of volume %g; at most %zu triangles in a frame\n",
                cuts, frames, stage.size(), volume, most_drawn);
    return stage.size() > 12 ? 0 : 1;
}
