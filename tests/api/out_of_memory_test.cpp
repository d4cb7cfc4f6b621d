// What the public interface promises when memory runs out, tried at every single allocation of a call, alone and with all
// that follow: nothing is thrown, the status is `out_of_memory` with a sentence, what was given is as it was, and the
// next call works as if nothing had happened.

#include <gtest/gtest.h>
#include <kerf/drawing.h>
#include <kerf/io.h>
#include <kerf/kerf.h>
#include <kerf/proxy.h>
#include <kerf/shapes.h>

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "api/objects.h"
#include "support/allocations.h"
#include "support/brief.h"
#include "support/temporary_folder.h"

namespace kerf {
namespace {

using test::FailingAllocation;
using test::Failure;

/// Fails each allocation of `call` in turn, in brief builds each fifth. `call` gives its status; `check` looks at what was
/// given, after each.
void fail_each(
    const std::function<Status()>& call, const std::function<void(Status)>& check = [](Status) {})
{
    std::uint64_t failed = 0;
    constexpr std::uint64_t kStep = test::kBrief ? 5 : 1;
    for (const Failure failure : {Failure::once, Failure::for_good})
        for (std::uint64_t number = 0;; number += kStep) {
            ASSERT_LT(number, 20'000u) << "it never ends";
            Status status = Status::done;
            bool happened = false;
            {
                const FailingAllocation failing(number, failure);
                status = call();
                happened = failing.happened();
            }
            ASSERT_TRUE(ok(status) || status == Status::out_of_memory) << text(status) << ", allocation " << number;
            if (!ok(status)) {
                ASSERT_TRUE(happened) << "allocation " << number;
                ++failed;
            }
            check(status);
            if (testing::Test::HasFailure()) return;
            if (!happened) break;
        }
    EXPECT_GT(failed, 0u) << "it takes no memory";
}

template <class T>
Status said(const Result<T>& result)
{
    EXPECT_EQ(*result.reason() == '\0', bool(result));
    return result.status();
}

TEST(OutOfMemory, MakingAMeshSaysSo)
{
    const test::Arrays cube = test::two_cubes();
    const Material rock{"a name that is too long to lie in the string itself", {1, 1, 1, 1}};
    std::vector<float> heat(cube.positions.size(), 1.0f);
    const StreamInput stream{"a name that is too long to lie in the string itself", heat.data(), 1, 0};
    MeshInput input = cube.input();
    input.materials = {&rock, 1};
    input.streams = {&stream, 1};
    fail_each([&] {
        MeshReport report;
        return said(Mesh::make(input, &report));
    });
}

TEST(OutOfMemory, CopiesAndArraysOfAMeshSaySo)
{
    const test::Arrays cube = test::two_cubes();
    const Mesh mesh = test::mesh_of(cube);
    fail_each([&] { return said(mesh.clone()); });
    // Arrays are made once: of a new copy each time. All of them or none, and the next call tries again.
    std::uint64_t refused = 0;
    for (const Failure failure : {Failure::once, Failure::for_good})
        for (std::uint64_t number = 0;; ++number) {
            const Mesh copy = *mesh.clone();
            bool happened = false;
            {
                const FailingAllocation failing(number, failure);
                const MeshArrays arrays = copy.arrays();
                happened = failing.happened();
                refused += arrays.indices.empty() ? 1 : 0;
                ASSERT_EQ(arrays.positions.empty(), arrays.indices.empty());
            }
            ASSERT_EQ(copy.arrays().indices.size(), 3 * mesh.triangle_count());
            if (!happened) break;
        }
    EXPECT_GT(refused, 2u);
}

TEST(OutOfMemory, BreakingALargeObjectSaysSo)
{
    // So large that the half-edge back end hands subtrees over. Not every allocation: there are many.
    for (const std::string& back_end : test::back_end_names()) {
        const Object whole = test::object_of(test::shape("asteroid", 25'000), back_end);
        const std::string before = test::bytes_of(*whole.mesh());
        FractureOptions options;
        options.cells = 5;
        std::uint64_t refused = 0;
        for (const Failure failure : {Failure::once, Failure::for_good})
            for (std::uint64_t number = 0;; number += 1 + number / 6) {
                bool happened = false;
                Status status = Status::done;
                {
                    const FailingAllocation failing(number, failure);
                    status = kerf::fracture(whole, options).status();
                    happened = failing.happened();
                }
                ASSERT_TRUE(ok(status) || status == Status::out_of_memory) << text(status) << ", allocation " << number;
                refused += ok(status) ? 0 : 1;
                if (!happened) break;
            }
        EXPECT_GT(refused, 20u);
        EXPECT_EQ(test::bytes_of(*whole.mesh()), before) << "it stays as it is";
        EXPECT_EQ(kerf::fracture(whole, options).status(), Status::done);
    }
}

TEST(OutOfMemory, ShapesAndFilesSaySo)
{
    const Mesh torus = test::shape("torus", 60);
    fail_each([] { return said(make_shape("torus", 60)); });
    // (Not of GLB: the library that reads its JSON takes memory to destroy a document.)
    for (const char* format : {"obj", "ply", "stl", "off"}) {
        SCOPED_TRACE(format);
        const FileBytes file = *mesh_file_bytes(torus, format);
        fail_each([&] { return said(mesh_file_bytes(torus, format)); });
        fail_each([&] {
            FileReport report;
            return said(read_mesh(file.bytes(), format, &report));
        });
    }
}

TEST(OutOfMemory, WritingOverAFileGivesTheOldOneOrTheNewOne)
{
    const Mesh torus = test::shape("torus", 60);
    const std::string before = "what was there", after = [&] {
        const FileBytes file = *mesh_file_bytes(torus, "off");
        return std::string(reinterpret_cast<const char*>(file.bytes().data()), file.bytes().size());
    }();
    const test::TemporaryFolder folder;
    const std::string path = folder.file("torus.off").string();
    folder.write("torus.off", before);
    fail_each([&] { return write_mesh(torus, path.c_str()).status(); },
              [&](Status status) {
                  EXPECT_EQ(folder.names_in_folder(), std::vector<std::string>{"torus.off"});
                  EXPECT_EQ(folder.text_of("torus.off"), ok(status) ? after : before);
                  folder.write("torus.off", before);
              });
}

class ObjectOutOfMemory : public ::testing::TestWithParam<std::string>
{
protected:
    Object object() const { return test::object_of(mesh_, GetParam()); }
    static std::string bytes_of(const Object& object) { return test::bytes_of(*object.mesh()); }

    Mesh mesh_ = test::shape("l_step", 100);
};

TEST_P(ObjectOutOfMemory, PreparingSaysSo)
{
    const std::string before = test::bytes_of(mesh_);
    PrepareOptions options;
    options.back_end_name = GetParam().c_str();
    fail_each([&] { return said(prepare(mesh_, options)); }, [&](Status) { EXPECT_EQ(test::bytes_of(mesh_), before); });
}

TEST_P(ObjectOutOfMemory, WhatOnlyReadsSaysSo)
{
    const Object whole = object();
    const std::string before = bytes_of(whole);
    const auto check = [&](Status) { ASSERT_EQ(bytes_of(whole), before); };
    fail_each([&] { return said(whole.clone()); }, check);
    fail_each([&] { return said(whole.mesh()); }, check);
    fail_each([&] { return said(bounded_hull(whole)); }, check);
    fail_each([&] { return said(full_hull(whole)); }, check);
    fail_each(
        [&] {
            const Hull hull = *bounded_hull(whole);
            return hull.indices().empty() ? Status::out_of_memory : Status::done;
        },
        check);
    fail_each(
        [&] {
            DrawView view;
            const Status status = whole.draw(view);
            EXPECT_EQ(view.ranges.empty(), !ok(status));
            return status;
        },
        check);
    fail_each([&] { return cut_copy(whole, Plane::y(0.1).value()).status; }, check);
    SectionOptions filled;
    filled.fill = true;
    fail_each(
        [&] {
            const Section found = section(whole, Plane::y(0.1).value(), filled);
            EXPECT_EQ(found.path_count() == 0, !ok(found.status));
            EXPECT_EQ(*found.reason() == '\0', ok(found.status));
            return found.status;
        },
        check);
}

TEST_P(ObjectOutOfMemory, StacksAndDiceSaySo)
{
    const Object whole = object();
    const std::string before = bytes_of(whole);
    const std::vector<double> heights{-0.3, 0.1, 0.4};
    const auto check = [&](Status) { ASSERT_EQ(bytes_of(whole), before); };
    fail_each(
        [&] {
            const SectionStack stack = sections(whole, Normal(0, 1, 0), heights);
            EXPECT_EQ(stack.all().empty(), !ok(stack.status()));
            EXPECT_EQ(*stack.reason() == '\0', ok(stack.status()));
            return stack.status();
        },
        check);
    fail_each(
        [&] {
            Result<Object> copy = whole.clone();
            if (!copy) return copy.status();
            const DicePlanes planes[]{{Normal(0, 1, 0), heights}, {Normal(1, 0, 0), heights}};
            const Dice dice = kerf::dice(*std::move(copy), planes);
            EXPECT_EQ(dice.count() == 0, !ok(dice.status()));
            EXPECT_EQ(*dice.reason() == '\0', ok(dice.status()));
            return dice.status();
        },
        check);
    const Section square = section(whole, Plane::y(0.1).value());
    fail_each([&] { return said(drawing_bytes({&square, 1}, "svg")); });
}

TEST_P(ObjectOutOfMemory, ASectionThatWasRefusedIsFilledByTheNextCall)
{
    const Object whole = object();
    SectionOptions filled;
    filled.fill = true;
    const double area = section(whole, Plane::y(0.1).value(), filled).area;
    Section again = section(whole, Plane::x(0.3).value(), filled);
    fail_each([&] {
        again = {};
        return section(whole, Plane::y(0.1).value(), again, filled);
    });
    EXPECT_TRUE(ok(section(whole, Plane::y(0.1).value(), again, filled)));
    EXPECT_EQ(again.area, area);
}

TEST_P(ObjectOutOfMemory, ASectionThatIsFilledAgainTakesNoMemory)
{
    // Nested loops, triangles that close them, planes through vertices and edges: whatever it held once, it can hold
    // again. (Triangles of sections that touch or cross themselves take memory each time.)
    for (const char* name : {"menger_sponge", "nested_spheres", "torus", "l_step", "two_legs", "bowl", "asteroid"}) {
        SCOPED_TRACE(name);
        const Object whole = test::object_of(test::shape(name, 3000), GetParam());
        const Box box = whole.bounds();
        std::vector<std::pair<Plane, bool>> planes;  // and whether no edge lies in it
        for (const double share : {0.5, 0.33333, 0.21, 0.77}) {
            const Point through(box.lo.x + share * (box.hi.x - box.lo.x), box.lo.y + share * (box.hi.y - box.lo.y),
                                box.lo.z + share * (box.hi.z - box.lo.z));
            for (const Normal& normal : {Normal(1, 0, 0), Normal(0, 1, 0), Normal(0, 0, 1), Normal(1, 2, 3)})
                planes.emplace_back(*Plane::at(through, normal), normal.z == 3.0);
        }
        SectionOptions options;
        for (const bool fill : {false, true}) {
            if (fill && std::string_view(name) == "menger_sponge") continue;  // its sections touch themselves
            options.fill = fill;
            Section found;
            const auto find_all = [&] {
                for (const auto& [plane, is_askew] : planes)
                    if (is_askew || !fill) static_cast<void>(section(whole, plane, found, options));
            };
            find_all();
            const std::uint64_t before = test::allocations();
            find_all();
            EXPECT_EQ(test::allocations(), before) << (fill ? "with triangles" : "without triangles");
        }
    }
}

/// Pairs of triangles that do not meet, each with its common edge in the plane z = 0: chains of one edge, whose points are
/// all vertices.
Mesh roofs(std::uint32_t count)
{
    std::vector<Vec3f> positions;
    std::vector<std::uint32_t> indices;
    for (std::uint32_t i = 0; i < count; ++i) {
        const auto x = static_cast<float>(3 * i);
        const auto first = static_cast<std::uint32_t>(positions.size());
        positions.insert(positions.end(), {{x, 0.0f, 0.0f}, {x + 1, 0.0f, 0.0f}, {x, 0.1f, 1.0f}, {x, 0.2f, -1.0f}});
        for (const std::uint32_t corner : {0u, 1u, 2u, 1u, 0u, 3u}) indices.push_back(first + corner);
    }
    MeshInput input;
    input.positions = &positions[0].x;
    input.vertex_count = positions.size();
    input.indices = indices.data();
    input.triangle_count = indices.size() / 3;
    return *Mesh::make(input);
}

TEST_P(ObjectOutOfMemory, ASectionOfManyChainsThatIsFilledAgainTakesNoMemory)
{
    for (const std::uint32_t count : {3u, 100u, 10'000u}) {
        const Object whole = test::object_of(roofs(count), GetParam());
        Section found;
        EXPECT_EQ(section(whole, *Plane::z(0.0), found), Status::open_section);
        EXPECT_EQ(found.path_count(), count);
        const std::uint64_t before = test::allocations();
        EXPECT_EQ(section(whole, *Plane::z(0.0), found), Status::open_section);
        EXPECT_EQ(test::allocations(), before) << count;
    }
}

/// Calls `change` for a fresh object and each allocation that may fail: the object that is left must be what it was, if
/// one is left.
void fail_each_change(const std::function<Object()>& fresh, const std::function<Status(Object&)>& change)
{
    const std::string before = test::bytes_of(*fresh().mesh());
    for (const Failure failure : {Failure::once, Failure::for_good})
        for (std::uint64_t number = 0;; ++number) {
            ASSERT_LT(number, 20'000u) << "it never ends";
            Object object = fresh();
            Status status = Status::done;
            bool happened = false;
            {
                const FailingAllocation failing(number, failure);
                status = change(object);
                happened = failing.happened();
            }
            if (status == Status::out_of_memory) {
                ASSERT_TRUE(happened);
                if (object.is_empty()) continue;
                ASSERT_EQ(test::bytes_of(*object.mesh()), before) << "allocation " << number;
                ASSERT_TRUE(ok(change(object))) << "the next call works";
            } else {
                ASSERT_TRUE(ok(status)) << text(status) << ", allocation " << number;
            }
            if (!happened) break;
        }
}

TEST_P(ObjectOutOfMemory, ACutGivesTheObjectBackAsItWas)
{
    for (const bool components : {false, true}) {
        SCOPED_TRACE(components);
        fail_each_change([&] { return object(); },
                         [&](Object& object) {
                             CutOptions options;
                             options.components = components;
                             Cut result = cut(std::move(object), Plane::y(0.1).value(), options);
                             object = std::move(result.object);
                             EXPECT_EQ(object.is_empty(), ok(result.status));
                             EXPECT_EQ(result.one(Side::positive) != nullptr, ok(result.status));
                             return result.status;
                         });
    }
}

TEST_P(ObjectOutOfMemory, ACutWithAGapLosesNothingButWhatTheBladeTakes)
{
    CutOptions options;
    options.gap = 0.1;
    const double volume = object().mass_properties().volume, blade = 4.0 * options.gap;  // a slice across its box
    const Plane plane = Plane::y(0.1).value();
    for (const Failure failure : {Failure::once, Failure::for_good})
        for (std::uint64_t number = 0;; ++number) {
            Object whole = object();
            Cut result;
            bool happened = false;
            {
                const FailingAllocation failing(number, failure);
                result = cut(std::move(whole), plane, options);
                happened = failing.happened();
            }
            ASSERT_TRUE(ok(result.status) || (happened && result.status == Status::out_of_memory));
            double left = result.object.mass_properties().volume;
            for (const Side side : {Side::positive, Side::negative})
                for (std::size_t i = 0; const Object* piece = result.piece(side, i); ++i)
                    left += piece->mass_properties().volume;
            ASSERT_GE(left, volume - blade) << "allocation " << number;
            if (!happened) break;
        }
}

TEST_P(ObjectOutOfMemory, WhatMovesAnObjectLeavesItWhereItWas)
{
    // A half, because it has a relative to be taken away from.
    Object other;
    const auto half = [&] {
        Cut halves = cut(object(), Plane::x(0.1).value());
        other = std::move(*halves.one(Side::negative));
        return std::move(*halves.one(Side::positive));
    };
    fail_each_change(half, [](Object& object) { return object.detach(); });
    fail_each_change(half, [](Object& object) { return object.compact(); });
    fail_each_change(half, [](Object& object) {
        const std::size_t count = object.material_count();
        const std::uint32_t added = object.add_material({"a name that is too long to lie in the string itself"});
        EXPECT_EQ(object.material_count(), added == kNone ? count : count + 1);
        return added == kNone ? Status::out_of_memory : Status::done;
    });
}

INSTANTIATE_TEST_SUITE_P(All, ObjectOutOfMemory, ::testing::ValuesIn(test::back_end_names()),
                         [](const testing::TestParamInfo<std::string>& test) { return test.param; });

}  // namespace
}  // namespace kerf
