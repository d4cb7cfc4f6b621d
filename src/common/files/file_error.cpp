#include "common/files/file_error.h"

#include <algorithm>
#include <cctype>

namespace kerf::core::io {

namespace {

/// A name may hold line ends and control characters; a message is one line.
std::string sentence_of(const std::filesystem::path& path, const std::string& reason)
{
    std::string name = path.string();
    std::replace_if(
        name.begin(), name.end(), [](unsigned char c) { return std::iscntrl(c) != 0; }, '?');
    return name + ": " + reason;
}

}  // namespace

void fail(const std::filesystem::path& path, const std::string& reason)
{
    throw FileError(sentence_of(path, reason));
}

void fail_without_memory(const std::filesystem::path& path, const std::string& to_do_and_remedy)
{
    throw NoMemoryForFile(sentence_of(path, "there is not enough memory to " + to_do_and_remedy));
}

}  // namespace kerf::core::io
