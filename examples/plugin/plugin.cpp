// A plug-in: a shared library with one function of C, which cuts. The program that loads it knows nothing of Kerf.

#include <kerf/kerf.h>
#include <kerf/shapes.h>

/// Cuts a shape in two. Returns the area of the section; below 0 if it can't.
extern "C" [[gnu::visibility("default")]] double cut_in_two(const char* shape, double height, unsigned long* triangles)
{
    const kerf::Result<kerf::Mesh> mesh = kerf::make_shape(shape, 10'000);
    if (!mesh) return -1.0;
    kerf::Result<kerf::Object> object = kerf::prepare(*mesh);
    const auto plane = kerf::Plane::y(height);
    if (!object || !plane) return -1.0;
    kerf::Cut cut = kerf::cut(*std::move(object), *plane);
    int i = 0;
    for (const kerf::Side side : {kerf::Side::positive, kerf::Side::negative}) {
        const kerf::Object* const half = cut.one(side);
        triangles[i++] = half != nullptr ? static_cast<unsigned long>(half->triangle_count()) : 0;
    }
    return ok(cut.status) ? cut.section_area : -1.0;
}
