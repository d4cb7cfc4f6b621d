// What kerf/object.h promises to programs of several threads: a test for each line of its table, in each of its columns
// that says yes. The thread sanitizer sees what a run without it would hide.
//
// Each line is tried some times, with other deeds: KERF_THREAD_ROUNDS in the environment says how often.

#include <gtest/gtest.h>
#include <kerf/kerf.h>
#include <kerf/proxy.h>

#include <algorithm>
#include <atomic>
#include <barrier>
#include <cstdlib>
#include <functional>
#include <thread>

#include "api/objects.h"

namespace kerf {
namespace {

std::uint64_t rounds_of_threads()
{
    constexpr std::uint64_t kFew = 10;
    const char* const wanted = std::getenv("KERF_THREAD_ROUNDS");
    return wanted != nullptr ? std::strtoull(wanted, nullptr, 10) : kFew;
}

/// Calls of const members. Each gives a number that is the same for an object each time.
using Read = std::function<double(const Object&)>;

const std::vector<Read>& reads()
{
    static const std::vector<Read> all{
        [](const Object& object) { return double(object.triangle_count()); },
        [](const Object& object) { return double(object.bounds().hi.y); },
        [](const Object& object) { return object.mass_properties().volume; },
        [](const Object& object) { return double(object.mesh()->triangle_count()); },
        [](const Object& object) { return object.clone()->mass_properties().volume; },
        [](const Object& object) {
            DrawView view;
            if (!ok(object.draw(view))) return -1.0;
            double sum = 0.0;
            for (const DrawRange& range : view.ranges) sum += range.index_count;
            return sum;
        },
        [](const Object& object) { return double(object.loop_count() > 0 ? object.loop(0).points.size() : 0); },
        [](const Object& object) { return double(object.material(0).base_colour[0]); },
        [](const Object& object) { return double(bounded_hull(object)->points().size()); },
        [](const Object& object) { return double(bounded_hull(object)->indices().size()); },
        [](const Object& object) { return double(full_hull(object)->points().size()); },
        [](const Object& object) {
            SectionOptions options;
            options.fill = true;
            const Section found = section(object, Plane::z(0.01).value(), options);
            return found.area + double(found.path_count()) + double(found.triangles().size());
        },
        [](const Object& object) {
            const std::vector<double> heights{-0.2, -0.1, 0.0, 0.1, 0.2, 0.3};
            StackOptions options;
            options.threads = 2;
            double area = 0.0;
            const SectionStack stack = sections(object, Normal(0, 1, 0), heights, options);
            for (const Section& found : stack.all()) area += found.area;
            return area;
        },
        [](const Object& object) { return cut_copy(object, Plane::z(0.01).value()).section_area; },
        [](const Object& object) {
            FractureOptions options;
            options.cells = 4;
            const Fracture broken = fracture(object, options);
            return 1000.0 * double(broken.count()) + double(broken.bonds().size());
        },
    };
    return all;
}

/// What changes an object, or ends it.
using Change = std::function<void(Object&&)>;

const std::vector<Change>& changes()
{
    static const std::vector<Change> all{
        [](Object&& object) {
            CutOptions options;
            options.components = true;
            const Cut result = cut(std::move(object), Plane::y(0.1).value(), options);
            EXPECT_TRUE(ok(result.status) || result.status == Status::missed);
        },
        [](Object&& object) {
            CutOptions options;
            options.gap = 0.02;
            const Cut result = cut(std::move(object), Plane::z(0.0).value(), options);
            EXPECT_TRUE(ok(result.status));
        },
        [](Object&& object) { EXPECT_EQ(object.detach(), Status::done); },
        [](Object&& object) { EXPECT_EQ(object.compact(), Status::done); },
        [](Object&& object) { EXPECT_NE(object.add_material({"late"}), kNone); },
        [](Object&& object) {
            DrawView view;
            EXPECT_EQ(object.draw(view), Status::done);
            object.mark_uploaded(view);
        },
        [](Object&& object) { object = Object(); },
    };
    return all;
}

/// An object with a section, a relative of it and a stranger.
struct Scene
{
    Object object, relative, stranger;
};

class ObjectThreads : public ::testing::TestWithParam<std::string>
{
protected:
    Scene scene() const
    {
        Cut halves = cut(test::object_of(mesh_, GetParam()), Plane::x(0.05).value());
        Scene made;
        made.stranger = *halves.one(Side::positive)->clone();
        made.object = std::move(*halves.one(Side::positive));
        made.relative = std::move(*halves.one(Side::negative));
        return made;
    }

