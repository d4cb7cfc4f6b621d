#pragma once

#include <string>

#include "halfedge/fragment.h"
#include "support/check_universe.h"

namespace kerf::core::halfedge {

/// What is inconsistent in the mesh that a fragment is part of; empty: nothing. O(n).
inline std::string faults(const Cuttable& object)
{
    const auto& fragment = dynamic_cast<const Fragment&>(object);
    return check_universe(fragment.universe(), fragment.shells());
}

}  // namespace kerf::core::halfedge
