// Code for a processor's wider instructions gives the same bytes as that for any other: whole chains of cuts with all that
// is asked of their pieces, with the wider instructions and without.

#include <gtest/gtest.h>

#include <cstring>
#include <vector>

#include "common/shapes/shapes.h"
#include "common/support/processor.h"
#include "support/backends.h"
#include "support/fixtures.h"

namespace kerf::core {
namespace {

class Processors : public ::testing::TestWithParam<test::NamedBackend>
{
};

class Record
{
public:
    template <class T>
    void add(const T& value)
    {
        static_assert(std::is_trivially_copyable_v<T>);
        const auto* const first = reinterpret_cast<const unsigned char*>(&value);
        bytes_.insert(bytes_.end(), first, first + sizeof value);
    }
    bool operator==(const Record&) const = default;
    std::size_t size() const { return bytes_.size(); }

private:
    std::vector<unsigned char> bytes_;
};

void add_object(const Cuttable& object, Record& bytes)
{
    const MassProperties mass = object.mass_properties();
    bytes.add(mass.volume);
    bytes.add(mass.centre);
    bytes.add(mass.inertia);
    for (const glm::vec3& p : object.support_points()) bytes.add(p);
    bytes.add(object.bounds().lo);
    bytes.add(object.bounds().hi);
    const IndexedMesh mesh = object.to_indexed_mesh();
    for (const Vertex& v : mesh.vertices) bytes.add(v);
    for (const Triangle& t : mesh.triangles) bytes.add(t);
}

/// Three cuts, each of the first positive piece of the one before.
Record chain(const Backend& backend, const IndexedMesh& mesh, std::uint64_t seed)
{
    Record bytes;
    std::unique_ptr<Cuttable> object = backend.prepare(mesh).object;
    for (const auto& plane : test::planes_for(mesh, 1, seed)) {
        CutResult result = cut(object->clone(), plane.plane);
        bytes.add(result.status);
        for (const auto* side : {&result.positive, &result.negative})
            for (const auto& piece : *side) add_object(*piece, bytes);
        if (!result.positive.empty()) object = std::move(result.positive.front());
    }
    return bytes;
}

}  // namespace

TEST_P(Processors, GiveTheSameBytes)
{
    if (!has_avx2()) GTEST_SKIP() << "this processor has no AVX2";
    const std::unique_ptr<Backend> backend = GetParam().make();
    const auto expect_equal = [&](const IndexedMesh& mesh) {
        const Record wide = chain(*backend, mesh, 7);
        const WithoutAvx2 narrow;
        EXPECT_GT(wide.size(), 1000u);
        EXPECT_TRUE(wide == chain(*backend, mesh, 7));
    };
    for (const auto& [name, mesh] : test::closed_shapes()) {
        SCOPED_TRACE(name);
        expect_equal(mesh);
    }
    // More triangles than are summed anew, so that the tree's sums are asked for.
    expect_equal(test::repaired(shapes::asteroid(20'000, 3)));
}

INSTANTIATE_TEST_SUITE_P(All, Processors, ::testing::ValuesIn(test::backends()),
                         [](const auto& each) { return each.param.name; });

}  // namespace kerf::core
