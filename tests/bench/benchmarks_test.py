"""kerf_bench is run, followed and read."""

import json
import tempfile
import unittest
from pathlib import Path

from report.benchmarks import BenchmarkFailed, names_matching, run_benchmarks


class Benchmarks(unittest.TestCase):
    """A program that lists two benchmarks and prints `LINES` when it runs them."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder, self.heard = Path(folder.name), []

    def run_program(self, lines, status=0):
        program = self.folder / "program"
        prints = "".join(f"echo '{line}'\n" for line in lines)
        program.write_text(f"""#!/bin/sh
case "$*" in *list_tests*) echo Cut/a/manual_time; echo Section/b; exit 0;; esac
for argument; do
    case "$argument" in --benchmark_out=*) echo '{json.dumps({"benchmarks": []})}' > "${{argument#*=}}";; esac
done
echo it is broken >&2
{prints}exit {status}
""")
        program.chmod(0o755)
        return run_benchmarks(program, "^Cut/", "3", "0.01", lambda *each: self.heard.append(each),
                              self.folder / "out.json")

    BOTH = ("Cut/a/manual_time 1 ms", "Cut/a/manual_time 1 ms", "Section/b 1 ms", "Section/b_mean 1 ms")

    def test_the_listener_hears_of_each_benchmark_once(self):
        self.assertEqual(self.run_program(self.BOTH), {"benchmarks": []})
        self.assertEqual(self.heard, [(1, 2, "Cut/a"), (2, 2, "Section/b")])

    def test_a_failure_is_told_with_what_the_program_said(self):
        with self.assertRaisesRegex(BenchmarkFailed, "exit status 3:\nit is broken"):
            self.run_program(self.BOTH, status=3)

    def test_a_program_that_ends_early_has_failed(self):
        with self.assertRaises(BenchmarkFailed):
            self.run_program(self.BOTH[:1])

    def test_a_pattern_that_is_none_is_a_failure(self):
        with self.assertRaisesRegex(BenchmarkFailed, "exit status 1"):
            names_matching(Path("/bin/false"), "(")


if __name__ == "__main__":
    unittest.main()
