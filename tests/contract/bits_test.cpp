// The promise that results keep their bytes: hashes of surfaces, caps and written files, recorded for bits_version().
// They are the same for every compiler and optimisation, so nothing here is made by a function of the system: the
// meshes are files, the planes exact numbers.
//
// A change that is meant to change bytes raises bits_version() and records anew:
//   KERF_RECORD_BITS=tests/contract/recorded_bits.txt build/release/tests/contract/bits_test

#include "common/cutting/bits_version.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include "common/io/mesh_file.h"
#include "support/backends.h"
#include "support/referee.h"
#include "support/temporary_folder.h"

namespace kerf::core {
namespace {

namespace fs = std::filesystem;

/// FNV-1a (Fowler, Noll and Vo), 64 bits.
class Hash
{
public:
    void add_byte(unsigned char byte)
    {
        value_ ^= byte;
        value_ *= 0x100000001b3ull;
    }
    void add(std::uint32_t word)
    {
        for (int shift = 0; shift < 32; shift += 8) add_byte(static_cast<unsigned char>(word >> shift));
    }
    void add(const std::string& text)
    {
        for (const char c : text) add_byte(static_cast<unsigned char>(c));
        add_byte(0);
    }
    std::string text() const
    {
        std::ostringstream out;
        out << std::hex << value_;
        return out.str();
    }

private:
    std::uint64_t value_ = 0xcbf29ce484222325ull;
};

#ifdef KERF_HAS_CGAL
constexpr bool kHasCgal = true;
#else
constexpr bool kHasCgal = false;  // caps of sections with holes are others
#endif

const std::vector<Plane>& planes()
{
    // Through the middle in general position, along an axis through vertices of many models, and off centre.
    static const std::vector<Plane> all{
        {{0.6, 0.64, 0.48}, 0.0}, {{0.0, 1.0, 0.0}, 0.0}, {{-0.48, 0.6, 0.64}, 0.0625}, {{0.28, -0.96, 0.0}, -0.125}};
    return all;
}

/// The triangles of the caps, in no order: positions, each beginning with the smallest corner.
std::vector<std::vector<std::uint32_t>> caps_of(const IndexedMesh& mesh)
{
    std::vector<std::vector<std::uint32_t>> caps;
    for (const TriangleGroup& group : mesh.groups)
        for (std::uint32_t t = group.first; t < group.first + group.count; ++t) {
            if (group.kind != TriangleKind::cap) continue;
            std::array<std::array<std::uint32_t, 3>, 3> corners;
            for (std::size_t i = 0; i < 3; ++i)
                for (int axis = 0; axis < 3; ++axis)
                    corners[i][std::size_t(axis)] =
                        std::bit_cast<std::uint32_t>(mesh.vertices[mesh.triangles[t][i]].position[axis]);
            std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
            std::vector<std::uint32_t>& cap = caps.emplace_back();
            for (const auto& corner : corners) cap.insert(cap.end(), corner.begin(), corner.end());
        }
    std::sort(caps.begin(), caps.end());
    return caps;
}

/// Hashes by what they are of: "surface MODEL", "caps MODEL BACK_END", "MODEL.FORMAT BACK_END".
using Hashes = std::map<std::string, std::string>;

class BitsTest : public test::FolderTest
{
protected:
    void hash_model(const std::string& model, Hashes& hashes) const
    {
        const io::LoadedMesh loaded = io::read_mesh(fs::path(KERF_DATA_DIR) / "models" / (model + ".obj"));
        for (const test::NamedBackend& named : test::backends()) {
            // The other look-ups give the bytes of `hash`.
            if (named.name != "halfedge" && named.name != "linear" && named.name != "baseline_hash") continue;
            const auto object = named.make()->prepare(loaded.mesh).object;
            Hash surface, caps;
            std::map<std::string, Hash> written;
            for (const Plane& plane : planes()) {
                const CutResult result = cut(object->clone(), plane);
                for (const auto* side : {&result.positive, &result.negative})
                    for (const auto& fragment : *side) add(fragment->to_indexed_mesh(), surface, caps, written);
            }
            const std::string own = hashes.try_emplace("surface " + model, surface.text()).first->second;
            EXPECT_EQ(surface.text(), own) << model << ", " << named.name << ": all back ends have one surface";
            if (!kHasCgal && named.name != "baseline_hash") continue;
            hashes["caps " + model + " " + named.name] = caps.text();
            for (const auto& [format, hash] : written) hashes[model + "." + format + " " + named.name] = hash.text();
        }
    }

private:
    void add(const IndexedMesh& mesh, Hash& surface, Hash& caps, std::map<std::string, Hash>& written) const
    {
        for (const referee::SurfaceTriangle& triangle : referee::canonical_surface(mesh)) {
            surface.add(triangle.source);
            surface.add(triangle.material);
            for (const std::uint32_t word : triangle.bits) surface.add(word);
        }
        for (const auto& cap : caps_of(mesh))
            for (const std::uint32_t word : cap) caps.add(word);
        for (const std::string& format : io::writable_formats()) {
            const fs::path file = folder_ / ("piece." + format);
            io::write_mesh(file, mesh);
            written[format].add(text_of(file.filename().string()));
        }
    }
};

TEST_F(BitsTest, AreThoseThatAreRecordedForTheirVersion)
{
    Hashes found;
    for (const fs::directory_entry& entry : fs::directory_iterator(fs::path(KERF_DATA_DIR) / "models"))
        if (entry.path().extension() == ".obj") hash_model(entry.path().stem().string(), found);

    if (const char* const record = std::getenv("KERF_RECORD_BITS")) {
        std::ofstream out(record);
        out << "version " << bits_version() << "\n";
        for (const auto& [what, hash] : found) out << hash << " " << what << "\n";
        ASSERT_TRUE(out.good());
        GTEST_SKIP() << "recorded in " << record;
    }

    std::ifstream in(KERF_RECORDED_BITS);
    std::string word, what;
    std::uint32_t version = 0;
    in >> word >> version;
    ASSERT_EQ(word, "version") << KERF_RECORDED_BITS;
    EXPECT_EQ(version, bits_version()) << "record anew: see the top of this test";
    Hashes recorded;
    while (in >> word && std::getline(in >> std::ws, what)) recorded[what] = word;
    for (const auto& [name, hash] : found) EXPECT_EQ(hash, recorded[name]) << name;
    // Builds without the half-edge back end have fewer.
    EXPECT_LE(found.size(), recorded.size());
}

}  // namespace
}  // namespace kerf::core
