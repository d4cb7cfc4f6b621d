#pragma once

#include <cstdint>

#include "common/cutting/cut.h"

namespace kerf::core::baseline {

/// What only the report's method does in a cut, counted for both sides together.
struct ReportCosts
{
    std::uint64_t vertex_comparisons = 0;  ///< vertices compared while looking for duplicates; exact
};

/// The costs of a cut by one of the baseline's back ends; zeros of a miss, and of a cut by another back end. Its
/// fragments carry them: ask before they are moved away. O(1).
ReportCosts report_costs(const CutResult& result);
/// The same, of one of its fragments.
ReportCosts report_costs(const Cuttable& fragment);

}  // namespace kerf::core::baseline
