#include "bench/back_ends.h"

#include "baseline/baseline.h"
#ifdef KERF_HAS_HALFEDGE
#include "halfedge/halfedge.h"
#endif

namespace kerf::bench {

const std::vector<TimedBackend>& back_ends()
{
    using baseline::VertexLookup;
    constexpr std::uint64_t kQuadraticLimit = 30'000, kNoLimit = UINT64_MAX;
    static const std::vector<TimedBackend> all{
        {baseline::make_backend(VertexLookup::scan), kQuadraticLimit},
        {baseline::make_backend(VertexLookup::two_bucket_hash), kQuadraticLimit},
        {baseline::make_backend(VertexLookup::hash), kNoLimit},
        {baseline::make_backend(VertexLookup::remap), kNoLimit},
#ifdef KERF_HAS_HALFEDGE
        {halfedge::make_backend(), kNoLimit},
#endif
    };
    return all;
}

}  // namespace kerf::bench
