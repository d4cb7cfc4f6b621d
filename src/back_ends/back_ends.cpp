#include "back_ends/back_ends.h"

#include <algorithm>

#include "baseline/baseline.h"
#include "linear/linear.h"
#ifdef KERF_HAS_HALFEDGE
#include "halfedge/halfedge.h"
#endif

namespace kerf::core {

namespace {

RegisteredBackend baseline_entry(baseline::VertexLookup lookup)
{
    using baseline::VertexLookup;
    RegisteredBackend entry;
    entry.name = "baseline/" + std::string(name_of(lookup));
    entry.closes_with_fan = true;
    entry.is_quadratic = lookup == VertexLookup::scan || lookup == VertexLookup::two_bucket_hash;
    entry.make = [lookup] { return baseline::make_back_end(lookup); };
    return entry;
}

}  // namespace

const std::vector<RegisteredBackend>& back_ends()
{
    using baseline::VertexLookup;
    static const std::vector<RegisteredBackend> all{
#ifdef KERF_HAS_HALFEDGE
        {"halfedge", false, false, [] { return halfedge::make_back_end(); }},
#endif
        {"linear", false, false, [] { return linear::make_back_end(); }},
        baseline_entry(VertexLookup::hash),
        baseline_entry(VertexLookup::remap),
        baseline_entry(VertexLookup::two_bucket_hash),
        baseline_entry(VertexLookup::scan),
    };
    return all;
}

const RegisteredBackend* find_back_end(std::string_view name)
{
    if (name == "baseline") name = "baseline/hash";
    const std::vector<RegisteredBackend>& all = back_ends();
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const RegisteredBackend& entry) { return entry.name == name; });
    return found == all.end() ? nullptr : &*found;
}

std::unique_ptr<Backend> make_back_end(std::string_view name)
{
    const RegisteredBackend* const entry = find_back_end(name);
    return entry == nullptr ? nullptr : entry->make();
}

}  // namespace kerf::core
