#include "support/backends.h"

#include <algorithm>

#include "back_ends/back_ends.h"
#include "baseline/report_back_ends.h"

namespace kerf::core::test {

const std::vector<NamedBackend>& backends()
{
    static const std::vector<NamedBackend> all = [] {
        std::vector<NamedBackend> named;
        add_report_back_ends();
        for (const RegisteredBackend* entry : back_ends()) {
#ifdef KERF_BRIEF_TESTS
            if (entry->is_quadratic) continue;
#endif
            // But for its caps it is the half-edge back end: cap_quality_test.cpp.
            if (entry->needs_cgal) continue;
            std::string name = entry->name;
            std::replace(name.begin(), name.end(), '/', '_');
            named.push_back({std::move(name), entry->make});
        }
        std::reverse(named.begin(), named.end());
        return named;
    }();
    return all;
}

std::vector<NamedBackend> one_of_each_kind()
{
    std::vector<NamedBackend> chosen;
    for (const NamedBackend& backend : backends())
        if (backend.name == "halfedge" || backend.name == "baseline_hash") chosen.push_back(backend);
    return chosen;
}

}  // namespace kerf::core::test
