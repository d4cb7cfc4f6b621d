// What is promised when memory runs out, tried at every single allocation: prepare() and cut() say `out_of_memory`,
// the object and all that shares its buffers are as they were, and the next cut works as if nothing had happened.
// (With the address sanitizer this shows as well that nothing leaks.)

#include <gtest/gtest.h>

#include "common/cut.h"
#include "support/allocations.h"
#include "support/backends.h"
#include "support/fixtures.h"
#include "support/referee.h"

namespace kerf {
namespace {

using test::FailingAllocation;
using test::Failure;
using test::NamedMesh;
using test::NamedPlane;

using Bytes = std::vector<std::uint32_t>;

Bytes bytes_of(const Cuttable& object)
{
    return referee::bytes_of(object.to_indexed_mesh());
}

std::vector<Bytes> bytes_of(const CutResult& result)
{
    std::vector<Bytes> all;
    for (const auto* side : {&result.positive, &result.negative})
        for (const auto& fragment : *side) all.push_back(bytes_of(*fragment));
    return all;
}

/// Convex, concave with holes, with coincidences in the plane, of several pieces; with seams and streams.
const std::vector<std::string>& shapes_to_try()
{
    static const std::vector<std::string> names{"cube", "uv_sphere",        "torus",        "pipe",
                                                "comb", "sphere_in_sphere", "menger_sponge"};
    return names;
}

class OutOfMemory : public testing::TestWithParam<test::NamedBackend>
{
protected:
    /// A dictionary asks for memory for each vertex, and here everything is done for each time that it asks.
    bool is_slow() const { return GetParam().name != "halfedge" && GetParam().name != "baseline_remap"; }
    static constexpr std::size_t kSlowTriangles = 100;

