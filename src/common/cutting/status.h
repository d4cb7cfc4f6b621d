#pragma once

#include <cstdint>
#include <string_view>

namespace kerf::core {

/// Outcome of preparing, cutting or detaching. Bad geometry is an expected outcome, not an exception.
enum class Status : std::uint8_t
{
    done,               ///< prepare: the mesh is ready; cut: both sides exist, every section loop was closed
    missed,             ///< all of the object is on one side, or within plane_noise of it: it comes back unharmed
    open_section,       ///< cut; but the object has boundary that the plane crosses: sides are right, open chains are
                        ///< not capped
    invalid_argument,   ///< a plane that is not finite, or whose normal is not a unit vector, or a scale of uv that is
                        ///< not finite, or caps that this build has no way
                        ///< to make: the object comes back
    invalid_mesh,       ///< prepare: the mesh breaks what IndexedMesh promises; cut: there is nothing to cut
    out_of_memory,      ///< the object comes back unharmed
    cancelled,          ///< prepare: the caller asked to stop
    not_separated = 8,  ///< cut: CutOptions::only would leave one piece, or one on both sides; the object comes back
};
std::string_view name_of(Status status);

}  // namespace kerf::core
