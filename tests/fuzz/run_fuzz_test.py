"""`./run fuzz`, given a program in place of the fuzzers that takes no time."""

import contextlib
import io
import pathlib
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))

import run_fuzz  # noqa: E402  (found through the line above)

# Three fuzzers: two meet, which they can only if they run at the same time; one finds something.
PROGRAM = """#!/bin/sh
here=$(dirname "$0")
case $1 in
    --list) printf 'left 10\\nright 10\\nfinder 10\\n' ;;
    --fuzzer=left | --fuzzer=right)
        name=${1#--fuzzer=}
        touch "$here/began_$name"
        tries=0
        while [ $tries -lt 100 ] && ! { [ -e "$here/began_left" ] && [ -e "$here/began_right" ]; }; do
            sleep 0.05
            tries=$((tries + 1))
        done
        [ $tries -lt 100 ] || exit 1
        echo 'stat::number_of_executed_units: 42' ;;
    --fuzzer=finder)
        for word in "$@"; do
            case $word in
                -artifact_prefix=*) echo wrong > "${word#-artifact_prefix=}crash-1" ;;
                -exact_artifact_path=*) echo w > "${word#-exact_artifact_path=}" ;;
            esac
        done
        echo 'broken promise: it is right'
        exit 77 ;;
esac
"""


class RunFuzz(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        run_fuzz.PROGRAM = self.folder / "kerf_fuzz"
        run_fuzz.PROGRAM.write_text(PROGRAM)
        run_fuzz.PROGRAM.chmod(0o755)
        run_fuzz.CORPUS, run_fuzz.FINDINGS = self.folder / "corpus", self.folder / "findings"

    def run_with(self, *arguments):
        """Exit status and lines of standard output."""
        before, sys.argv = sys.argv, ["run_fuzz.py", *arguments]
        try:
            with contextlib.redirect_stdout(io.StringIO()) as out:
                status = run_fuzz.main()
        finally:
            sys.argv = before
        return status, out.getvalue().splitlines()

    def test_runs_as_many_at_once_as_there_are_jobs_and_says_when_each_begins_and_ends(self):
        status, lines = self.run_with("left", "right", "--jobs", "2", "--seconds", "3")
        self.assertEqual(status, 0)
        self.assertEqual(sorted(lines[:2]), ["left: 3 s", "right: 3 s"])
        self.assertEqual(len(lines), 4)
        for line in lines[2:]:
            self.assertRegex(line, r"^(left|right): clean after 42 inputs, \d+ s of processor time$")

    def test_runs_the_others_after_a_finding_and_keeps_it_together_with_its_lines(self):
        for jobs in ("1", "3"):
            with self.subTest(jobs=jobs):
                (self.folder / "began_left").touch()
                (self.folder / "began_right").touch()
                for old in (run_fuzz.FINDINGS / "finder").glob("*"):
                    old.unlink()
                status, lines = self.run_with("finder", "left", "right", "--jobs", jobs)
                self.assertEqual(status, 1)
                self.assertEqual(sum(": clean after" in line for line in lines), 2)
                at = lines.index("finder: broken promise: it is right")
                self.assertEqual(lines[at + 1], f"  the log: {run_fuzz.FINDINGS}/finder.log")
                self.assertRegex(lines[at + 2], r"^  to repeat it:  .*/crash-1\.min$")
                self.assertRegex(lines[at + 3], r"^  to keep it:    cp .*/crash-1\.min tests/fuzz/seeds/finder/CAUSE_")

    def test_runs_a_fuzzer_that_is_named_twice_once(self):
        (self.folder / "began_right").touch()
        status, lines = self.run_with("left", "left", "--jobs", "2")
        self.assertEqual((status, len(lines)), (0, 2))

    def test_refuses_numbers_of_jobs_and_seconds_that_make_no_sense(self):
        for arguments in (("--jobs", "0"), ("--jobs", "two"), ("--seconds", "-1")):
            with self.subTest(arguments=arguments), contextlib.redirect_stderr(io.StringIO()):
                with self.assertRaises(SystemExit) as refused:
                    self.run_with("left", *arguments)
                self.assertEqual(refused.exception.code, 2)


if __name__ == "__main__":
    unittest.main()
