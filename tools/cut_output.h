#pragma once

#include <kerf/cut.h>

#include <optional>
#include <string>
#include <vector>

#include "tools/cut_report.h"
#include "tools/mesh_files.h"

namespace kerf::tools {

/// Which files `kerf cut` writes.
struct CutOutput
{
    std::string prefix;                   ///< the beginning of their names
    std::string format;                   ///< one of writable_formats()
    std::optional<Side> keep;             ///< that side alone
    std::vector<std::string> kept_files;  ///< that no piece replaces, besides the mesh

    /// PREFIX.positive.obj, or PREFIX.positive.0.obj for one of several components.
    std::string file_name(Side side, std::optional<std::size_t> component) const;
};

/// Adds the pieces of a cut to the files, and to the report of it. With `components` each has a file.
/// @throws FileError
void add_pieces(MeshFileSet& files, const CutOutput& output, bool components, Cut& cut, CutReport& report);

}  // namespace kerf::tools
