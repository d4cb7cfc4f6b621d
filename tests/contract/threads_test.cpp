// What cut.h promises to programs of several threads: a test for each line of the table at Cuttable, in each of its
// columns that says yes, and for what stands around it. The thread sanitizer sees what a run without it would hide.
//
// Each line is tried some times, with other deeds and delays: KERF_THREAD_ROUNDS in the environment says how often.

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <barrier>
#include <bit>
#include <chrono>
#include <cstdlib>
#include <functional>
#include <map>
#include <string>
#include <thread>
#include <tuple>
#include <vector>

#include "common/cutting/cut.h"
#include "common/proxy/collision_proxy.h"
#include "common/sections/section_measures.h"
#include "support/backends.h"
#include "support/fixtures.h"
#include "support/referee.h"

namespace kerf::core {
namespace {

std::uint64_t rounds()
{
    constexpr std::uint64_t kFew = 12;
    const char* const wanted = std::getenv("KERF_THREAD_ROUNDS");
    return wanted ? std::strtoull(wanted, nullptr, 10) : kFew;
}

using Bytes = std::vector<std::uint32_t>;

void append(Bytes& bytes, const Bytes& more)
{
    bytes.push_back(static_cast<std::uint32_t>(more.size()));
    bytes.insert(bytes.end(), more.begin(), more.end());
}

void append(Bytes& bytes, double value)
{
    const auto bits = std::bit_cast<std::uint64_t>(value);
    bytes.insert(bytes.end(), {static_cast<std::uint32_t>(bits), static_cast<std::uint32_t>(bits >> 32)});
}

void append(Bytes& bytes, const glm::vec3& p)
{
    for (int axis = 0; axis < 3; ++axis) bytes.push_back(std::bit_cast<std::uint32_t>(p[axis]));
}

const Plane& first_plane()
{
    static const Plane plane = *Plane::through({0.05, 0.1, 0.02}, {1, 2, 3});
    return plane;
}

/// Cuts an object into its pieces; the bytes of all that comes out.
Bytes cut_to_bytes(std::unique_ptr<Cuttable> object)
{
    CutOptions options;
    options.split_components = true;
    const Plane plane = *Plane::through(object->bounds().centre(), {3, -1, 1});
    const CutResult result = cut(std::move(object), plane, options);
    Bytes bytes{static_cast<std::uint32_t>(result.status)};
    append(bytes, result.section_area);
    for (const auto* side : {&result.negative, &result.positive})
        for (const auto& piece : *side) {
            append(bytes, referee::bytes_of(piece->to_indexed_mesh()));
            append(bytes, piece->mass_properties().volume);
            bytes.push_back(static_cast<std::uint32_t>(piece->section_loops().size()));
        }
    return bytes;
}

/// What is drawn of an object, as whoever draws it sees it.
Bytes drawn(const DrawView& view)
{
    Bytes bytes{static_cast<std::uint32_t>(view.materials.size())};
    for (const Material& material : view.materials)
        bytes.insert(bytes.end(), material.name.begin(), material.name.end());
    for (const DrawRange& range : view.ranges) {
        bytes.insert(bytes.end(), {range.index_count, range.material, static_cast<std::uint32_t>(range.kind)});
        for (const std::uint32_t i : view.indices.subspan(range.first_index, range.index_count))
            append(bytes, view.vertices[i].position);
    }
    return bytes;
}

// ----- deeds -----

/// A call of a const member.
struct Reading
{
    const char* name;
    std::function<Bytes(const Cuttable&)> read;
};

const std::vector<Reading>& readings()
{
    static const std::vector<Reading> all{
        {"clone", [](const Cuttable& object) { return cut_to_bytes(object.clone()); }},
        {"triangle_count", [](const Cuttable& object) { return Bytes{std::uint32_t(object.triangle_count())}; }},
        {"bounds",
         [](const Cuttable& object) {
             Bytes bytes;
             append(bytes, object.bounds().lo);
             append(bytes, object.bounds().hi);
             return bytes;
         }},
        {"draw_view",
         [](const Cuttable& object) {
             Bytes bytes;
             for (const DrawRange& range : object.draw_view().ranges)
                 bytes.insert(bytes.end(), {range.first_index, range.index_count, range.material});
             return bytes;
         }},
        {"mass_properties",
         [](const Cuttable& object) {
             Bytes bytes;
             const MassProperties mass = object.mass_properties();
             append(bytes, mass.volume);
             for (int axis = 0; axis < 3; ++axis) append(bytes, mass.centre[axis]);
             return bytes;
         }},
        {"bounded_hull",
         [](const Cuttable& object) {
             return Bytes{std::uint32_t(collision_proxy(object, ProxyKind::bounded_hull).points.size())};
         }},
        {"full_hull",
         [](const Cuttable& object) {
             return Bytes{std::uint32_t(collision_proxy(object, ProxyKind::full_hull).points.size())};
         }},
        {"section_loops",
         [](const Cuttable& object) {
             Bytes bytes;
             for (const SectionLoop& loop : object.section_loops())
                 for (const glm::vec3& p : loop.points) append(bytes, p);
             return bytes;
         }},
        {"section",
         [](const Cuttable& object) {
             PlaneSection found;
             Bytes bytes{static_cast<std::uint32_t>(section(object, first_plane(), found))};
             for (const glm::vec3& p : found.points) append(bytes, p);
             append(bytes, measure_section(first_plane(), found).area);
             return bytes;
         }},
        {"to_indexed_mesh", [](const Cuttable& object) { return referee::bytes_of(object.to_indexed_mesh()); }},
        {"wants_compaction", [](const Cuttable& object) { return Bytes{object.wants_compaction()}; }},
        {"shares_buffers_with", [](const Cuttable& object) { return Bytes{object.shares_buffers_with(object)}; }},
    };
    return all;
}

/// What changes an object and leaves it there, or ends it. The bytes are those of what is left or comes of it.
struct Change
{
    const char* name;
    std::function<Bytes(std::unique_ptr<Cuttable>)> make;
};

/// Changes that do not cut.
const std::vector<Change>& gentle_changes()
{
    static const std::vector<Change> all{
        {"compact",
         [](std::unique_ptr<Cuttable> object) {
             object->compact();
             return referee::bytes_of(object->to_indexed_mesh());
         }},
        {"detach",
         [](std::unique_ptr<Cuttable> object) {
             const Status status = object->detach();
             Bytes bytes = referee::bytes_of(object->to_indexed_mesh());
             bytes.push_back(static_cast<std::uint32_t>(status));
             return bytes;
         }},
        {"mark_uploaded",
         [](std::unique_ptr<Cuttable> object) {
             object->mark_uploaded(object->draw_view());
             return referee::bytes_of(object->to_indexed_mesh());
         }},
        {"end",
         [](std::unique_ptr<Cuttable> object) {
             object.reset();
             return Bytes{};
         }},
    };
    return all;
}

/// Cuts that hit and cuts that miss.
const std::vector<Change>& cuts()
{
    static const std::vector<Change> all{
        {"cut", cut_to_bytes},
        {"miss",
         [](std::unique_ptr<Cuttable> object) {
             CutResult result = cut(std::move(object), Plane{{0, 0, 1}, 1e3});
             return referee::bytes_of(result.object->to_indexed_mesh());
         }},
        {"detach and cut",
         [](std::unique_ptr<Cuttable> object) {
             object->detach();
             return cut_to_bytes(std::move(object));
         }},
    };
    return all;
}

const std::vector<Change>& changes()
{
    static const std::vector<Change> all = [] {
        std::vector<Change> both = gentle_changes();
        both.insert(both.end(), cuts().begin(), cuts().end());
        return both;
    }();
    return all;
}

// ----- rounds -----

/// Two halves of one cut, and a stranger that is like the first.
struct Family
{
    std::unique_ptr<Cuttable> one, relative, stranger;
};

/// A short time to let pass: often none, so that threads meet at the first instruction as well.
void dawdle(test::Random& random)
{
    if (random.below(3) == 0) return;
    std::this_thread::sleep_for(std::chrono::microseconds(random.below(200)));
}

/// What a thread of a round does, and the bytes that it sees. `name` says what it was.
struct Part
{
    std::string name;
    std::function<Bytes(test::Random&)> play;
    Bytes expected;
};

/// Runs the parts of a round, a thread each, and compares what they saw with what they would have seen alone.
void play(const std::vector<Part>& parts, std::uint64_t seed)
{
    std::barrier start(static_cast<std::ptrdiff_t>(parts.size()));
    std::vector<Bytes> seen(parts.size());
    std::vector<std::thread> threads;
    for (std::size_t i = 0; i < parts.size(); ++i)
        threads.emplace_back([&, i] {
            test::Random random(seed * 16 + i);
            start.arrive_and_wait();
            dawdle(random);
            seen[i] = parts[i].play(random);
        });
    for (std::thread& thread : threads) thread.join();
    std::string all;
    for (const Part& part : parts) all += part.name + "; ";
    for (std::size_t i = 0; i < parts.size(); ++i)
        EXPECT_EQ(seen[i], parts[i].expected) << parts[i].name << " of: " << all << "seed " << seed;
}

class Threads : public testing::TestWithParam<test::NamedBackend>
{
protected:
    std::unique_ptr<Backend> backend_ = GetParam().make();

