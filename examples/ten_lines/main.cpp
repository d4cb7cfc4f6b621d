// ten_lines [FILE]: cuts a mesh by the plane y = the middle of its bounds, and writes the upper half to top.obj.

#include <kerf/io.h>
#include <kerf/kerf.h>

#include <cstdio>

int main(int argc, char** argv)
{
    const kerf::Result<kerf::Mesh> mesh = kerf::read_mesh(argc > 1 ? argv[1] : "rook.obj");
    if (!mesh) return std::fprintf(stderr, "%s\n", mesh.reason()), 1;
    kerf::Result<kerf::Object> object = kerf::prepare(*mesh);
    if (!object) return std::fprintf(stderr, "%s\n", object.reason()), 1;

    const kerf::Box box = mesh->bounds();
    kerf::Cut cut = kerf::cut(*std::move(object), *kerf::Plane::y(0.5 * (box.lo.y + box.hi.y)));
    std::printf("%s, area of the section %g\n", kerf::outcome_name(cut.status), cut.section_area);

    if (kerf::Object* top = cut.one(kerf::Side::positive))
        if (const kerf::Outcome written = kerf::write_mesh(*top->mesh(), "top.obj"); !written)
            return std::fprintf(stderr, "%s\n", written.reason()), 1;
}
