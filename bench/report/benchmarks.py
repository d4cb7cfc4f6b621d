"""Runs kerf_bench and reads the JSON that it writes."""

import subprocess
import tempfile
from pathlib import Path
from typing import Any, Callable

from report import files

Listener = Callable[[int, int, str], None]  # is told how many benchmarks of how many are done, and the last one's name


class BenchmarkFailed(Exception):
    """The program failed; the text says how."""


def names_matching(program: Path, pattern: str) -> list[str]:
    """The names of the benchmarks that a pattern matches."""
    done = subprocess.run([program, "--benchmark_list_tests", f"--benchmark_filter={pattern}"], capture_output=True,
                          text=True, check=False)
    if done.returncode != 0:
        raise BenchmarkFailed(f"{program} failed with exit status {done.returncode}:\n{done.stderr.strip()}")
    return done.stdout.splitlines()


def run_benchmarks(program: Path, pattern: str, repetitions: str, min_time: str, listener: Listener, out: Path) -> Any:
    """The harness's JSON, which the program writes to `out`. The program is killed when this is interrupted, so that
    nothing goes on in the background. Raises BenchmarkFailed."""
    names = names_matching(program, pattern)
    command = [str(program), f"--benchmark_filter={pattern}", f"--benchmark_repetitions={repetitions}",
               f"--benchmark_min_time={min_time}", "--benchmark_enable_random_interleaving=false",
               f"--benchmark_out={out}", "--benchmark_out_format=json"]
    # The harness writes its context to the standard error: it is shown only when something fails.
    with tempfile.TemporaryFile("w+") as messages:
        with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=messages, text=True) as process:
            try:
                done = follow(process, names, listener)
                process.wait()
            finally:
                process.kill()
        if process.returncode != 0 or done != len(names):
            messages.seek(0)
            raise BenchmarkFailed(f"{program} failed with exit status {process.returncode}:\n{messages.read().strip()}")
    return files.read_json(out)


def follow(process: subprocess.Popen[str], names: list[str], listener: Listener) -> int:
    """Reads what the program prints, and tells the listener; gives the number of benchmarks that were seen."""
    assert process.stdout is not None
    seen: set[str] = set()
    for line in process.stdout:
        name = next(iter(line.split(maxsplit=1)), "")
        if name in names and name not in seen:
            seen.add(name)
            listener(len(seen), len(names), name.removesuffix("/manual_time"))
    return len(seen)
