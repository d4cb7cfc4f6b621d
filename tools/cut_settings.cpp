#include "tools/cut_settings.h"

#include <stdexcept>

#include "tools/flat_mesh.h"

namespace kerf::tools {

namespace {

glm::dvec3 centre_of(const Box& box)
{
    return 0.5 * (glm::dvec3(to_glm(box.lo)) + glm::dvec3(to_glm(box.hi)));
}

}  // namespace

Plane CutSettings::plane_in(const Box& bounds) const
{
    const std::optional<Plane> found =
        plane ? plane : Plane::at(Point(point.value_or(centre_of(bounds))), Normal(normal.value()));
    if (!found) throw std::runtime_error("the plane's numbers are too large to calculate with");
    return *found;
}

CutOptions CutSettings::options() const
{
    CutOptions made;
    made.cap = cap;
    made.components = components;
    made.gap = gap;
    made.only = only;
    made.cap_quality = cap_quality;
    return made;
}

}  // namespace kerf::tools
