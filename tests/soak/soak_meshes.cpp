// A million meshes as a program may hand them over, most of them wrong, through prepare() and cut() of both back ends:
// a table of what became of each kind. For the address sanitizer: ./run soak-meshes.

#include <atomic>
#include <charconv>
#include <cstdio>
#include <exception>
#include <mutex>
#include <string_view>
#include <thread>
#include <vector>

#include "baseline/baseline.h"
#include "halfedge/halfedge.h"
#include "support/mesh_trial.h"
#include "support/wrong_meshes.h"

namespace {

using namespace kerf::core;

struct Tally
{
    std::uint64_t tried = 0, refused = 0, cut = 0, missed = 0, closed = 0, pieces = 0, proven_pieces = 0;

    void add(const test::MeshTrial& trial)
    {
        ++tried;
        refused += !trial.refusal.empty();
        cut += trial.cuts;
        missed += trial.missed;
        closed += trial.closed;
        pieces += trial.pieces;
        proven_pieces += trial.proven_pieces;
    }
    void add(const Tally& other)
    {
        tried += other.tried;
        refused += other.refused;
        cut += other.cut;
        missed += other.missed;
        closed += other.closed;
        pieces += other.pieces;
        proven_pieces += other.proven_pieces;
    }
};

void print(std::string_view name, const Tally& tally)
{
    std::printf("| %.*s | %llu | %llu | %llu | %llu | %llu | %llu | %llu |\n", static_cast<int>(name.size()),
                name.data(), static_cast<unsigned long long>(tally.tried),
                static_cast<unsigned long long>(tally.refused), static_cast<unsigned long long>(tally.cut),
                static_cast<unsigned long long>(tally.missed), static_cast<unsigned long long>(tally.closed),
                static_cast<unsigned long long>(tally.pieces), static_cast<unsigned long long>(tally.proven_pieces));
}

/// The numbered mesh: its number alone decides what is wrong with it and how it is cut.
void try_number(std::uint64_t number, std::span<const std::unique_ptr<Backend>> backends, std::vector<Tally>& tallies)
{
    const auto changes = test::mesh_changes();
    const std::size_t kind = static_cast<std::size_t>(number % (changes.size() + 1));
    test::Random random(number);
    IndexedMesh mesh = test::small_mesh(random);
    if (kind < changes.size()) {
        changes[kind].apply(mesh, random);
    } else {
        // Several at once; what comes later must not trip over what came before, so that only some go together.
        for (const test::MeshChange& change : changes)
            if (change.verdict == test::Verdict::cut && random.below(4) == 0) change.apply(mesh, random);
        changes[random.below(static_cast<std::uint32_t>(changes.size()))].apply(mesh, random);
    }
    const test::MeshTrial trial = test::try_mesh(mesh, backends, random);
    const bool is_refused = !trial.refusal.empty();
    if (kind < changes.size() && ((changes[kind].verdict == test::Verdict::refused && !is_refused) ||
                                  (changes[kind].verdict == test::Verdict::cut && is_refused)))
        throw std::logic_error(is_refused ? "it is refused: " + trial.refusal : "it is not refused");
    tallies[kind].add(trial);
}

bool read_number(std::string_view text, std::uint64_t& number)
{
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    return error == std::errc() && end == text.data() + text.size();
}

}  // namespace

int main(int argc, char** argv)
{
    std::uint64_t count = 1'000'000, first = 0;
    for (int i = 1; i + 1 < argc; i += 2) {
        const std::string_view option = argv[i];
        if (!((option == "--count" && read_number(argv[i + 1], count)) ||
              (option == "--first" && read_number(argv[i + 1], first)))) {
            argc = 0;
            break;
        }
    }
    if (argc % 2 == 0) {
        std::fprintf(stderr, "usage: soak_meshes [--count N] [--first NUMBER]\n");
        return 2;
    }

    const auto changes = test::mesh_changes();
    std::vector<Tally> tallies(changes.size() + 1);
    std::atomic<std::uint64_t> next = first, failures = 0;
    std::mutex mutex;
    const auto work = [&] {
        std::vector<std::unique_ptr<Backend>> backends;
        backends.push_back(baseline::make_back_end());
        backends.push_back(halfedge::make_back_end());
        std::vector<Tally> own(tallies.size());
        constexpr std::uint64_t kBatch = 1000;
        for (std::uint64_t begin; (begin = next.fetch_add(kBatch)) < first + count;) {
            for (std::uint64_t number = begin; number < std::min(begin + kBatch, first + count); ++number) {
                try {
                    try_number(number, backends, own);
                } catch (const std::exception& error) {
                    ++failures;
                    const std::lock_guard lock(mutex);
                    std::fprintf(stderr, "mesh %llu: %s\n", static_cast<unsigned long long>(number), error.what());
                }
            }
            if ((begin - first) % 50'000 == 0) {
                const std::lock_guard lock(mutex);
                std::fprintf(stderr, "soak-meshes: %llu of %llu\n", static_cast<unsigned long long>(begin - first),
                             static_cast<unsigned long long>(count));
            }
        }
        const std::lock_guard lock(mutex);
        for (std::size_t i = 0; i < own.size(); ++i) tallies[i].add(own[i]);
    };
    std::vector<std::jthread> threads;
    for (unsigned i = 0; i < std::max(1u, std::thread::hardware_concurrency()); ++i) threads.emplace_back(work);
    threads.clear();

    std::printf("| meshes | tried | refused | cuts | missed | closed cuts | pieces | pieces that are proven again |\n");
    std::printf("|---|---:|---:|---:|---:|---:|---:|---:|\n");
    Tally all;
    for (std::size_t i = 0; i < tallies.size(); ++i) {
        print(i < changes.size() ? changes[i].name : "several of these", tallies[i]);
        all.add(tallies[i]);
    }
    print("**all**", all);
    std::printf("\n%llu broke a promise\n", static_cast<unsigned long long>(failures.load()));
    return failures == 0 ? 0 : 1;
}
