#include "viewer/app/data_folder.h"

#include <system_error>

namespace kerf::app {

std::filesystem::path data_folder()
{
    namespace fs = std::filesystem;
    std::error_code error;
    // Not argv[0], which may be a name on the search path, or a link from elsewhere.
    const fs::path program = fs::read_symlink("/proc/self/exe", error);
    const fs::path folder = program.parent_path() / KERF_DATA_FROM_PROGRAM;
    const fs::path found = fs::canonical(folder, error);
    return error ? folder.lexically_normal() : found;
}

}  // namespace kerf::app
