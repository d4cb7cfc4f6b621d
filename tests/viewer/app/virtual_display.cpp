#include "viewer/app/virtual_display.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <stdexcept>

namespace kerf::test {

VirtualDisplay::VirtualDisplay()
{
    std::array<int, 2> pipe_ends{};
    if (::pipe(pipe_ends.data()) != 0) throw std::runtime_error("no pipe to Xvfb");
    server_ = ::fork();
    if (server_ == 0) {
        // The server chooses a free display and writes its number into the pipe when it is ready.
        const std::string number = std::to_string(pipe_ends[1]);
        ::close(pipe_ends[0]);
        const int nothing = ::open("/dev/null", O_WRONLY);
        ::dup2(nothing, STDOUT_FILENO);
        ::dup2(nothing, STDERR_FILENO);
        ::execlp("Xvfb", "Xvfb", "-displayfd", number.c_str(), "-screen", "0", "1280x1024x24", "-nolisten", "tcp",
                 static_cast<char*>(nullptr));
        ::_exit(127);
    }
    ::close(pipe_ends[1]);
    std::string number;
    for (char c = 0; ::read(pipe_ends[0], &c, 1) == 1 && c != '\n';) number += c;
    ::close(pipe_ends[0]);
    if (number.empty()) throw std::runtime_error("Xvfb does not start; it is in cmake/debian-packages.txt");
    name_ = ":" + number;
    ::setenv("DISPLAY", name_.c_str(), 1);
}

VirtualDisplay::~VirtualDisplay()
{
    ::unsetenv("DISPLAY");
    if (server_ <= 0) return;
    ::kill(server_, SIGTERM);
    ::waitpid(server_, nullptr, 0);
}

}  // namespace kerf::test
