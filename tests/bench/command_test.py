"""The command line of the report: `python3 -m report`."""

import json
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

BENCH = Path(__file__).resolve().parents[2] / "bench"


class CommandLine(unittest.TestCase):
    def report(self, *arguments):
        return subprocess.run([sys.executable, "-B", "-m", "report", *arguments], capture_output=True, text=True,
                              check=False,
                              cwd=self.folder, env=os.environ | {"PYTHONPATH": str(BENCH)})

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def run_of(self, *benchmarks):
        """A file as `--text` keeps it, beside the caller."""
        (self.folder / "run.json").write_text(json.dumps(
            {"context": {"num_cpus": 2, "load_avg": [0.5], "date": "2024-02-29T12:00:00"},
             "benchmarks": [{"run_type": "iteration", "repetitions": 1, "iterations": 1} | each
                            for each in benchmarks]}))
        return "run.json"

    def test_an_earlier_run_is_shown_as_text(self):
        cut = {"name": "Cut/halfedge/rook/manual_time", "real_time": 1.0, "cut_ms": 0.126, "triangles": 926,
               "vertices": 1785}
        shown = self.report("--text", "--show", self.run_of(cut))
        self.assertEqual((shown.returncode, shown.stderr), (0, ""))
        self.assertRegex(shown.stdout, r"\nmodel +report +halfedge +repetitions\n")
        self.assertRegex(shown.stdout, r"\nrook +19\.6 +0\.1")
        self.assertIn("2 cores, load 0.50, 2024-02-29.", shown.stdout)

    def test_a_wrong_result_and_a_file_that_is_none_are_one_sentence_and_status_1(self):
        wrong = self.run_of({"name": "Cut/halfedge/rook/manual_time", "error_occurred": True,
                             "error_message": "a side is open"})
        (self.folder / "no.json").write_text("[1")
        for file, sentence in ((wrong, "Cut/halfedge/rook was not timed because its result is wrong: a side is open"),
                               ("gone.json", "gone.json holds no benchmarks: No such file or directory"),
                               ("no.json", "no.json holds no benchmarks: it is not the JSON of a run")):
            shown = self.report("--text", "--show", file)
            self.assertEqual((shown.returncode, shown.stdout), (1, ""), file)
            self.assertIn(sentence, shown.stderr)
            self.assertNotIn("Traceback", shown.stderr)

    def test_programs_that_are_not_built_are_named(self):
        for arguments in ((), ("--text",)):
            shown = self.report("--programs", "no/such/build", *arguments)
            self.assertEqual(shown.returncode, 1)
            self.assertRegex(shown.stderr, r"^report: no/such/build/bench/kerf_bench is not there; `\./run \w+` .*\n$")

    def test_wrong_use_is_status_2(self):
        self.assertEqual(self.report("--quick", "--full").returncode, 2)


if __name__ == "__main__":
    unittest.main()
