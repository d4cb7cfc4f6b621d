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
    static const std::vector<std::string> names{"cube", "uv_sphere", "torus", "pipe", "comb", "sphere_in_sphere"};
    return names;
}

class OutOfMemory : public testing::TestWithParam<test::NamedBackend>
{
protected:
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

/// Cuts again and again, each time with the next allocation failing, until none is left to fail. Every cut that fails
/// leaves the subject as it was, and every other one gives `expected`.
/// @return  how many cuts failed
template <class Make>
std::uint64_t cut_with_every_failure(Make make, const Plane& plane, const CutOptions& options,
                                     const std::vector<Bytes>& expected)
{
    Subject subject = make();
    const Bytes before = bytes_of(*subject.object);
    const Bytes beside = subject.witness ? bytes_of(*subject.witness) : Bytes{};
    std::uint64_t failures = 0;
    bool happened = true;
    for (std::uint64_t number = 0; happened; ++number) {
        CutResult result;
        {
            const FailingAllocation failing(number);
            result = cut(std::move(subject.object), plane, options);
            happened = failing.happened();
        }
        if (happened && result.status == Status::out_of_memory) {
            ++failures;
            EXPECT_TRUE(result.object && result.positive.empty() && result.negative.empty());
            subject.object = std::move(result.object);
        } else {
            // Whoever asks without exceptions, as sorting does, can go on without.
            EXPECT_EQ(result.status, Status::cut);
            EXPECT_EQ(bytes_of(result), expected);
            result = {};
            subject = make();
        }
        EXPECT_EQ(bytes_of(*subject.object), before);
        if (subject.witness) {
            EXPECT_EQ(bytes_of(*subject.witness), beside);
        }
        if (testing::Test::HasFailure()) {
            ADD_FAILURE() << "allocation " << number;
            break;
        }
    }
    return failures;
}

TEST_P(OutOfMemory, WhileCuttingChangesNothing)
{
    for (const std::string& name : shapes_to_try()) {
        const IndexedMesh& mesh = test::closed_shape(name);
        for (const NamedPlane& plane : test::planes_for(mesh, 1, 11)) {
            SCOPED_TRACE(name + ", " + plane.name);
            CutOptions options;
            options.split_components = true;
            const CutResult expected = cut(backend_->prepare(mesh).object, plane.plane, options);
            if (expected.status == Status::missed) continue;
            const auto make = [&] { return Subject{backend_->prepare(mesh).object, nullptr}; };
            EXPECT_GT(cut_with_every_failure(make, plane.plane, options, bytes_of(expected)), 5u);
            if (HasFailure()) return;
        }
    }
}

TEST_P(OutOfMemory, WhileCuttingAFragmentChangesNeitherItNorItsSibling)
{
    const Plane first = *Plane::through({0.01, 0.02, 0.03}, {1, 2, 3});
    const Plane second = *Plane::through({0.02, 0.01, 0.01}, {3, -1, 2});
    for (const std::string& name : shapes_to_try()) {
        SCOPED_TRACE(name);
        const auto make = [&] {
            CutResult halves = cut(backend_->prepare(test::closed_shape(name)).object, first);
            return Subject{std::move(halves.positive.front()), std::move(halves.negative.front())};
        };
        const CutResult expected = cut(make().object, second);
        ASSERT_EQ(expected.status, Status::cut);
        EXPECT_GT(cut_with_every_failure(make, second, {}, bytes_of(expected)), 5u);
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
