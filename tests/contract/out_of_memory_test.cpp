// What is promised when memory runs out, tried at every single allocation, alone and with all that follow: repair()
// throws, prepare() and cut() say `out_of_memory`, the object and all that shares its buffers are as they were, and the
// next call works as if nothing had happened. (With the address sanitizer this shows as well that nothing leaks.)

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <deque>

#include "common/cutting/cut.h"
#include "common/repair/repair.h"
#include "common/shapes/shapes.h"
#include "support/allocations.h"
#include "support/backends.h"
#include "support/brief.h"
#include "support/fixtures.h"
#include "support/prisms.h"
#include "support/referee.h"

namespace kerf::core {
namespace {

using test::FailingAllocation;
using test::Failure;
using test::NamedPlane;

using Bytes = std::vector<std::uint32_t>;

Bytes bytes_of(const Cuttable& object)
{
    Bytes bytes = referee::bytes_of(object.to_indexed_mesh());
    for (const SectionLoop& loop : object.section_loops()) {
        bytes.push_back(static_cast<std::uint32_t>(loop.points.size()) * 2 + loop.closed);
        for (const glm::vec3& p : loop.points)
            for (int axis = 0; axis < 3; ++axis) bytes.push_back(std::bit_cast<std::uint32_t>(p[axis]));
    }
    return bytes;
}

/// What lies in the buffers that an object shares with others, and what of it is the object's.
Bytes bytes_of_buffers(const Cuttable& object)
{
    Bytes bytes;
    const DrawView view = object.draw_view();
    for (const Material& material : view.materials)
        bytes.insert(bytes.end(), material.name.begin(), material.name.end());
    bytes.insert(bytes.end(),
                 {static_cast<std::uint32_t>(view.materials.size()), static_cast<std::uint32_t>(view.vertices.size()),
                  static_cast<std::uint32_t>(view.indices.size())});
    bytes.insert(bytes.end(), view.indices.begin(), view.indices.end());
    for (const DrawRange& range : view.ranges)
        bytes.insert(bytes.end(),
                     {range.first_index, range.index_count, range.material, static_cast<std::uint32_t>(range.kind)});
    return bytes;
}

/// All that a cut promises to be the same on every run.
std::vector<Bytes> bytes_of(const CutResult& result)
{
    const auto area = std::bit_cast<std::uint64_t>(result.section_area);
    std::vector<Bytes> all{{static_cast<std::uint32_t>(result.status), static_cast<std::uint32_t>(area),
                            static_cast<std::uint32_t>(area >> 32)}};
    if (result.object) all.push_back(bytes_of(*result.object));
    for (const auto* side : {&result.positive, &result.negative}) {
        all.emplace_back();
        for (const auto& fragment : *side) all.push_back(bytes_of(*fragment));
    }
    return all;
}

/// The allocation that fails in an attempt.
struct Fault
{
    std::uint64_t number;
    Failure failure;
};

/// Attempts something for each of its allocations, which fails, alone or with all that follow, until there is none left
/// to fail. Stops where a test has failed. A brief build tries every seventh.
///
/// @param attempt  takes a Fault; returns whether it came to that allocation
/// @return         how many failures that stands for
template <class Attempt>
std::uint64_t with_every_fault(Attempt attempt)
{
    std::uint64_t faults = 0;
    constexpr std::uint64_t kStep = test::kBrief ? 7 : 1;
    for (const Failure failure : {Failure::once, Failure::for_good})
        for (std::uint64_t number = failure == Failure::once ? 0 : kStep - 1; attempt(Fault{number, failure});
             number += kStep) {
            faults += kStep;
            if (testing::Test::HasFailure()) {
                ADD_FAILURE() << "allocation " << number << (failure == Failure::once ? "" : " and all after it");
                return faults;
            }
        }
    return faults;
}

/// Convex, concave with holes, with coincidences in the plane, of several pieces; with seams and streams.
const std::vector<std::string>& shapes_to_try()
{
    static const std::vector<std::string> names{"cube", "uv_sphere",        "torus",        "pipe",
                                                "comb", "sphere_in_sphere", "menger_sponge"};
    return names;
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

/// A shape with everything that repair() repairs: degenerate, duplicate and flipped triangles, a fin on an edge, two
/// fans in a point, a Moebius strip.
TriangleSoup faulty_soup()
{
    TriangleSoup soup = *shapes::make("sphere_in_sphere", 60, 1);
    std::swap(soup.triangles[3][0], soup.triangles[3][1]);
    const Triangle first = soup.triangles[0];
    soup.triangles.push_back(first);
    soup.triangles.push_back({first[0], first[0], first[1]});
    const auto add_point = [&](const glm::vec3& position) {
        soup.vertices.push_back({position, {0, 0, 1}, {0, 0}});
        for (VertexStream& stream : soup.streams) stream.values.insert(stream.values.end(), stream.width, 0.0f);
        return static_cast<std::uint32_t>(soup.vertices.size() - 1);
    };
    const Triangle far = soup.triangles[7];  // none of its edges is one of the triangle that is there twice
    soup.triangles.push_back({far[0], far[1], add_point({5, 5, 5})});
    soup.triangles.push_back({first[2], add_point({5, 6, 5}), add_point({6, 5, 5})});
    std::array<std::uint32_t, 6> strip;
    for (std::uint32_t i = 0; i < 3; ++i) {
        strip[i] = add_point({7, float(i), 0});
        strip[i + 3] = add_point({8, float(i), float(i)});
    }
    const std::array<std::uint32_t, 8> around{strip[0], strip[3], strip[1], strip[4],
                                              strip[2], strip[5], strip[3], strip[0]};
    for (std::size_t i = 0; i + 2 < around.size(); ++i)
        soup.triangles.push_back({around[i], around[i + 1 + i % 2], around[i + 2 - i % 2]});
    soup.triangle_materials.resize(soup.triangle_materials.empty() ? 0 : soup.triangles.size(), 0);
    return soup;
}

TEST(OutOfMemory, WhileRepairingIsAnExceptionAndNothingElse)
{
    const TriangleSoup soup = faulty_soup();
    const Repaired expected = repair(soup);
    ASSERT_EQ(expected.error, "");
    const Repairs& repairs = expected.repairs;
    ASSERT_TRUE(repairs.degenerate_triangles && repairs.duplicate_triangles && repairs.nonmanifold_edges &&
                repairs.nonmanifold_points && repairs.flipped_triangles && repairs.unorientable_edges)
        << repairs.describe();
    const Bytes bytes = referee::bytes_of(expected.mesh);
    const std::uint64_t faults = with_every_fault([&](const Fault& fault) {
        TriangleSoup copy = soup;
        bool happened = false;
        try {
            Repaired result;
            {
                const FailingAllocation failing(fault.number, fault.failure);
                try {
                    result = repair(std::move(copy));
                } catch (...) {
                    happened = failing.happened();
                    throw;
                }
                happened = failing.happened();
            }
            // Whoever asks without exceptions, as sorting does, can go on without.
            EXPECT_EQ(referee::bytes_of(result.mesh), bytes);
        } catch (const std::bad_alloc&) {
            EXPECT_TRUE(happened);
        }
        EXPECT_EQ(referee::bytes_of(*repair(soup).mesh), bytes);
        return happened;
    });
    EXPECT_GT(faults, 50u);
}

class OutOfMemoryOf : public testing::TestWithParam<test::NamedBackend>
{
protected:
    /// A dictionary asks for memory for each vertex, and here everything is done for each time that it asks.
    bool is_slow() const { return GetParam().name != "halfedge" && GetParam().name != "baseline_remap"; }
    static constexpr std::size_t kSlowTriangles = 100;

    std::unique_ptr<Backend> backend_ = GetParam().make();
};

INSTANTIATE_TEST_SUITE_P(All, OutOfMemoryOf, testing::ValuesIn(test::backends()),
                         [](const auto& back_end) { return back_end.param.name; });

TEST_P(OutOfMemoryOf, WhilePreparingIsAStatus)
{
    const auto cut_up = [](std::unique_ptr<Cuttable> object) {
        return bytes_of(cut(std::move(object), slanted(1, 2, 3), in_pieces()));
    };
    for (const std::string& name : shapes_to_try()) {
        SCOPED_TRACE(name);
        const IndexedMesh& mesh = test::closed_shape(name);
        const Bytes whole = bytes_of(*backend_->prepare(mesh).object);
        const std::vector<Bytes> parts = cut_up(backend_->prepare(mesh).object);
        const std::uint64_t faults = with_every_fault([&](const Fault& fault) {
            IndexedMesh copy = mesh;
            PrepareResult result;
            bool happened = false;
            {
                const FailingAllocation failing(fault.number, fault.failure);
                result = backend_->prepare(std::move(copy));
                happened = failing.happened();
            }
            if (result.status == Status::done) {
                // Whoever asks without exceptions, as sorting does, can go on without.
                EXPECT_EQ(bytes_of(*result.object), whole);
                if (happened) {
                    EXPECT_EQ(cut_up(std::move(result.object)), parts);
                }
            } else {
                EXPECT_TRUE(happened);
                EXPECT_EQ(result.status, Status::out_of_memory);
                EXPECT_EQ(result.object, nullptr);
                // Where there is no memory for a sentence either, there are three words.
                EXPECT_TRUE(result.reason == "out of memory" || result.reason.ends_with("; divide it or free some"))
                    << result.reason;
                EXPECT_EQ(bytes_of(*backend_->prepare(mesh).object), whole);
            }
            return happened;
        });
        EXPECT_GT(faults, 1u);
        if (HasFailure()) return;
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

/// Cuts anew for every fault. A cut that fails leaves the subject as it was; then memory is there again, and each of
/// `afterwards` in turn gives what it gives on an untouched subject.
///
/// @return  how many allocations failed
template <class Make>
std::uint64_t cut_with_every_fault(Make make, const Cut& first, const std::vector<Cut>& afterwards)
{
    const Subject untouched = make();
    const Bytes before = bytes_of(*untouched.object);
    const Bytes buffers_before = bytes_of_buffers(*untouched.object);
    const Bytes beside = untouched.witness ? bytes_of(*untouched.witness) : Bytes{};
    const std::vector<Bytes> expected = bytes_of(cut(make().object, first.plane, first.options));
    std::vector<std::vector<Bytes>> expected_afterwards;
    for (const Cut& next : afterwards)
        expected_afterwards.push_back(bytes_of(cut(make().object, next.plane, next.options)));

    return with_every_fault([&](const Fault& fault) {
        Subject subject = make();
        CutResult result;
        bool happened = false;
        {
            const FailingAllocation failing(fault.number, fault.failure);
            result = cut(std::move(subject.object), first.plane, first.options);
            happened = failing.happened();
        }
        if (happened && result.status == Status::out_of_memory) {
            EXPECT_TRUE(result.object && result.positive.empty() && result.negative.empty());
            EXPECT_EQ(bytes_of(*result.object), before);
            EXPECT_EQ(bytes_of_buffers(*result.object), buffers_before);
            const std::size_t next = fault.number % afterwards.size();
            const CutResult after = cut(std::move(result.object), afterwards[next].plane, afterwards[next].options);
            EXPECT_EQ(bytes_of(after), expected_afterwards[next]);
        } else {
            // Whoever asks without exceptions, as sorting does, can go on without.
            EXPECT_EQ(bytes_of(result), expected);
        }
        if (subject.witness) {
            EXPECT_EQ(bytes_of(*subject.witness), beside);
        }
        return happened;
    });
}

TEST_P(OutOfMemoryOf, WhileCuttingChangesNothing)
{
    for (const std::string& name : shapes_to_try()) {
        const IndexedMesh& mesh = test::closed_shape(name);
        if (is_slow() && mesh.triangles.size() > kSlowTriangles) continue;
        const auto whole = backend_->prepare(mesh).object;
        const auto make = [&] { return Subject{whole->clone(), nullptr}; };
        for (const NamedPlane& plane : test::planes_for(mesh, 1, 11)) {
            SCOPED_TRACE(name + ", " + plane.name);
            const Cut first{plane.plane, in_pieces()};
            if (cut(make().object, first.plane).status == Status::missed) continue;
            EXPECT_GT(cut_with_every_fault(make, first, {first, {slanted(1, 0, 0), in_pieces()}, {first.plane, {}}}),
                      10u);
            if (HasFailure()) return;
        }
    }
}

TEST_P(OutOfMemoryOf, WhileCapsGetPointsWhereASectionCrossesItself)
{
    const IndexedMesh mesh = test::prism_over(test::star(7, 3));
    const auto whole = backend_->prepare(mesh).object;
    const auto make = [&] { return Subject{whole->clone(), nullptr}; };
    for (const CutOptions& options : {CutOptions{}, in_pieces()}) {
        const Cut first{*Plane::through({0, 0.01, 0}, {0.01, 1, 0.013}), options};
        EXPECT_GT(cut_with_every_fault(make, first, {first, {slanted(1, 0, 0), in_pieces()}}), 10u);
        if (HasFailure()) return;
    }
}

TEST_P(OutOfMemoryOf, WhileCuttingAFragmentChangesNeitherItNorItsSibling)
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
        EXPECT_GT(cut_with_every_fault(make, first, {first, {slanted(0, 0, 1), in_pieces()}}), 10u);
        if (HasFailure()) return;
    }
}

/// The cut of an object that so many came before.
Cut cut_number(std::uint64_t number, const Cuttable& object)
{
    return {*Plane::through(object.bounds().centre(), test::Random(number).direction()), in_pieces()};
}

/// The fragments of a torus after so many cuts, all in one back end's buffers: the next to be cut, and another.
Subject after_cuts(const Backend& backend, std::uint64_t count)
{
    std::deque<std::unique_ptr<Cuttable>> pieces;
    pieces.push_back(backend.prepare(test::closed_shape("torus")).object);
    for (std::uint64_t i = 0; i < count; ++i) {
        const Cut next = cut_number(i, *pieces.front());
        CutResult result = cut(std::move(pieces.front()), next.plane, next.options);
        pieces.pop_front();
        if (result.object) pieces.push_back(std::move(result.object));
        for (auto* side : {&result.positive, &result.negative})
            std::move(side->begin(), side->end(), std::back_inserter(pieces));
    }
    return {std::move(pieces.front()), std::move(pieces.back())};
}

TEST(OutOfMemory, WhileSharedBuffersGrowChangesNothing)
{
    const auto& all = test::backends();
    const auto named = std::find_if(all.begin(), all.end(), [](const auto& b) { return b.name == "halfedge"; });
    if (named == all.end()) GTEST_SKIP() << "the half-edge back end is not built";
    const auto backend = named->make();
    // The first cut that needs more than what was reserved and as much again, which was asked for with it.
    std::uint64_t count = 2;
    for (;; ++count) {
        ASSERT_LT(count, 300u) << "no buffer was used up";
        Subject subject = after_cuts(*backend, count);
        const Cut next = cut_number(count, *subject.object);
        const void* const before = subject.object->draw_view().indices.data();
        const CutResult result = cut(std::move(subject.object), next.plane, next.options);
        if (result.status == Status::done && result.positive.front()->draw_view().indices.data() != before) break;
    }
    const auto make = [&] { return after_cuts(*backend, count); };
    const Cut next = cut_number(count, *make().object);
    EXPECT_GT(cut_with_every_fault(make, next, {next, {next.plane.flipped(), {}}}), 10u);
}

TEST_P(OutOfMemoryOf, WhileCompactingOrDetachingChangesNothing)
{
    const Cut next{slanted(3, -1, 2), in_pieces()};
    const auto move = [](Cuttable& object, bool detaches) {
        if (detaches) return object.detach();
        try {
            object.compact();
            return Status::done;
        } catch (const std::bad_alloc&) {
            return Status::out_of_memory;
        }
    };
    for (const std::string& name : shapes_to_try()) {
        SCOPED_TRACE(name);
        const auto make = [&] {
            CutResult halves = cut(backend_->prepare(test::closed_shape(name)).object, slanted(1, 2, 3));
            return Subject{std::move(halves.positive.front()), std::move(halves.negative.front())};
        };
        const Subject untouched = make();
        const Bytes before = bytes_of(*untouched.object), beside = bytes_of(*untouched.witness);
        const std::vector<Bytes> parts = bytes_of(cut(make().object, next.plane, next.options));
        for (const bool detaches : {false, true}) {
            const std::uint64_t faults = with_every_fault([&](const Fault& fault) {
                Subject subject = make();
                const bool are_relatives = subject.object->shares_buffers_with(*subject.witness);
                bool happened = false;
                Status status;
                {
                    const FailingAllocation failing(fault.number, fault.failure);
                    status = move(*subject.object, detaches);
                    happened = failing.happened();
                }
                EXPECT_TRUE(status == Status::done || (happened && status == Status::out_of_memory));
                EXPECT_EQ(subject.object->shares_buffers_with(*subject.witness),
                          are_relatives && status == Status::out_of_memory);
                EXPECT_EQ(bytes_of(*subject.object), before);
                EXPECT_EQ(bytes_of(*subject.witness), beside);
                EXPECT_EQ(bytes_of(cut(std::move(subject.object), next.plane, next.options)), parts);
                return happened;
            });
            if (GetParam().name == "halfedge") {
                EXPECT_GT(faults, 10u);
            }
            if (HasFailure()) return;
        }
    }
}

}  // namespace
}  // namespace kerf::core
