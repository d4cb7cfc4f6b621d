#include "viewer/sim/back_ends.h"

#include <algorithm>

#include "baseline/baseline.h"
#ifdef KERF_HAS_HALFEDGE
#include "halfedge/halfedge.h"
#endif

namespace kerf::sim {
namespace {

using baseline::VertexLookup;
constexpr VertexLookup kLookups[] = {VertexLookup::hash, VertexLookup::remap, VertexLookup::scan,
                                     VertexLookup::two_bucket_hash};

}  // namespace

const std::vector<std::string>& backend_names()
{
    static const std::vector<std::string> names = [] {
        std::vector<std::string> all;
#ifdef KERF_HAS_HALFEDGE
        all.push_back(halfedge::make_backend()->name());
#endif
        for (const VertexLookup lookup : kLookups) all.push_back(baseline::make_backend(lookup)->name());
        return all;
    }();
    return names;
}

std::string find_backend(std::string_view name)
{
    if (name == "baseline") name = "baseline/hash";
    const auto& names = backend_names();
    const auto found = std::find(names.begin(), names.end(), name);
    return found == names.end() ? std::string() : *found;
}

std::unique_ptr<Backend> make_backend(std::string_view name)
{
    const std::string wanted = find_backend(name);
#ifdef KERF_HAS_HALFEDGE
    if (std::unique_ptr<Backend> backend = halfedge::make_backend(); backend->name() == wanted) return backend;
#endif
    for (const VertexLookup lookup : kLookups)
        if (std::unique_ptr<Backend> backend = baseline::make_backend(lookup); backend->name() == wanted)
            return backend;
    return nullptr;
}

}  // namespace kerf::sim
