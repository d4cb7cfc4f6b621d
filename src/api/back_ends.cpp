#include <kerf/back_ends.h>

#include "api/no_memory.h"
#include "back_ends/back_ends.h"

namespace kerf {

namespace {

BackEndFacts facts_of(const core::RegisteredBackend& entry)
{
    return {entry.name.c_str(), entry.closes_with_fan, entry.is_quadratic};
}

}  // namespace

std::size_t back_end_count() noexcept
{
    return answer_or(std::size_t{0}, [] { return core::back_ends().size(); });
}

BackEndFacts back_end(std::size_t i) noexcept
{
    return answer_or(BackEndFacts(), [&] {
        const auto all = core::back_ends();
        return i < all.size() ? facts_of(*all[i]) : BackEndFacts();
    });
}

BackEndFacts find_back_end(const char* name) noexcept
{
    const core::RegisteredBackend* const entry = name != nullptr ? core::find_back_end(name) : nullptr;
    return entry != nullptr ? facts_of(*entry) : BackEndFacts();
}

}  // namespace kerf