    /// The halves of a shape. Without caps at first, so that cuts add the material of caps.
    Family family(const std::string& shape)
    {
        std::unique_ptr<Cuttable>& whole = prepared_[shape];
        if (!whole) whole = backend_->prepare(test::closed_shape(shape)).object;
        CutOptions options;
        options.build_caps = shape != "torus";
        CutResult halves = cut(whole->clone(), first_plane(), options);
        Family family{std::move(halves.positive.at(0)), std::move(halves.negative.at(0)), nullptr};
        family.stranger = family.one->clone();
        return family;
    }

    enum class Who
    {
        one,
        relative,
        stranger,
    };
    static std::unique_ptr<Cuttable>& member(Family& family, Who who)
    {
        return who == Who::one ? family.one : who == Who::relative ? family.relative : family.stranger;
    }

    /// Some readings, with pauses between them.
    Part reads(const std::string& shape, Family& family, Who who, test::Random& random)
    {
        Part part{"reads:", {}, {}};
        std::vector<const Reading*> chosen;
        for (int i = 0; i < 3; ++i) {
            chosen.push_back(&readings()[random.below(static_cast<std::uint32_t>(readings().size()))]);
            part.name += std::string(" ") + chosen.back()->name;
            append(part.expected, alone(shape, who, *chosen.back()));
        }
        part.play = [chosen, &object = *member(family, who)](test::Random& pauses) {
            Bytes bytes;
            for (const Reading* reading : chosen) {
                append(bytes, reading->read(object));
                dawdle(pauses);
            }
            return bytes;
        };
        return part;
    }

