#include "bench/back_ends.h"

#include <utility>

#include "baseline/report_back_ends.h"

namespace kerf::bench {

Result<Object> TimedBackEnd::prepare(Mesh mesh, unsigned threads) const
{
    PrepareOptions options;
    options.threads = threads;
    options.back_end_name = name.c_str();
    return kerf::prepare(std::move(mesh), options);
}

const std::vector<TimedBackEnd>& back_ends()
{
    constexpr std::uint64_t kQuadraticLimit = 30'000, kNoLimit = UINT64_MAX;
    static const std::vector<TimedBackEnd> all = [] {
        std::vector<TimedBackEnd> timed;
        add_report_back_ends();
        for (std::size_t i = 0; i < back_end_count(); ++i) {
            const BackEndFacts facts = back_end(i);
            timed.insert(timed.begin(), {facts.name, facts.is_quadratic ? kQuadraticLimit : kNoLimit});
        }
        return timed;
    }();
    return all;
}

}  // namespace kerf::bench
