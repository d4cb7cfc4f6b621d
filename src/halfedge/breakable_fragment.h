#pragma once

#include <memory>

#include "common/cutting/breakable.h"
#include "halfedge/fragment.h"

namespace kerf::core::halfedge {

/// For Cuttable::breakable().
///
/// @param copy            no other object shares its universe
/// @param material_count  of the object
std::unique_ptr<Breakable> make_breakable(std::shared_ptr<SharedUniverse> copy, std::span<const ShellRoot> shells,
                                          std::size_t material_count);

}  // namespace kerf::core::halfedge