    Part changes_by(const std::vector<Change>& choice, const std::string& shape, Family& family, Who who,
                    test::Random& random)
    {
        const Change& change = choice[random.below(static_cast<std::uint32_t>(choice.size()))];
        return {change.name, [&change, &object = member(family, who)](auto&) { return change.make(std::move(object)); },
                alone(shape, who, change)};
    }

    /// Draws the first half now and then, from what draw_view() said at the start.
    static Part draws(Family& family)
    {
        const DrawView view = family.one->draw_view();
        return {"draws",
                [view](test::Random& pauses) {
                    Bytes bytes;
                    for (int i = 0; i < 3; ++i) {
                        bytes = drawn(view);
                        dawdle(pauses);
                    }
                    return bytes;
                },
                drawn(view)};
    }

    /// What a deed gives when nobody else is there.
    Bytes alone(const std::string& shape, Who who, const Reading& reading)
    {
        return remember(shape, who, reading.name, [&](Family& family) { return reading.read(*member(family, who)); });
    }
    Bytes alone(const std::string& shape, Who who, const Change& change)
    {
        return remember(shape, who, change.name,
                        [&](Family& family) { return change.make(std::move(member(family, who))); });
    }

    template <class Do>
    const Bytes& remember(const std::string& shape, Who who, const std::string& name, Do deed)
    {
        const auto [entry, is_new] = known_.try_emplace({shape, who, name});
        if (is_new) {
            Family fresh = family(shape);
            entry->second = deed(fresh);
        }
        return entry->second;
    }

