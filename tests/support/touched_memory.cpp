#include "support/touched_memory.h"

#include <fstream>
#include <string>

#ifdef __linux__
#include <sys/prctl.h>
#include <sys/resource.h>
#endif

namespace kerf::test {

void use_small_pages()
{
#ifdef __linux__
    static_cast<void>(prctl(PR_SET_THP_DISABLE, 1, 0, 0, 0));
#endif
}

bool forget_touched_memory()
{
    std::ofstream file("/proc/self/clear_refs");
    file << "1" << std::flush;
    return file.good();
}

std::optional<std::size_t> touched_memory()
{
    std::ifstream file("/proc/self/smaps_rollup");
    for (std::string word; file >> word;)
        if (std::size_t kilobytes = 0; word == "Referenced:" && file >> kilobytes) return 1024 * kilobytes;
    return std::nullopt;
}

std::size_t page_faults()
{
#ifdef __linux__
    rusage usage{};
    getrusage(RUSAGE_THREAD, &usage);
    return static_cast<std::size_t>(usage.ru_minflt);
#else
    return 0;
#endif
}

}  // namespace kerf::test
