#pragma once

#include <string>
#include <vector>

namespace kerf::tools {

/// Back ends that a user asks for by one name and a lookup: those of the library and of the report, with
/// "family/lookup" taken apart.
struct BackendFamily
{
    std::string name;
    std::string description;           ///< one line for help texts
    std::vector<std::string> lookups;  ///< ways to look up vertices, the default first; empty: there is no choice
    bool closes_with_fan = false;      ///< its caps fit star-shaped sections only
};

/// All families that this program was built with, the default first.
const std::vector<BackendFamily>& backend_families();

/// What may be asked for: each family, and each "family/lookup".
std::vector<std::string> backend_choices();

/// The family that a name begins with.
std::string family_of(const std::string& name);

/// The name by which the library knows the back end; empty if there is none.
/// @param name    one of backend_choices()
/// @param lookup  empty: the one of the name, or the default
/// @throws std::invalid_argument  the back end has no such lookup, or the name has another one; one sentence
std::string full_name(const std::string& name, const std::string& lookup = {});

}  // namespace kerf::tools
