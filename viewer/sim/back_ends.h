#pragma once

#include <kerf/object.h>

#include <string>
#include <string_view>
#include <vector>

namespace kerf::sim {

/// Names of all back ends of this build, the report's among them, as the command line spells them. The first is the
/// default.
const std::vector<std::string>& backend_names();

/// Accepts "baseline" for the default lookup. Empty for a name that this build does not have.
std::string known_back_end(std::string_view name);

/// kerf::prepare() by a back end of that name. Status: `invalid_argument` for an unknown name.
Result<Object> prepare(const Mesh& mesh, const std::string& back_end);

}  // namespace kerf::sim
