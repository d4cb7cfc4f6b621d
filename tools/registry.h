#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "common/cutting/cut.h"

namespace kerf::tools {

/// A back end that a user can ask for by name.
struct RegisteredBackend
{
    std::string name;
    std::string description;           ///< one line for help texts
    std::vector<std::string> lookups;  ///< ways to look up vertices, the default first; empty: there is no choice
    bool closes_with_fan = false;      ///< its caps fit star-shaped sections only
    std::function<std::unique_ptr<Backend>(const std::string& lookup)> make;  ///< takes "" or one of `lookups`
};

/// All back ends that this program was built with, the default first.
const std::vector<RegisteredBackend>& registered_backends();

/// The back end of this name; null when there is none. An empty `lookup` means the default.
/// @throws std::invalid_argument  the back end has no such lookup; one sentence
std::unique_ptr<Backend> make_backend(const std::string& name, const std::string& lookup = {});

}  // namespace kerf::tools
