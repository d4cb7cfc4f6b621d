// thousand_cuts [TRIANGLES]: one asteroid is shaved a thousand times, and every hundredth cut says what it has cost.

#include <kerf/kerf.h>
#include <kerf/shapes.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>

int main(int argc, char** argv)
{
    const std::uint64_t triangles = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 200'000;
    const kerf::Result<kerf::Mesh> asteroid = kerf::make_shape("asteroid", triangles);
    if (!asteroid) return std::fprintf(stderr, "%s\n", asteroid.reason()), 1;
    kerf::PrepareOptions often;
    often.cuts_expected = 1000;
    kerf::Result<kerf::Object> object = kerf::prepare(*asteroid, often);
    if (!object) return std::fprintf(stderr, "%s\n", object.reason()), 1;

    kerf::Object rest = *std::move(object);
    std::printf("%s: %llu triangles\n", rest.back_end_name(), static_cast<unsigned long long>(rest.triangle_count()));
    const double radius = 0.5 * (asteroid->bounds().hi.x - asteroid->bounds().lo.x);
    int cuts = 0;
    double ms = 0.0;
    for (int i = 0; i < 1000; ++i) {
        // Planes turn around the asteroid and come nearer: each takes a thin piece off. (Golden angle: even all around.)
        const double angle = 2.399963 * i, height = 1.0 - 2.0 * ((i * 7919) % 1000 + 0.5) / 1000.0;
        const double ring = std::sqrt(1.0 - height * height);
        const kerf::Normal outwards(ring * std::cos(angle), ring * std::sin(angle), height);
        const double distance = radius * (1.0 - 0.0005 * i);
        const kerf::Plane plane = *kerf::Plane::at(
            kerf::Point(kerf::Vec3d(outwards.x * distance, outwards.y * distance, outwards.z * distance)), outwards);
        const auto start = std::chrono::steady_clock::now();
        kerf::Cut cut = kerf::cut(std::move(rest), plane);
        const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - start;
        if (kerf::Object* inside = cut.one(kerf::Side::negative)) {
            ++cuts;
            ms += time.count();
            rest = std::move(*inside);
        } else {
            rest = std::move(cut.object);
        }
        if (rest.is_empty()) return std::fprintf(stderr, "%s\n", kerf::outcome_name(cut.status)), 1;
        // Many cuts leave an object scattered over buffers that its pieces have filled.
        if (rest.is_scattered() && rest.compact() != kerf::Status::done) return std::fprintf(stderr, "no memory\n"), 1;
        if (i % 100 == 99)
            std::printf("%4d planes, %3d cuts, %.3f ms a cut, %llu triangles left\n", i + 1, cuts,
                        cuts > 0 ? ms / cuts : 0.0, static_cast<unsigned long long>(rest.triangle_count()));
    }
    return cuts > 100 ? 0 : 1;
}
