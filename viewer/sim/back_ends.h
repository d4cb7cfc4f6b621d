#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "common/cutting/cut.h"

namespace kerf::sim {

/// Names of all back ends of this build (back_ends()), as the command line spells them. The first is the default.
const std::vector<std::string>& backend_names();

/// Accepts "baseline" for the default lookup. Empty for a name that this build does not have.
std::string known_back_end(std::string_view name);

/// Null for an unknown name.
std::unique_ptr<Backend> make_back_end(std::string_view name);

}  // namespace kerf::sim
