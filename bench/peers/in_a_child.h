#pragma once

#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <optional>
#include <type_traits>

namespace kerf::bench {

/// What `work()` gives, asked for in a process of its own, which is ended after so many seconds; nothing if it had not
/// come to an end by then, or crashed. For libraries that may do either.
template <class Work>
std::optional<std::invoke_result_t<Work>> in_a_child(int most_seconds, Work work)
{
    using Answer = std::invoke_result_t<Work>;
    static_assert(std::is_trivially_copyable_v<Answer>, "it comes through a pipe");
    int ends[2];
    if (pipe(ends) != 0) return std::nullopt;
    const pid_t child = fork();
    if (child == 0) {
        const Answer answer = work();
        const bool is_written = write(ends[1], &answer, sizeof answer) == ssize_t(sizeof answer);
        _exit(is_written ? 0 : 1);
    }
    close(ends[1]);
    std::optional<Answer> answer;
    if (child > 0) {
        pollfd waiting{ends[0], POLLIN, 0};
        Answer read_answer;
        if (poll(&waiting, 1, 1000 * most_seconds) == 1 &&
            read(ends[0], &read_answer, sizeof read_answer) == ssize_t(sizeof read_answer))
            answer = read_answer;
        kill(child, SIGKILL);
        waitpid(child, nullptr, 0);
    }
    close(ends[0]);
    return answer;
}

}  // namespace kerf::bench
