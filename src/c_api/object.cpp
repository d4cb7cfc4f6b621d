#include <kerf/c.h>

#include <algorithm>
#include <memory>
#include <optional>

#include "c_api/calls.h"
#include "c_api/handles.h"

using namespace kerf::c_api;

kerf_status kerf_plane_to_local(const kerf_plane* world, const double object_to_world[16], kerf_plane* local)
{
    const std::optional<kerf::Plane> plane = read_plane(world);
    if (!plane || object_to_world == nullptr) return KERF_INVALID_ARGUMENT;
    const std::optional<kerf::Plane> found = plane->to_local(kerf::Mat4d::from_columns(object_to_world));
    if (!found) return KERF_INVALID_ARGUMENT;
    kerf_plane to{};
    const kerf::Normal n = found->normal();
    put(to.normal, n);
    put(to.point, kerf::Vec3d(n.x * found->offset(), n.y * found->offset(), n.z * found->offset()));
    return fill_struct(local, to);
}

kerf_status kerf_prepare(const kerf_mesh* mesh, const kerf_prepare_options* options, kerf_object** object, char* reason,
                         size_t reason_size)
{
    const Reason why(reason, reason_size);
    if (object == nullptr) return why.wrong("there is no place for the object");
    *object = nullptr;
    if (mesh == nullptr) return why.wrong("there is no mesh");
    const std::optional<kerf_prepare_options> given = read_options(options);
    if (!given) return why.wrong(kWrongStruct);
    kerf::PrepareOptions asked;
    Listener listener{given->progress, given->user};
    asked.back_end_name = given->back_end;
    if (given->cuts_expected != 0) asked.cuts_expected = given->cuts_expected;
    if (given->cuts_with_room != 0) asked.cuts_with_room = given->cuts_with_room;
    if (given->threads != 0) asked.threads = given->threads;
    listener.listen_to(asked);
    kerf::Result<kerf::Object> made = kerf::prepare(mesh->mesh, asked);
    if (!made) return why.answer(made.status(), made.reason());
    return with_memory(why, [&] {
        *object = new kerf_object(*std::move(made));
        return KERF_DONE;
    });
}

kerf_status kerf_object_clone(const kerf_object* object, kerf_object** copy)
{
    if (copy == nullptr) return KERF_INVALID_ARGUMENT;
    *copy = nullptr;
    if (object == nullptr) return KERF_INVALID_ARGUMENT;
    kerf::Result<kerf::Object> made = object->object.clone();
    if (!made) return to_c(made.status());
    return with_memory(Reason(nullptr, 0), [&] {
        *copy = new kerf_object(*std::move(made));
        return KERF_DONE;
    });
}

kerf_status kerf_object_get_facts(const kerf_object* object, kerf_object_facts* facts)
{
    if (object == nullptr) return KERF_INVALID_ARGUMENT;
    const kerf::Object& from = object->object;
    const kerf::MassProperties mass = from.mass_properties();
    const kerf::Box box = from.bounds();
    kerf_object_facts to{};
    to.is_solid = mass.is_of_solid ? 1 : 0;
    to.triangle_count = from.triangle_count();
    put(to.lo, box.lo);
    put(to.hi, box.hi);
    to.volume = mass.volume;
    put(to.centre_of_mass, mass.centre);
    std::copy_n(&mass.inertia.m[0][0], 9, to.inertia);
    to.back_end = from.back_end_name();
    return fill_struct(facts, to);
}

kerf_status kerf_object_get_mesh(const kerf_object* object, kerf_mesh** mesh)
{
    if (mesh == nullptr) return KERF_INVALID_ARGUMENT;
    *mesh = nullptr;
    if (object == nullptr) return KERF_INVALID_ARGUMENT;
    kerf::Result<kerf::Mesh> made = object->object.mesh();
    if (!made) return to_c(made.status());
    return with_memory(Reason(nullptr, 0), [&] {
        *mesh = new kerf_mesh(*std::move(made));
        return KERF_DONE;
    });
}
