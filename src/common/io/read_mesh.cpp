#include <new>
#include <utility>

#include "common/files/read_file.h"
#include "common/io/mesh_file.h"
#include "common/io/read_formats.h"
#include "common/repair/repair.h"

namespace kerf::core::io {

namespace {

/// `read(loaded)` gives the soup, and notes in `loaded` what comes with it.
template <class Read>
LoadedMesh load(const std::filesystem::path& path, Read read)
{
    LoadedMesh loaded;
    TriangleSoup soup = read(loaded);
    try {
        Repaired repaired = repair(std::move(soup));
        if (!repaired.error.empty()) fail(path, repaired.error);
        loaded.mesh = std::move(repaired.mesh);
        loaded.facts = repaired.facts;
        loaded.repairs = repaired.repairs;
        return loaded;
    } catch (const std::bad_alloc&) {
        fail_without_memory(path, "prepare it; divide it or free some");
    }
}

}  // namespace

LoadedMesh read_mesh(const std::filesystem::path& path)
{
    return load(path, [&](LoadedMesh& loaded) {
        const ReadRecord record(loaded.files);
        return read_soup(path, &loaded.notes);
    });
}

LoadedMesh read_mesh(std::string_view bytes, std::string_view format)
{
    return load("memory." + std::string(format),
                [&](LoadedMesh& loaded) { return read_soup(bytes, format, &loaded.notes); });
}

}  // namespace kerf::core::io
