#include "baseline/report_back_ends.h"

#include <kerf/cut.h>

#include <string>

#include "back_ends/back_ends.h"
#include "baseline/baseline.h"
#include "baseline/report_costs.h"

namespace kerf {

namespace {

core::RegisteredBackend entry_of(core::baseline::VertexLookup lookup)
{
    using core::baseline::VertexLookup;
    core::RegisteredBackend entry;
    entry.name = "baseline/" + std::string(core::baseline::name_of(lookup));
    entry.closes_with_fan = true;
    entry.is_quadratic = lookup == VertexLookup::scan || lookup == VertexLookup::two_bucket_hash;
    entry.make = [lookup] { return core::baseline::make_back_end(lookup); };
    return entry;
}

}  // namespace

void add_report_back_ends()
{
    using core::baseline::VertexLookup;
    for (const VertexLookup lookup :
         {VertexLookup::hash, VertexLookup::remap, VertexLookup::two_bucket_hash, VertexLookup::scan})
        core::add_back_end(entry_of(lookup));
}

ReportCosts report_costs(Cut& cut) noexcept
{
    const Object* piece = cut.piece(Side::positive, 0);
    if (piece == nullptr) piece = cut.piece(Side::negative, 0);
    if (piece == nullptr) return {};
    return {core::baseline::report_costs(*piece->inside()).vertex_comparisons};
}

}  // namespace kerf
