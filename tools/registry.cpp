#include "tools/registry.h"

#include <algorithm>
#include <array>
#include <stdexcept>

#include "baseline/baseline.h"
#ifdef KERF_HAS_HALFEDGE
#include "halfedge/halfedge.h"
#endif

namespace kerf::tools {

namespace {

RegisteredBackend baseline_entry()
{
    using baseline::VertexLookup;
    static constexpr std::array kLookups{VertexLookup::hash, VertexLookup::remap, VertexLookup::two_bucket_hash,
                                         VertexLookup::scan};
    RegisteredBackend entry;
    entry.name = "baseline";
    entry.description = "the report's loop over every triangle, and a fan over the section's mean point";
    entry.closes_with_fan = true;
    for (const VertexLookup lookup : kLookups) entry.lookups.emplace_back(name_of(lookup));
    entry.make = [](const std::string& name) {
        for (const VertexLookup lookup : kLookups)
            if (name == name_of(lookup)) return baseline::make_backend(lookup);
        return baseline::make_backend();
    };
    return entry;
}

#ifdef KERF_HAS_HALFEDGE
RegisteredBackend halfedge_entry()
{
    RegisteredBackend entry;
    entry.name = "halfedge";
    entry.description = "a tree finds the section, a walk over neighbours cuts it, triangulations close it";
    entry.make = [](const std::string&) { return halfedge::make_backend(); };
    return entry;
}
#endif

/// For a back end that lacks a lookup: which there are, and which back end has them if it has none.
std::string lookups_text(const RegisteredBackend& asked)
{
    const std::vector<RegisteredBackend>& all = registered_backends();
    const auto has_lookups = [](const RegisteredBackend& entry) { return !entry.lookups.empty(); };
    const auto other = std::find_if(all.begin(), all.end(), has_lookups);
    std::string text = has_lookups(asked) ? "it is one of " : "only the back end " + other->name + " has lookups, ";
    for (const std::string& one : (has_lookups(asked) ? asked : *other).lookups) {
        if (text.back() != ' ') text += ", ";
        text += one;
    }
    return text;
}

}  // namespace

const std::vector<RegisteredBackend>& registered_backends()
{
    static const std::vector<RegisteredBackend> all{
#ifdef KERF_HAS_HALFEDGE
        halfedge_entry(),
#endif
        baseline_entry(),
    };
    return all;
}

std::unique_ptr<Backend> make_backend(const std::string& name, const std::string& lookup)
{
    for (const RegisteredBackend& entry : registered_backends()) {
        if (entry.name != name) continue;
        const bool known = std::find(entry.lookups.begin(), entry.lookups.end(), lookup) != entry.lookups.end();
        if (!lookup.empty() && !known)
            throw std::invalid_argument("the back end " + name + " has no lookup called '" + lookup +
                                        "': " + lookups_text(entry));
        return entry.make(lookup);
    }
    return nullptr;
}

}  // namespace kerf::tools
