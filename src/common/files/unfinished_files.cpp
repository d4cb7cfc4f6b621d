#include "common/files/unfinished_files.h"

#include <unistd.h>

#include <atomic>
#include <mutex>
#include <string>

namespace kerf::core::io {

namespace {

enum State : int
{
    kFree,     ///< its owner may change the path
    kSet,      ///< the path is that of an unfinished file
    kRemoved,  ///< a signal handler has it, for ever: the program ends
};

}  // namespace

struct UnfinishedPlace
{
    std::atomic<int> state{kFree};
    std::string path;
    UnfinishedPlace* next = nullptr;       ///< of all places; set before the place is published
    UnfinishedPlace* next_free = nullptr;  ///< guarded by free_places_mutex
};

namespace {

// A signal handler may neither allocate nor wait. It walks this list, which only grows; places are used again.
std::atomic<UnfinishedPlace*> all_places{nullptr};
static_assert(std::atomic<UnfinishedPlace*>::is_always_lock_free && std::atomic<int>::is_always_lock_free);

std::mutex free_places_mutex;
UnfinishedPlace* free_places = nullptr;

UnfinishedPlace* take_free_place() noexcept
{
    const std::lock_guard lock(free_places_mutex);
    UnfinishedPlace* const place = free_places;
    if (place != nullptr) free_places = place->next_free;
    return place;
}

void publish(UnfinishedPlace* place) noexcept
{
    place->next = all_places.load();
    while (!all_places.compare_exchange_weak(place->next, place)) {
    }
}

/// All signals that end a program by default, except those for a fault of the program itself, whose memory a handler
/// could not trust. Those for real time follow.
constexpr int kEndingSignals[] = {SIGINT,  SIGTERM, SIGHUP, SIGQUIT,   SIGPIPE, SIGALRM, SIGXCPU,  SIGABRT,
                                  SIGUSR1, SIGUSR2, SIGIO,  SIGVTALRM, SIGPROF, SIGPWR,  SIGSTKFLT};

template <typename Function>
void for_ending_signals(const Function& function) noexcept
{
    for (const int signal_number : kEndingSignals) function(signal_number);
    for (int signal_number = SIGRTMIN; signal_number <= SIGRTMAX; ++signal_number) function(signal_number);
}

sigset_t ending_signals() noexcept
{
    sigset_t set;
    sigemptyset(&set);
    for_ending_signals([&](int signal_number) { sigaddset(&set, signal_number); });
    return set;
}

void remove_and_end(int signal_number)
{
    remove_unfinished_files();
    std::signal(signal_number, SIG_DFL);
    std::raise(signal_number);  // waits until this handler has returned
}

}  // namespace

UnfinishedFile remember_unfinished(const std::filesystem::path& path)
{
    std::string name = path.native();
    UnfinishedPlace* place = take_free_place();
    if (place == nullptr) publish(place = new UnfinishedPlace);
    place->path = std::move(name);
    place->state.store(kSet);
    return UnfinishedFile(place);
}

void ForgetUnfinished::operator()(UnfinishedPlace* place) const noexcept
{
    int expected = kSet;
    if (!place->state.compare_exchange_strong(expected, kFree)) return;
    const std::lock_guard lock(free_places_mutex);
    place->next_free = free_places;
    free_places = place;
}

void remove_unfinished_files() noexcept
{
    for (UnfinishedPlace* place = all_places.load(); place != nullptr; place = place->next) {
        int expected = kSet;
        if (place->state.compare_exchange_strong(expected, kRemoved)) ::unlink(place->path.c_str());
    }
}

void remove_unfinished_files_on_signals() noexcept
{
    struct sigaction action = {};
    action.sa_handler = remove_and_end;
    // None of them interrupts the removal that another began.
    action.sa_mask = ending_signals();
    for_ending_signals([&](int signal_number) {
        struct sigaction before = {};
        const bool is_default = ::sigaction(signal_number, nullptr, &before) == 0 && before.sa_handler == SIG_DFL;
        // Shells ignore SIGINT for programs that they start in the background; whoever sends it all the same means it.
        const bool is_always_taken = signal_number == SIGINT || signal_number == SIGTERM;
        if (is_default || is_always_taken) ::sigaction(signal_number, &action, nullptr);
    });
    std::signal(SIGXFSZ, SIG_IGN);
}

SignalsWait::SignalsWait() noexcept
{
    const sigset_t set = ending_signals();
    ::pthread_sigmask(SIG_BLOCK, &set, &before_);
}

SignalsWait::~SignalsWait()
{
    ::pthread_sigmask(SIG_SETMASK, &before_, nullptr);
}

}  // namespace kerf::core::io
