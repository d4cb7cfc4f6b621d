#include <kerf/c.h>
#include <kerf/fracture.h>

#include <cstdint>
#include <memory>
#include <new>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "c_api/calls.h"
#include "c_api/handles.h"

namespace kerf::c_api {
namespace {

constexpr bool is_zero(const double (&v)[3])
{
    return v[0] == 0.0 && v[1] == 0.0 && v[2] == 0.0;
}

/// Sites are set by the caller of this function, who keeps them.
FractureOptions to_options(const kerf_fracture_options& given)
{
    FractureOptions options;
    options.pattern = static_cast<FracturePattern>(given.pattern);
    if (given.cells != 0) options.cells = given.cells;
    options.seed = given.seed;
    if (given.has_at != 0) options.at = Point(to_vec3d(given.at));
    if (!is_zero(given.direction)) options.direction = Normal(to_vec3d(given.direction));
    options.least_volume = given.least_volume;
    if (given.material != 0) options.material = given.material - 1;
    if (given.uv_scale != 0.0) options.uv_scale = given.uv_scale;
    return options;
}

void append(std::vector<double>& numbers, const Vec3d& v)
{
    numbers.insert(numbers.end(), {v.x, v.y, v.z});
}

/// Cells and bonds as flat arrays. May throw std::bad_alloc.
void flatten(kerf_fracture& f)
{
    f.cell_starts.assign(1, 0);
    for (std::size_t i = 0; i < f.fracture.count(); ++i) {
        const std::span<const std::uint32_t> cells = f.fracture.cells(i);
        f.cells.insert(f.cells.end(), cells.begin(), cells.end());
        f.cell_starts.push_back(f.cells.size());
    }
    for (const FractureBond& bond : f.fracture.bonds()) {
        f.bonds.insert(f.bonds.end(), {bond.first, bond.second});
        f.areas.push_back(bond.area);
        append(f.centres, bond.centre);
        append(f.normals, bond.normal);
    }
}

}  // namespace
}  // namespace kerf::c_api

using namespace kerf::c_api;

kerf_status kerf_fracture_make(const kerf_object* object, const kerf_fracture_options* options,
                               kerf_fracture** fracture, char* reason, size_t reason_size)
{
    const Reason why(reason, reason_size);
    if (fracture == nullptr) return why.wrong("there is no place for the fracture");
    *fracture = nullptr;
    if (object == nullptr) return why.wrong("there is no object");
    const std::optional<kerf_fracture_options> given = read_options(options);
    if (!given) return why.wrong(kWrongStruct);
    if (given->pattern < KERF_UNIFORM || given->pattern > KERF_SPLINTERS) return why.wrong("there is no such pattern");
    if (given->sites == nullptr && given->site_count != 0) return why.wrong("the sites are null");
    if (given->site_count > UINT32_MAX) return why.wrong("there are too many sites");
    return with_memory(why, [&]() -> kerf_status {
        kerf::FractureOptions wanted = to_options(*given);
        std::vector<kerf::Vec3d> sites(given->site_count);
        for (std::size_t i = 0; i < sites.size(); ++i)
            sites[i] = {given->sites[3 * i], given->sites[3 * i + 1], given->sites[3 * i + 2]};
        wanted.sites = sites;
        Listener listener{given->progress, given->user};
        listener.listen_to(wanted);
        auto made = std::make_unique<kerf_fracture>();
        made->fracture = kerf::fracture(object->object, wanted);
        if (!ok(made->fracture.status())) return why.answer(made->fracture.status(), made->fracture.reason());
        flatten(*made);
        *fracture = made.release();
        return KERF_DONE;
    });
}

kerf_status kerf_fracture_get_arrays(const kerf_fracture* fracture, kerf_fracture_arrays* arrays)
{
    if (fracture == nullptr) return KERF_INVALID_ARGUMENT;
    kerf_fracture_arrays to{};
    to.piece_count = fracture->fracture.count();
    to.cell_starts = fracture->cell_starts.data();
    to.cells = fracture->cells.data();
    to.site_count = fracture->fracture.sites().size();
    to.sites = to.site_count == 0 ? nullptr : &fracture->fracture.sites().data()->x;
    to.bond_count = fracture->areas.size();
    to.bonds = fracture->bonds.data();
    to.areas = fracture->areas.data();
    to.centres = fracture->centres.data();
    to.normals = fracture->normals.data();
    return fill_struct(arrays, to);
}

kerf_object* kerf_fracture_take(kerf_fracture* fracture, size_t i)
{
    if (fracture == nullptr) return nullptr;
    kerf::Object* const piece = fracture->fracture.piece(i);
    if (piece == nullptr || piece->is_empty()) return nullptr;
    return new (std::nothrow) kerf_object(std::move(*piece));
}