    /// Calls round(shape, family, random), which gives the parts, and plays them.
    template <class Round>
    void for_each_round(Round round)
    {
        for (std::uint64_t seed = 0; seed < rounds() && !HasFailure(); ++seed) {
            test::Random random(seed);
            const std::string shape = std::array{"torus", "sphere_in_sphere", "uv_sphere"}[seed % 3];
            Family objects = family(shape);
            play(round(shape, objects, random), seed);
        }
    }

private:
    std::map<std::string, std::unique_ptr<Cuttable>> prepared_;
    std::map<std::tuple<std::string, Who, std::string>, Bytes> known_;
};

INSTANTIATE_TEST_SUITE_P(BackEnds, Threads, testing::ValuesIn(test::backends()),
                         [](const auto& parameter) { return parameter.param.name; });

// ----- the lines of the table -----

TEST_P(Threads, ReadBesideReadsOfAnyObject)
{
    for_each_round([&](const std::string& shape, Family& family, test::Random& random) {
        std::vector<Part> parts;
        for (const Who who : {Who::one, Who::one, Who::relative, Who::stranger})
            parts.push_back(reads(shape, family, who, random));
        return parts;
    });
}

TEST_P(Threads, ReadBesideChangesOfRelativesAndStrangers)
{
    for_each_round([&](const std::string& shape, Family& family, test::Random& random) {
        std::vector<Part> parts;
        for (int reader = 0; reader < 2; ++reader) parts.push_back(reads(shape, family, Who::one, random));
        for (const Who who : {Who::relative, Who::stranger})
            parts.push_back(changes_by(changes(), shape, family, who, random));
        return parts;
    });
}

TEST_P(Threads, ChangeBesideChangesOfRelativesAndStrangers)
{
    for_each_round([&](const std::string& shape, Family& family, test::Random& random) {
        std::vector<Part> parts;
        for (const Who who : {Who::one, Who::relative, Who::stranger})
            parts.push_back(changes_by(changes(), shape, family, who, random));
        return parts;
    });
}

TEST_P(Threads, DrawBesideReadsOfAnyObject)
{
    for_each_round([&](const std::string& shape, Family& family, test::Random& random) {
        std::vector<Part> parts{draws(family)};
        for (const Who who : {Who::one, Who::relative, Who::stranger})
            parts.push_back(reads(shape, family, who, random));
        return parts;
    });
}

TEST_P(Threads, DrawBesideChangesOfRelativesAndStrangers)
{
    for_each_round([&](const std::string& shape, Family& family, test::Random& random) {
        return std::vector<Part>{draws(family), changes_by(changes(), shape, family, Who::relative, random),
                                 changes_by(changes(), shape, family, Who::stranger, random)};
    });
}

TEST_P(Threads, DrawBesideCutsOfRelativesAndStrangers)
{
    for_each_round([&](const std::string& shape, Family& family, test::Random& random) {
        return std::vector<Part>{draws(family), changes_by(cuts(), shape, family, Who::relative, random),
                                 changes_by(cuts(), shape, family, Who::stranger, random)};
    });
}

TEST_P(Threads, DrawWhileRelativesAreCutUntilAllReservedRoomIsUsed)
{
    // Many times what prepare() reserved: the buffers grow, and what is drawn stays where it is.
    constexpr int kCuts = 60;
    for (const std::string shape : {"torus", "asteroid"}) {
        Family objects = family(shape);
        const DrawView view = objects.one->draw_view();
        const Bytes before = drawn(view);
        std::atomic<bool> is_done = false;
        std::thread cutter([&] {
            test::Random random(5);
            std::vector<std::unique_ptr<Cuttable>> pieces;
            pieces.push_back(std::move(objects.relative));
            for (int i = 0; i < kCuts; ++i) {
                const std::size_t chosen = random.below(static_cast<std::uint32_t>(pieces.size()));
                std::unique_ptr<Cuttable> piece = std::move(pieces[chosen]);
                pieces.erase(pieces.begin() + static_cast<std::ptrdiff_t>(chosen));
                const glm::dvec3 centre = piece->bounds().centre();
                CutResult result = cut(std::move(piece), *Plane::through(centre, random.direction()));
                if (result.object) pieces.push_back(std::move(result.object));
                for (auto* side : {&result.positive, &result.negative})
                    for (auto& part : *side) pieces.push_back(std::move(part));
            }
            is_done = true;
        });
        while (!is_done) EXPECT_EQ(drawn(view), before);
        cutter.join();
        EXPECT_EQ(drawn(view), before);
    }
}

// ----- around it -----

TEST_P(Threads, ACutGetsItsTurnAmongReadersThatNeverPause)
{
    // Where readers pass a cut that waits, they pass it some 50 000 times a second, for 10 to 40 seconds on two cores.
    constexpr std::uint64_t kTooMany = 300'000;
    const std::string shape = "torus";
    Family objects = family(shape);
    std::atomic<bool> is_cut = false;
    std::atomic<std::uint64_t> reads = 0;
    std::vector<std::thread> readers;
    for (int i = 0; i < 3; ++i)
        readers.emplace_back([&] {
            while (!is_cut && ++reads < kTooMany) objects.one->to_indexed_mesh();
        });
    while (reads < 3) std::this_thread::yield();
    const Bytes bytes = cut_to_bytes(std::move(objects.relative));
    is_cut = true;
    for (std::thread& reader : readers) reader.join();
    EXPECT_LT(reads, kTooMany);
    Family untouched = family(shape);
    EXPECT_EQ(bytes, cut_to_bytes(std::move(untouched.relative)));
}

TEST_P(Threads, MayPrepareWithOneBackEndAtOnce)
{
    for (const std::string shape : {"comb", "spiral_wall", "sphere_in_sphere", "asteroid"}) {
        const IndexedMesh& mesh = test::closed_shape(shape);
        const auto prepare_and_cut = [&] { return cut_to_bytes(backend_->prepare(mesh).object); };
        const Part part{"prepares " + shape, [&](auto&) { return prepare_and_cut(); }, prepare_and_cut()};
        play({part, part, part, part}, 1);
    }
}

TEST_P(Threads, MayEndTheLastTwoOfAFamilyAtOnce)
{
    for_each_round([&](const std::string&, Family& family, test::Random&) {
        const auto end = [](std::unique_ptr<Cuttable>& object) {
            return Part{"ends", [&](auto&) { return object.reset(), Bytes{}; }, {}};
        };
        return std::vector<Part>{end(family.one), end(family.relative)};
    });
}

}  // namespace
}  // namespace kerf::core
