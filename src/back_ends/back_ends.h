#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "common/cutting/cut.h"

// The one list of back ends, for every program that lets its user choose one by name.

namespace kerf::core {

/// A back end that this build has.
struct RegisteredBackend
{
    std::string name;              ///< Backend::name(): "halfedge", "baseline/hash"
    bool closes_with_fan = false;  ///< its caps fit star-shaped sections only
    bool is_quadratic = false;     ///< a cut of n triangles costs O(n^2)
    std::function<std::unique_ptr<Backend>()> make;
};

/// All back ends of this build, the default first: "halfedge" (if built), "linear", then the report's four look-ups as
/// "baseline/hash", "baseline/remap", "baseline/two_bucket_hash" and "baseline/scan".
const std::vector<RegisteredBackend>& back_ends();

/// The entry of that name; "baseline" means "baseline/hash". Null for a name that this build does not have.
const RegisteredBackend* find_back_end(std::string_view name);

/// Makes the back end of that name. Null for a name that this build does not have.
std::unique_ptr<Backend> make_back_end(std::string_view name);

}  // namespace kerf::core