    std::unique_ptr<Backend> backend_ = GetParam().make();
};

INSTANTIATE_TEST_SUITE_P(All, OutOfMemory, testing::ValuesIn(test::backends()),
                         [](const auto& back_end) { return back_end.param.name; });

TEST_P(OutOfMemory, WhilePreparingIsAStatus)
{
    for (const std::string& name : shapes_to_try()) {
        SCOPED_TRACE(name);
        const IndexedMesh& mesh = test::closed_shape(name);
        const Bytes expected = bytes_of(*backend_->prepare(mesh).object);
        std::uint64_t failures = 0;
        for (bool happened = true; happened; ++failures) {
            IndexedMesh copy = mesh;
            PrepareResult result;
            {
                const FailingAllocation failing(failures);
                result = backend_->prepare(std::move(copy));
                happened = failing.happened();
            }
            if (result.status == Status::cut) {
                // Whoever asks without exceptions, as sorting does, can go on without.
                ASSERT_EQ(bytes_of(*result.object), expected) << "allocation " << failures;
            } else {
                ASSERT_TRUE(happened);
                ASSERT_EQ(result.status, Status::out_of_memory) << "allocation " << failures;
                ASSERT_EQ(result.object, nullptr);
            }
        }
        EXPECT_GT(failures, 1u);
    }
}

/// An object to cut, and one that shares its buffers or nothing.
struct Subject
{
    std::unique_ptr<Cuttable> object, witness;
};

struct Cut
{
    Plane plane;
    CutOptions options;
};

/// Cuts anew for each allocation, which fails, alone or with all that follow, until there is none left to fail. A cut
/// that fails leaves the subject as it was; then memory is there again, and each of `afterwards` in turn gives what it
/// gives on an untouched subject.
/// @return  how many cuts failed
template <class Make>
std::uint64_t cut_with_every_failure(Make make, const Cut& first, const std::vector<Cut>& afterwards)
{
    const Subject untouched = make();
    const Bytes before = bytes_of(*untouched.object);
    const Bytes beside = untouched.witness ? bytes_of(*untouched.witness) : Bytes{};
    const std::vector<Bytes> expected = bytes_of(cut(make().object, first.plane, first.options));
    std::vector<std::vector<Bytes>> expected_afterwards;
    for (const Cut& next : afterwards)
        expected_afterwards.push_back(bytes_of(cut(make().object, next.plane, next.options)));

    std::uint64_t failures = 0;
    for (const Failure failure : {Failure::once, Failure::for_good}) {
        bool happened = true;
        for (std::uint64_t number = 0; happened; ++number) {
            Subject subject = make();
            CutResult result;
            {
                const FailingAllocation failing(number, failure);
                result = cut(std::move(subject.object), first.plane, first.options);
                happened = failing.happened();
            }
            if (happened && result.status == Status::out_of_memory) {
                ++failures;
                EXPECT_TRUE(result.object && result.positive.empty() && result.negative.empty());
                EXPECT_EQ(bytes_of(*result.object), before);
                const std::size_t next = number % afterwards.size();
                const CutResult after = cut(std::move(result.object), afterwards[next].plane, afterwards[next].options);
                EXPECT_EQ(bytes_of(after), expected_afterwards[next]);
            } else {
                // Whoever asks without exceptions, as sorting does, can go on without.
                EXPECT_EQ(bytes_of(result), expected);
            }
            if (subject.witness) {
                EXPECT_EQ(bytes_of(*subject.witness), beside);
            }
            if (testing::Test::HasFailure()) {
                ADD_FAILURE() << "allocation " << number << (failure == Failure::once ? "" : " and all after it");
                return failures;
            }
        }
    }
    return failures;
}

Plane slanted(double x, double y, double z)
{
    return *Plane::through({0.02, 0.01, 0.01}, {x, y, z});
}

constexpr CutOptions in_pieces()
{
    CutOptions options;
    options.split_components = true;
    return options;
}

TEST_P(OutOfMemory, WhileCuttingChangesNothing)
{
    for (const std::string& name : shapes_to_try()) {
        const IndexedMesh& mesh = test::closed_shape(name);
        if (is_slow() && mesh.triangles.size() > kSlowTriangles) continue;
        const auto make = [&] { return Subject{backend_->prepare(mesh).object, nullptr}; };
        for (const NamedPlane& plane : test::planes_for(mesh, 1, 11)) {
            SCOPED_TRACE(name + ", " + plane.name);
            const Cut first{plane.plane, in_pieces()};
            if (cut(make().object, first.plane).status == Status::missed) continue;
            EXPECT_GT(cut_with_every_failure(make, first, {first, {slanted(1, 0, 0), in_pieces()}, {first.plane, {}}}),
                      10u);
            if (HasFailure()) return;
        }
    }
}

TEST_P(OutOfMemory, WhileCuttingAFragmentChangesNeitherItNorItsSibling)
{
    for (const std::string& name : shapes_to_try()) {
        SCOPED_TRACE(name);
        const IndexedMesh& mesh = test::closed_shape(name);
        if (is_slow() && mesh.triangles.size() > kSlowTriangles) continue;
        const auto make = [&] {
            CutResult halves = cut(backend_->prepare(mesh).object, slanted(1, 2, 3));
            return Subject{std::move(halves.positive.front()), std::move(halves.negative.front())};
        };
        const Cut first{slanted(3, -1, 2), {}};
        EXPECT_GT(cut_with_every_failure(make, first, {first, {slanted(0, 0, 1), in_pieces()}}), 10u);
        if (HasFailure()) return;
    }
}

TEST_P(OutOfMemory, WhileCompactingChangesNothing)
{
    const Plane plane = *Plane::through({0.01, 0.02, 0.03}, {1, 2, 3});
    CutResult halves = cut(backend_->prepare(test::closed_shape("torus")).object, plane);
    ASSERT_EQ(halves.status, Status::cut);
    Cuttable& fragment = *halves.positive.front();
    const Bytes before = bytes_of(fragment), beside = bytes_of(*halves.negative.front());
    for (std::uint64_t number = 0;; ++number) {
        const FailingAllocation failing(number);
        try {
            fragment.compact();
        } catch (const std::bad_alloc&) {
        }
        if (!failing.happened()) break;
        ASSERT_EQ(bytes_of(fragment), before) << "allocation " << number;
        ASSERT_EQ(bytes_of(*halves.negative.front()), beside) << "allocation " << number;
    }
    EXPECT_EQ(bytes_of(fragment), before);
}

}  // namespace
}  // namespace kerf
