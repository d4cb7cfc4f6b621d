// kerf_bench: every time that Kerf claims. `./run bench` runs it and prints the tables; by hand:
//   kerf_bench --benchmark_filter='Scale/.*/asteroid/1000000' --benchmark_repetitions=5

#include <benchmark/benchmark.h>
#include <malloc.h>

#include <exception>
#include <iostream>

namespace kerf::bench {
void register_model_benchmarks();
void register_arrays_benchmarks();
void register_automatic_benchmarks();
void register_scale_benchmarks();
void register_chain_benchmarks();
void register_long_benchmarks();
void register_hard_benchmarks();
void register_real_benchmarks();
void register_section_benchmarks();
void register_stack_benchmarks();
void register_fracture_benchmarks();
#ifdef KERF_HAS_VIEWER
void register_sim_benchmarks();
#endif
}  // namespace kerf::bench

int main(int argc, char** argv)
{
    // A game's allocator keeps its memory. With glibc's defaults every large buffer of every cut is mapped afresh and
    // the kernel clears it page by page inside the timed region: that would charge the linear back ends for the
    // allocator.
    mallopt(M_MMAP_THRESHOLD, 1 << 30);
    mallopt(M_TRIM_THRESHOLD, 1 << 30);
    mallopt(M_TOP_PAD, 64 << 20);
    try {
        kerf::bench::register_model_benchmarks();
        kerf::bench::register_arrays_benchmarks();
        kerf::bench::register_automatic_benchmarks();
        kerf::bench::register_scale_benchmarks();
        kerf::bench::register_chain_benchmarks();
        kerf::bench::register_long_benchmarks();
        kerf::bench::register_hard_benchmarks();
        kerf::bench::register_real_benchmarks();
        kerf::bench::register_section_benchmarks();
        kerf::bench::register_stack_benchmarks();
        kerf::bench::register_fracture_benchmarks();
#ifdef KERF_HAS_VIEWER
        kerf::bench::register_sim_benchmarks();
#endif
        benchmark::Initialize(&argc, argv);
        if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
        benchmark::RunSpecifiedBenchmarks();
        benchmark::Shutdown();
    } catch (const std::exception& error) {
        std::cerr << "kerf_bench: " << error.what() << '\n';
        return 1;
    }
}
