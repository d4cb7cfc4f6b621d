#include "tools/registry.h"

#include <kerf/back_ends.h>

#include <algorithm>
#include <stdexcept>

#include "baseline/report_back_ends.h"

namespace kerf::tools {

namespace {

std::string description_of(const std::string& family)
{
    if (family == "baseline") return "the report's loop over every triangle, and a fan over the section's mean point";
    if (family == "halfedge")
        return "a tree finds the section, a walk over neighbours cuts it, triangulations close it";
    if (family == "halfedge/cgal") return "halfedge, and CGAL's Delaunay triangulation closes every section";
    if (family == "linear") return "a loop over every triangle, index tables, and the same triangulations";
    return {};
}

/// For a back end that lacks a lookup: which there are, and which back end has them if it has none.
std::string lookups_text(const BackendFamily& asked)
{
    const std::vector<BackendFamily>& all = backend_families();
    const auto has_lookups = [](const BackendFamily& entry) { return !entry.lookups.empty(); };
    const auto other = std::find_if(all.begin(), all.end(), has_lookups);
    std::string text = has_lookups(asked) ? "it is one of " : "only the back end " + other->name + " has lookups, ";
    for (const std::string& one : (has_lookups(asked) ? asked : *other).lookups) {
        if (text.back() != ' ') text += ", ";
        text += one;
    }
    return text;
}

}  // namespace

const std::vector<BackendFamily>& backend_families()
{
    static const std::vector<BackendFamily> all = [] {
        std::vector<BackendFamily> families;
        add_report_back_ends();
        for (std::size_t i = 0; i < back_end_count(); ++i) {
            const BackEndFacts entry = back_end(i);
            const std::string whole = entry.name;
            const std::size_t slash = whole.find('/');
            // Beside a back end that is called by the first part alone, a longer name is one of its own.
            const bool has_lookup = slash != std::string::npos &&
                                    find_back_end(whole.substr(0, slash).c_str()).name != whole.substr(0, slash);
            const std::string name = has_lookup ? whole.substr(0, slash) : whole;
            if (families.empty() || families.back().name != name)
                families.push_back({name, description_of(name), {}, entry.closes_with_fan});
            if (has_lookup) families.back().lookups.push_back(whole.substr(slash + 1));
        }
        return families;
    }();
    return all;
}

std::vector<std::string> backend_choices()
{
    std::vector<std::string> choices;
    for (const BackendFamily& family : backend_families()) {
        choices.push_back(family.name);
        for (const std::string& lookup : family.lookups) choices.push_back(family.name + "/" + lookup);
    }
    return choices;
}

std::string family_of(const std::string& name)
{
    const std::vector<BackendFamily>& all = backend_families();
    const bool is_one = std::any_of(all.begin(), all.end(), [&](const auto& entry) { return entry.name == name; });
    return is_one ? name : name.substr(0, name.find('/'));
}

std::string full_name(const std::string& name, const std::string& lookup)
{
    if (const std::string family = family_of(name); family != name) {
        const std::string named = name.substr(family.size() + 1);
        if (!lookup.empty() && lookup != named)
            throw std::invalid_argument("the back end " + name + " has a lookup already, which is not '" + lookup +
                                        "'");
        return full_name(family, named);
    }
    for (const BackendFamily& family : backend_families()) {
        if (family.name != name) continue;
        if (lookup.empty()) return family.lookups.empty() ? name : name + "/" + family.lookups.front();
        if (std::find(family.lookups.begin(), family.lookups.end(), lookup) == family.lookups.end())
            throw std::invalid_argument("the back end " + name + " has no lookup called '" + lookup +
                                        "': " + lookups_text(family));
        return name + "/" + lookup;
    }
    return {};
}

}  // namespace kerf::tools
