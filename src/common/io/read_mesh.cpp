#include <new>
#include <utility>

#include "common/io/mesh_file.h"
#include "common/io/read_formats.h"
#include "common/repair/repair.h"

namespace kerf::io {

LoadedMesh read_mesh(const std::filesystem::path& path)
{
    LoadedMesh loaded;
    TriangleSoup soup;
    {
        const ReadRecord record(loaded.files);
        soup = read_soup(path, &loaded.notes);
    }
    try {
        Repaired repaired = repair(std::move(soup));
        if (!repaired.error.empty()) fail(path, repaired.error);
        loaded.mesh = std::move(repaired.mesh);
        loaded.facts = repaired.facts;
        loaded.repairs = repaired.repairs;
        return loaded;
    } catch (const std::bad_alloc&) {
        fail(path, "there is not enough memory to prepare it; divide it or free some");
    }
}

}  // namespace kerf::io
