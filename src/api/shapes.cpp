#include <kerf/shapes.h>

#include "api/mesh_data.h"
#include "api/no_memory.h"
#include "common/shapes/shapes.h"

namespace kerf {

Result<Mesh> make_shape(const char* name, std::uint64_t triangles, std::uint64_t seed) noexcept
{
    return result_of<Mesh>("there is not enough memory for the shape", [&]() -> Result<Mesh> {
        std::optional<core::TriangleSoup> soup = core::shapes::make(name != nullptr ? name : "", triangles, seed);
        if (!soup) return {Status::invalid_argument, Sentence("there is no such shape; shape_name() lists them")};
        core::Repaired repaired = core::repair(*std::move(soup));
        if (!repaired.error.empty()) return {Status::invalid_mesh, Sentence(repaired.error.c_str())};
        return Mesh(new Mesh::Data(std::move(repaired.mesh)));
    });
}

const char* shape_name(std::size_t i) noexcept
{
    return answer_or(static_cast<const char*>(nullptr), [&] {
        const std::vector<std::string>& names = core::shapes::names();
        return i < names.size() ? names[i].c_str() : nullptr;
    });
}

}  // namespace kerf
