// The promise that results keep their bytes: hashes of surfaces, caps and written files, and of what the public interface
// gives of pieces that are cut by a blade with a width and taken apart, or broken, recorded for bits_version().
// They are the same for every compiler and optimisation, so nothing here is made by a function of the system: the
// meshes are files, the planes exact numbers.
//
// A change that is meant to change bytes raises bits_version() and records anew:
//   KERF_RECORD_BITS=tests/contract/recorded_bits.txt build/release/tests/contract/bits_test
// and the same by bits_without_cgal_test, which is this file without CGAL's ways to close a section. Each replaces its own
// hashes and leaves the rest.

#include <gtest/gtest.h>
#include <kerf/io.h>
#include <kerf/kerf.h>

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <span>
#include <sstream>
#include <string>
#include <vector>

#include "common/caps/constrained_triangulator.h"
#include "common/cutting/bits_version.h"
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
    /// The numbers of an array, as they lie in memory.
    template <class T>
    void add(std::span<const T> values)
    {
        for (const std::byte byte : std::as_bytes(values)) add_byte(static_cast<unsigned char>(byte));
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

// Without CGAL, caps of sections with holes are others. Those of the baseline are not, since it closes them by its fan.
#ifdef KERF_HAS_CGAL
constexpr const char* kKindOfCaps = "";
#else
constexpr const char* kKindOfCaps = " without CGAL";
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

/// Hashes by what they are of: "surface MODEL", "caps MODEL BACK_END", "MODEL.FORMAT BACK_END", "parts MODEL BACK_END",
/// "broken MODEL BACK_END"; all but the first end in kKindOfCaps.
using Hashes = std::map<std::string, std::string>;

/// All arrays of a piece, as the public interface gives them.
void add(const kerf::Object& piece, Hash& hash)
{
    const kerf::Mesh mesh = *piece.mesh();
    const kerf::MeshArrays arrays = mesh.arrays();
    hash.add(arrays.positions);
    hash.add(arrays.normals);
    hash.add(arrays.uvs);
    hash.add(arrays.points);
    hash.add(arrays.indices);
    hash.add(arrays.sources);
    hash.add(arrays.kinds);
    hash.add(arrays.triangle_materials);
    hash.add(arrays.solids);
}

/// A model's pieces, cut and taken apart.
std::string hash_of_parts(const kerf::Object& object)
{
    kerf::CutOptions options;
    options.components = true;
    options.gap = 0.0625;
    Hash hash;
    for (const Plane& plane : planes()) {
        const glm::dvec3 n = plane.normal;
        kerf::Cut cut = kerf::cut_copy(object, *kerf::Plane::from_coefficients(n.x, n.y, n.z, -plane.offset), options);
        hash.add(std::string(kerf::outcome_name(cut.status)));
        for (const kerf::Side side : {kerf::Side::positive, kerf::Side::negative})
            for (std::size_t i = 0; const kerf::Object* const piece = cut.piece(side, i); ++i) add(*piece, hash);
    }
    return hash.text();
}

/// A model's pieces, broken in three ways, and what held them together.
std::string hash_of_broken(const kerf::Object& object)
{
    Hash hash;
    for (const auto pattern :
         {kerf::FracturePattern::impact, kerf::FracturePattern::grid, kerf::FracturePattern::splinters}) {
        kerf::FractureOptions options;
        options.pattern = pattern;
        options.cells = 8;
        options.seed = 1;
        kerf::Fracture fracture = kerf::fracture(object, options);
        hash.add(std::string(kerf::outcome_name(fracture.status())));
        for (std::size_t i = 0; const kerf::Object* const piece = fracture.piece(i); ++i) {
            hash.add(fracture.cells(i));
            add(*piece, hash);
        }
        for (const kerf::FractureBond& bond : fracture.bonds()) {
            hash.add(bond.first);
            hash.add(bond.second);
            const double area_and_places[]{bond.area,     bond.centre.x, bond.centre.y, bond.centre.z,
                                           bond.normal.x, bond.normal.y, bond.normal.z};
            hash.add(std::span<const double>(area_and_places));
        }
    }
    return hash.text();
}

class BitsTest : public test::FolderTest
{
protected:
#ifndef KERF_HAS_CGAL
    BitsTest()
    {
        use_constrained_ways(nullptr);
    }
#endif

    void hash_model(const std::string& model, Hashes& hashes) const
    {
        const fs::path file = fs::path(KERF_DATA_DIR) / "models" / (model + ".obj");
        const io::LoadedMesh loaded = io::read_mesh(file);
        for (const test::NamedBackend& named : test::backends()) {
            // The other look-ups give the bytes of `hash`.
            if (named.name != "halfedge" && named.name != "linear" && named.name != "baseline_hash") continue;
            const auto object = named.make()->prepare(loaded.mesh).object;
            Hash surface, caps;
            std::map<std::string, Hash> written;
            for (const Plane& plane : planes()) {
                const CutResult result = cut(object->clone(), plane);
                for (const auto* side : {&result.positive, &result.negative})
                    for (const auto& fragment : *side)
                        add_fragment(fragment->to_indexed_mesh(), surface, caps, written);
            }
            const std::string own = hashes.try_emplace("surface " + model, surface.text()).first->second;
            EXPECT_EQ(surface.text(), own) << model << ", " << named.name << ": all back ends have one surface";
            const std::string by = " " + named.name + (named.name == "baseline_hash" ? "" : kKindOfCaps);
            hashes["caps " + model + by] = caps.text();
            for (const auto& [format, hash] : written) hashes[model + "." + format + by] = hash.text();
            if (named.name == "baseline_hash") continue;
            kerf::PrepareOptions prepared;
            prepared.back_end_name = named.name.c_str();
            const kerf::Object whole = *kerf::prepare(*kerf::read_mesh(file.string().c_str()), prepared);
            hashes["parts " + model + by] = hash_of_parts(whole);
            if (whole.mass_properties().is_of_solid) hashes["broken " + model + by] = hash_of_broken(whole);
        }
    }

private:
    void add_fragment(const IndexedMesh& mesh, Hash& surface, Hash& caps, std::map<std::string, Hash>& written) const
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

/// What is recorded, and for which version; no version if nothing is.
Hashes read_recorded(const std::string& file, std::uint32_t& version)
{
    std::ifstream in(file);
    std::string word, what;
    in >> word >> version;
    Hashes recorded;
    while (in >> word && std::getline(in >> std::ws, what)) recorded[what] = word;
    return recorded;
}

TEST_F(BitsTest, AreThoseThatAreRecordedForTheirVersion)
{
    Hashes found;
    for (const fs::directory_entry& entry : fs::directory_iterator(fs::path(KERF_DATA_DIR) / "models"))
        if (entry.path().extension() == ".obj") hash_model(entry.path().stem().string(), found);

    ASSERT_FALSE(found.empty());

    std::uint32_t version = 0;
    if (const char* const record = std::getenv("KERF_RECORD_BITS")) {
        Hashes all = found;
        all.merge(read_recorded(record, version));
        std::ofstream out(record);
        out << "version " << bits_version() << "\n";
        for (const auto& [what, hash] : all) out << hash << " " << what << "\n";
        ASSERT_TRUE(out.good());
        GTEST_SKIP() << "recorded in " << record;
    }

    Hashes recorded = read_recorded(KERF_RECORDED_BITS, version);
    EXPECT_EQ(version, bits_version()) << "record anew: see the top of this test";
    for (const auto& [name, hash] : found) EXPECT_EQ(hash, recorded[name]) << name;
}

}  // namespace
}  // namespace kerf::core
