#include "common/files/file_error.h"

#include <algorithm>
#include <cctype>

namespace kerf::core::io {

void fail(const std::filesystem::path& path, const std::string& reason)
{
    // A name may hold line ends and control characters; a message is one line.
    std::string name = path.string();
    std::replace_if(
        name.begin(), name.end(), [](unsigned char c) { return std::iscntrl(c) != 0; }, '?');
    throw FileError(name + ": " + reason);
}

}  // namespace kerf::core::io
