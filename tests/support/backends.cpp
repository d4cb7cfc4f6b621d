#include "support/backends.h"

#include "baseline/baseline.h"
#ifdef KERF_HAS_HALFEDGE
#include "halfedge/halfedge.h"
#endif

namespace kerf::test {

const std::vector<NamedBackend>& backends()
{
    using baseline::VertexLookup;
    static const std::vector<NamedBackend> all{
#ifndef KERF_BRIEF_TESTS
        {"baseline_scan", [] { return baseline::make_backend(VertexLookup::scan); }},
        {"baseline_two_bucket_hash", [] { return baseline::make_backend(VertexLookup::two_bucket_hash); }},
#endif
        {"baseline_hash", [] { return baseline::make_backend(VertexLookup::hash); }},
        {"baseline_remap", [] { return baseline::make_backend(VertexLookup::remap); }},
#ifdef KERF_HAS_HALFEDGE
        {"halfedge", [] { return halfedge::make_backend(); }},
#endif
    };
    return all;
}

std::vector<NamedBackend> one_of_each_kind()
{
    std::vector<NamedBackend> chosen;
    for (const NamedBackend& backend : backends())
        if (backend.name == "halfedge" || backend.name == "baseline_hash") chosen.push_back(backend);
    return chosen;
}

}  // namespace kerf::test
