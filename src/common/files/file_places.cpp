#include "common/files/file_places.h"

#include <system_error>

#include "common/files/output_file.h"

namespace kerf::core::io {

namespace fs = std::filesystem;

void refuse_to_replace(const fs::path& output, std::span<const fs::path> inputs)
{
    std::error_code ignored;
    for (const fs::path& input : inputs)
        if (fs::equivalent(output, input, ignored))
            fail(output, "it would replace what is read, " + input.string() + "; choose another name");
}

void fail_for_same_place(const fs::path& output)
{
    fail(output, "another file of the same call is written to this place; choose another name");
}

void refuse_same_place(const fs::path& output, std::span<const fs::path> others)
{
    for (const fs::path& other : others)
        if (place_of(other) == place_of(output)) fail_for_same_place(output);
}

}  // namespace kerf::core::io
