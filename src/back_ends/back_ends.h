#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "common/cutting/cut.h"

// The one list of back ends, for every program that lets its user choose one by name.

namespace kerf::core {

/// A back end that programs can choose.
struct RegisteredBackend
{
    std::string name;              ///< Backend::name(): "halfedge", "baseline/hash"
    bool closes_with_fan = false;  ///< its caps fit star-shaped sections only
    bool is_quadratic = false;     ///< a cut of n triangles costs O(n^2)
    std::function<std::unique_ptr<Backend>()> make;
    bool is_for_many_cuts = false;  ///< the better choice if an object is cut often: stands before the others
    bool needs_cgal = false;        ///< is not there in programs without CGAL's ways to close sections
    /// One for all who prepare, since it is stateless. Made by the list.
    std::shared_ptr<const Backend> back_end = nullptr;
};

/// All back ends: "halfedge" (if it is linked), the default, then "linear", then "halfedge/cgal" (if CGAL is, too), then
/// those that were added. They live as long as the program. From any thread.
std::vector<const RegisteredBackend*> back_ends();

/// Adds a back end behind the others, or before them if it is for many cuts, unless one of its name is there. From any
/// thread.
void add_back_end(RegisteredBackend entry);

/// The entry of that name, or the first whose name has that first part: "baseline" is "baseline/hash" if that was added
/// first. Null for a name that there is not. From any thread.
const RegisteredBackend* find_back_end(std::string_view name);

}  // namespace kerf::core
