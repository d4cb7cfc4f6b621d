// What a hurried programmer writes: each is a compile error, a status with a sentence, or defined; none crashes.

#include <kerf/kerf.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>
#include <string>
#include <thread>
#include <type_traits>
#include <vector>

#include "api/objects.h"

namespace kerf {
namespace {

template <class A, class B>
concept MakesAPlane = requires(A a, B b)
{
    Plane::at(a, b);
};
template <class T>
void take(T);
template <class T>
concept IsMadeOfBraces = requires
{
    take<T>({0.0, 0.0, 1.0});
};
template <class T>
concept CutsAnObjectThatStays = requires(T& object, const Plane& plane)
{
    cut(object, plane);
};

template <class T>
concept GivesAwayItsSections = requires(T t)
{
    static_cast<T&&>(t).all();
};

TEST(Misuse, WhatDoesNotCompile)
{
    static_assert(GivesAwayItsSections<const SectionStack&>);
    static_assert(!GivesAwayItsSections<SectionStack>, "sections of a stack that is gone at the end of the line");
    static_assert(MakesAPlane<Point, Normal>);
    static_assert(!MakesAPlane<Normal, Point>, "the wrong order");
    static_assert(!MakesAPlane<Vec3d, Vec3d>, "two vectors, of which nobody knows which is which");
    static_assert(!IsMadeOfBraces<Point> && !IsMadeOfBraces<Normal>,
                  "three numbers, of which nobody knows what they are");
    static_assert(!std::is_default_constructible_v<Plane>, "a plane that nobody chose");
    static_assert(!std::is_copy_constructible_v<Object>, "a copy of millions of triangles that nobody saw");
    static_assert(!CutsAnObjectThatStays<Object>, "an object that is gone afterwards without std::move()");
    static_assert(!std::is_convertible_v<std::optional<Plane>, Plane>, "a plane that may not be there");
    static_assert(!std::is_convertible_v<Result<Object>, bool>, "a result for a number");
}

TEST(Misuse, AnObjectThatWasCutIsEmpty)
{
    for (const std::string& name : test::back_end_names()) {
        Object object = test::cube(name);
        const Cut first = cut(std::move(object), Plane::x(0.0).value());
        EXPECT_EQ(first.status, Status::done);
        EXPECT_TRUE(object.is_empty());  // NOLINT(bugprone-use-after-move): that is what is tested
        const Cut second = cut(std::move(object), Plane::x(0.0).value());
        EXPECT_EQ(second.status, Status::invalid_argument);
        EXPECT_STREQ(second.reason(), "the object is empty: it was cut, or moved from");
        // NOLINTNEXTLINE(bugprone-use-after-move)
        EXPECT_EQ(cut_copy(object, Plane::x(0.0).value()).status, Status::invalid_argument);
    }
}

TEST(Misuse, AMissedCutHasNoPieces)
{
    for (const std::string& name : test::back_end_names()) {
        Cut missed = cut(test::cube(name), Plane::x(7.0).value());
        EXPECT_EQ(missed.one(Side::positive), nullptr);
        EXPECT_EQ(missed.piece(Side::negative, 0), nullptr);
        EXPECT_EQ(missed.statistics().section_loops, 0u);
    }
}

TEST(Misuse, AResultWithoutAValueIsEmptyAndSaysWhy)
{
    Result<Mesh> none = Mesh::make(MeshInput());
    EXPECT_EQ(none->triangle_count(), 0u);
    const Result<Object> object = prepare(*none);
    EXPECT_EQ(object.status(), Status::invalid_mesh);
    EXPECT_STRNE(object.reason(), "");
    EXPECT_EQ(object->mesh().status(), Status::invalid_argument);
}

TEST(Misuse, IndicesAtRandomAreRefusedOrRepaired)
{
    std::mt19937 random(7);
    for (int times = 0; times < 300; ++times) {
        test::Arrays mesh = test::cube_arrays();
        const std::uint32_t most = times % 3 == 0 ? 9 : 7;  // now and then beyond the last vertex
        for (std::uint32_t& index : mesh.indices)
            if (std::uniform_int_distribution<int>(0, 3)(random) == 0)
                index = std::uniform_int_distribution<std::uint32_t>(0, most)(random);
        const Result<Mesh> made = Mesh::make(mesh.input());
        if (!made) {
            EXPECT_EQ(made.status(), Status::invalid_mesh);
            EXPECT_STRNE(made.reason(), "");
            continue;
        }
        for (const std::string& name : test::back_end_names()) {
            const Cut result = cut(test::object_of(*made, name), test::plane_at(0.1, 0.2, 0.3, 1, 2, 3));
            EXPECT_TRUE(ok(result.status) || result.status == Status::missed);
        }
    }
}

TEST(Misuse, AStrideInNumbersInsteadOfBytesIsRefused)
{
    const test::Arrays mesh = test::cube_arrays();
    const std::vector<float> ones(3 * mesh.input().vertex_count, 1.0f);
    const auto is_refused = [](const MeshInput& input) {
        const Result<Mesh> made = Mesh::make(input);
        return made.status() == Status::invalid_mesh && std::string(made.reason()).find("stride") != std::string::npos;
    };
    for (const std::size_t stride : {std::size_t{0}, std::size_t{3}, std::size_t{7}, SIZE_MAX, SIZE_MAX / 2}) {
        MeshInput position = mesh.input(), normal = mesh.input(), uv = mesh.input(), stream = mesh.input();
        position.position_stride = stride;
        normal.normals = uv.uvs = ones.data();
        normal.normal_stride = uv.uv_stride = stride;
        const StreamInput colours{"colour", ones.data(), 3, stride};
        stream.streams = {&colours, 1};
        EXPECT_TRUE(is_refused(position)) << stride;
        EXPECT_TRUE(is_refused(normal)) << stride;
        EXPECT_TRUE(is_refused(uv)) << stride;
        EXPECT_EQ(is_refused(stream), stride != 0) << stride;
    }
}

TEST(Misuse, NumbersBeyondTheLastAreNothing)
{
    const Mesh mesh = test::mesh_of(test::cube_arrays());
    constexpr std::size_t kFar = std::numeric_limits<std::size_t>::max();
    EXPECT_STREQ(mesh.material(kFar).name, "");
    EXPECT_TRUE(mesh.stream(kFar).values.empty());
    for (const std::string& name : test::back_end_names()) {
        Cut result = cut(test::object_of(mesh, name), Plane::x(0.0).value());
        EXPECT_EQ(result.piece(Side::positive, kFar), nullptr);
        EXPECT_TRUE(result.one(Side::positive)->loop(kFar).points.empty());
        EXPECT_STREQ(result.one(Side::positive)->material(kFar).name, "");
    }
}

TEST(Misuse, AColourThatIsNoNumberIsOne)
{
    constexpr float kNan = std::numeric_limits<float>::quiet_NaN(), kInfinity = std::numeric_limits<float>::infinity();
    Object object = test::cube("linear");
    const Material material = object.material(object.add_material({"hot", {kNan, kInfinity, 0.5f, -kInfinity}}));
    EXPECT_EQ(std::vector<float>(material.base_colour, material.base_colour + 4),
              (std::vector<float>{1.0f, 1.0f, 0.5f, 1.0f}));
}

TEST(Misuse, ACapMaterialThatIsNotThereIsTheDefault)
{
    for (const std::string& name : test::back_end_names()) {
        CutOptions options;
        options.cap_material = 77;
        Cut result = cut(test::cube(name), Plane::x(0.0).value(), options);
        const Object& piece = *result.one(Side::positive);
        EXPECT_STREQ(piece.material(piece.material_count() - 1).name, "cap");
    }
}

TEST(Misuse, AViewOfOthersMarksNothing)
{
    for (const std::string& name : test::back_end_names()) {
        Object a = test::cube(name), b = test::cube(name);
        DrawView of_a, of_b;
        ASSERT_EQ(a.draw(of_a), Status::done);
        b.mark_uploaded(of_a);
        b.mark_uploaded(DrawView());
        ASSERT_EQ(b.draw(of_b), Status::done);
        EXPECT_EQ(of_b.new_vertices_from, 0u) << "all of it is still to be uploaded";
    }
}

TEST(Misuse, UploadingAfterTheBuffersWereReleasedMarksNothing)
{
    for (const std::string& name : test::back_end_names()) {
        Cut result = cut(test::cube(name), Plane::x(0.0).value());
        Object& piece = *result.one(Side::positive);
        DrawView old;
        ASSERT_EQ(piece.draw(old), Status::done);
        ASSERT_EQ(piece.compact(), Status::done);
        DrawView fresh;
        ASSERT_EQ(piece.draw(fresh), Status::done);
        if (fresh.buffers == old.buffers) continue;
        piece.mark_uploaded(old);
        ASSERT_EQ(piece.draw(fresh), Status::done);
        EXPECT_EQ(fresh.new_vertices_from, 0u);
    }
}

TEST(Misuse, TwoThreadsOnRelativesTakeTurns)
{
    for (const std::string& name : test::back_end_names()) {
        Cut result = cut(test::object_of(test::shape("torus", 5000), name), Plane::x(0.0).value());
        const auto cut_on = [](Object&& piece) {
            Object object = std::move(piece);
            for (int i = 0; i < 10; ++i) {
                Cut next = cut(std::move(object), test::plane_at(0, 0, 0.01 * i, 0.2, 0.1 * i, 1));
                object = ok(next.status) ? std::move(*next.one(Side::negative)) : std::move(next.object);
                EXPECT_FALSE(object.is_empty());
            }
        };
        std::thread other([&] { cut_on(std::move(*result.one(Side::positive))); });
        cut_on(std::move(*result.one(Side::negative)));
        other.join();
    }
}

TEST(Misuse, AnObjectMovedOntoItselfStays)
{
    for (const std::string& name : test::back_end_names()) {
        Object object = test::cube(name);
        Object& same = object;
        object = std::move(same);
        EXPECT_EQ(object.triangle_count(), 12u);
    }
}

TEST(Misuse, AHugeOrTinyMeshIsCut)
{
    for (const float size : {1e-38f, 1e-20f, 1e20f, 3e38f})
        for (const std::string& name : test::back_end_names()) {
            const Result<Mesh> mesh = Mesh::make(test::cube_arrays(-size, size).input());
            ASSERT_TRUE(mesh) << mesh.reason();
            const Cut result = cut(test::object_of(*mesh, name), Plane::x(0.0).value());
            EXPECT_EQ(result.status, Status::done);
        }
}

TEST(Misuse, AFlatMeshIsCutOrMissed)
{
    test::Arrays flat = test::cube_arrays();
    for (std::array<float, 3>& p : flat.positions) p[2] = 0.0f;
    const Result<Mesh> mesh = Mesh::make(flat.input());
    if (!mesh) {
        EXPECT_STRNE(mesh.reason(), "");
        return;
    }
    for (const std::string& name : test::back_end_names())
        for (const Plane& plane : {Plane::x(0.25).value(), Plane::z(0.0).value()}) {
            const Cut result = cut(test::object_of(*mesh, name), plane);
            EXPECT_TRUE(ok(result.status) || result.status == Status::missed);
        }
}

TEST(Misuse, TextsOfNumbersThatDoNotExistAreThere)
{
    EXPECT_STREQ(text(static_cast<Status>(200)), "unknown");
    EXPECT_STREQ(text(static_cast<Phase>(200)), "unknown");
    EXPECT_STREQ(text(Status::missed), "missed");
    EXPECT_STREQ(text(Phase::rebuild), "rebuild");
}

}  // namespace
}  // namespace kerf