    /// The first thread starts together with the second.
    static void together(const std::function<void()>& one, const std::function<void()>& other)
    {
        std::barrier start(2);
        std::thread second([&] {
            start.arrive_and_wait();
            other();
        });
        start.arrive_and_wait();
        one();
        second.join();
    }

    static const Read& read_of(std::uint64_t round) { return reads()[round % reads().size()]; }
    static const Change& change_of(std::uint64_t round) { return changes()[round % changes().size()]; }
    /// Long enough that each deed has met each other one.
    static std::uint64_t rounds() { return rounds_of_threads(); }

    Mesh mesh_ = test::shape("torus", 3000);
};

TEST_P(ObjectThreads, BothReadOneObject)
{
    const Scene made = scene();
    for (std::uint64_t round = 0; round < rounds(); ++round) {
        const Read &one = read_of(round), &other = read_of(round / reads().size() + round);
        const double first = one(made.object), second = other(made.object);
        together([&] { EXPECT_EQ(one(made.object), first); }, [&] { EXPECT_EQ(other(made.object), second); });
    }
}

TEST_P(ObjectThreads, OneReadsAndOneReadsARelativeOrAStranger)
{
    const Scene made = scene();
    for (std::uint64_t round = 0; round < rounds(); ++round) {
        const Object& beside = round % 2 == 0 ? made.relative : made.stranger;
        const Read &one = read_of(round), &other = read_of(3 * round + 1);
        const double first = one(made.object), second = other(beside);
        together([&] { EXPECT_EQ(one(made.object), first); }, [&] { EXPECT_EQ(other(beside), second); });
    }
}

TEST_P(ObjectThreads, OneReadsAndOneChangesARelativeOrAStranger)
{
    for (std::uint64_t round = 0; round < rounds(); ++round) {
        Scene made = scene();
        Object& beside = round % 2 == 0 ? made.relative : made.stranger;
        const Read& read = read_of(round);
        const double before = read(made.object);
        together([&] { EXPECT_EQ(read(made.object), before); }, [&] { change_of(round)(std::move(beside)); });
    }
}

TEST_P(ObjectThreads, BothChangeRelativesOrStrangers)
{
    for (std::uint64_t round = 0; round < rounds(); ++round) {
        Scene made = scene();
        Object& beside = round % 2 == 0 ? made.relative : made.stranger;
        together([&] { change_of(round)(std::move(made.object)); },
                 [&] { change_of(round + 1 + round / changes().size())(std::move(beside)); });
    }
}

/// The sum of what a view shows.
double sum_of(const DrawView& view)
{
    double sum = 0.0;
    for (const DrawRange& range : view.ranges)
        for (const std::uint32_t i : view.indices.subspan(range.first_index, range.index_count))
            sum += double(view.vertices[i].position.x) + double(view.vertices[i].normal.z);
    return sum;
}

TEST_P(ObjectThreads, OneUsesAViewAndOneReadsTheObjectARelativeOrAStranger)
{
    const Scene made = scene();
    DrawView view;
    ASSERT_EQ(made.object.draw(view), Status::done);
    const double before = sum_of(view);
    for (std::uint64_t round = 0; round < rounds(); ++round) {
        const std::array<const Object*, 3> all{&made.object, &made.relative, &made.stranger};
        together([&] { EXPECT_EQ(sum_of(view), before); }, [&] { read_of(round)(*all[round % 3]); });
    }
}

TEST_P(ObjectThreads, OneUsesAViewAndOneChangesARelativeOrAStranger)
{
    for (std::uint64_t round = 0; round < rounds(); ++round) {
        Scene made = scene();
        Object& beside = round % 2 == 0 ? made.relative : made.stranger;
        DrawView view;
        ASSERT_EQ(made.object.draw(view), Status::done);
        const double before = sum_of(view);
        together([&] { EXPECT_EQ(sum_of(view), before); }, [&] { change_of(round)(std::move(beside)); });
        EXPECT_EQ(sum_of(view), before);
    }
}

TEST_P(ObjectThreads, ManyCutARelativeEachWhileAViewIsUsed)
{
    CutOptions options;
    options.components = true;
    Cut pieces = cut(test::object_of(test::shape("comb", 4000), GetParam()), Plane::y(0.25).value(), options);
    std::vector<Object> objects;
    for (const Side side : {Side::positive, Side::negative})
        for (std::size_t i = 0; Object* piece = pieces.piece(side, i); ++i) objects.push_back(std::move(*piece));
    ASSERT_GT(objects.size(), 3u);
    DrawView view;
    ASSERT_EQ(objects.front().draw(view), Status::done);
    const double before = sum_of(view);
    std::atomic<std::size_t> running = objects.size() - 1;
    std::vector<std::thread> threads;
    for (std::size_t i = 1; i < objects.size(); ++i)
        threads.emplace_back([&, i] {
            for (int turn = 0; turn < 4; ++turn) {
                const Vec3d middle = objects[i].mass_properties().centre;
                Cut halves = cut(std::move(objects[i]), test::plane_at(middle.x, middle.y, middle.z, turn, 1, 0.3));
                Object* const kept = halves.one(Side::positive);
                objects[i] = kept != nullptr ? std::move(*kept) : std::move(halves.object);
            }
            --running;
        });
    while (running > 0) EXPECT_EQ(sum_of(view), before);
    for (std::thread& thread : threads) thread.join();
}

// Large objects of the half-edge back end are broken by the subtrees of a copy, smaller ones as meshes.
TEST_P(ObjectThreads, OneIsBrokenWhileARelativeIsCut)
{
    Cut halves = cut(test::object_of(test::shape("asteroid", 50'000), GetParam()), Plane::x(0.05).value());
    const Object object = std::move(*halves.one(Side::positive));
    ASSERT_GT(object.triangle_count(), 20'000u);
    Object relative = std::move(*halves.one(Side::negative));
    FractureOptions options;
    options.cells = 12;
    const auto break_it = [&] {
        Fracture broken = fracture(object, options);
        double volume = double(broken.bonds().size());
        for (std::size_t i = 0; Object* const piece = broken.piece(i); ++i) volume += piece->mass_properties().volume;
        return volume;
    };
    const double alone = break_it();
    together([&] { EXPECT_EQ(break_it(), alone); },
             [&] {
                 for (int turn = 0; turn < 8; ++turn) {
                     const Vec3d middle = relative.mass_properties().centre;
                     Cut result = cut(std::move(relative), test::plane_at(middle.x, middle.y, middle.z, turn, 1, 0.3));
                     Object* const kept = result.one(Side::positive);
                     relative = kept != nullptr ? std::move(*kept) : std::move(result.object);
                 }
             });
}

TEST_P(ObjectThreads, TwoPrepareOneObjectTogetherAsOneDoesAlone)
{
    const Mesh mesh = test::shape("asteroid", 30'000);
    PrepareOptions options;
    options.back_end_name = GetParam().c_str();
    const Result<Object> alone = prepare(mesh, options);
    ASSERT_TRUE(alone);
    for (const std::uint32_t threads : {2u, 0u}) {
        options.threads = threads;
        const Result<Object> together = prepare(mesh, options);
        ASSERT_TRUE(together);
        EXPECT_EQ(together->mass_properties().volume, alone->mass_properties().volume);
        const Mesh one = *alone->mesh(), other = *together->mesh();
        EXPECT_TRUE(std::ranges::equal(one.arrays().indices, other.arrays().indices)) << threads;
    }
    // Stopped while both are at work.
    options.threads = 2;
    options.progress = [](void*, double share) { return share < 0.7; };
    EXPECT_EQ(prepare(mesh, options).status(), Status::cancelled);
}

std::string test_name(const testing::TestParamInfo<std::string>& info)
{
    return info.param;
}

INSTANTIATE_TEST_SUITE_P(All, ObjectThreads, ::testing::ValuesIn(test::back_end_names()), test_name);

}  // namespace
}  // namespace kerf
