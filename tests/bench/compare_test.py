"""bench/compare times two revisions against each other."""

import importlib.machinery
import importlib.util
import subprocess
import sys
import unittest
from pathlib import Path

PROGRAM = Path(__file__).resolve().parents[2] / "bench/compare"


def load_program():
    """The program, whose name has no ending, as a module."""
    loader = importlib.machinery.SourceFileLoader("compare", str(PROGRAM))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader("compare", loader))
    loader.exec_module(module)
    return module


class Revisions(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.compare = load_program()

    def test_the_interval_of_a_median_holds_the_stated_share(self):
        # n = 11: below the true median at most 1 of 11 with probability 12/2048 < 2.5 %, at most 2 with 67/2048,
        # which is more.
        self.assertEqual(self.compare.median_interval(list(range(1, 12))), (6, 2, 10))
        self.assertEqual(self.compare.median_interval([1, 2, 3, 4, 5]), (3, None, None))
        self.assertEqual(self.compare.median_interval([6, 5, 4, 3, 2, 1]), (3.5, 1, 6))

    def test_what_chance_alone_does_follows_from_the_rounds(self):
        self.assertEqual(self.compare.values_outside(11), (2, 24 / 2048))
        self.assertEqual(self.compare.values_outside(5), (0, 0.0))

    def test_a_filter_that_matches_nothing_is_one_sentence(self):
        for program in ("/bin/true", "/no/such/program"):  # the harness writes nothing and ends well
            with self.assertRaises(self.compare.Failed):
                self.compare.run_once(program, "(", 0.1)

    def test_times_are_those_of_one_cut(self):
        self.assertEqual(self.compare.cuts_of({"name": "Scale/x", "real_time": 10.0, "cuts_each": 5}), 5)
        self.assertEqual(self.compare.cuts_of({"name": "Cut/x", "real_time": 10.0, "cut_ms": 1.0}), 10)
        self.assertEqual(self.compare.cuts_of({"name": "Recut/x", "real_time": 10.0, "cut_ms": 1.0}), 1)

    def test_rows_are_ratios_of_neighbouring_runs_and_counters_that_differ(self):
        runs = ([{"x": {"ms": ms, "touched": 5}} for ms in (1, 2, 4, 1, 2, 4)],
                [{"x": {"ms": 2 * ms, "touched": 6}} for ms in (1, 2, 4, 1, 2, 4)])
        row, = self.compare.rows_of(runs)
        self.assertEqual((row["ratio"], row["low"], row["high"]), (2, 2, 2))
        self.assertEqual(row["counters"], {"touched": (5, 6)})
        self.assertEqual(self.compare.verdict(row), "slower")

    def test_a_benchmark_that_b_lacks_is_an_error_and_one_that_only_b_has_is_none(self):
        one, two = {"x": {"ms": 1}}, {"x": {"ms": 1}, "y": {"ms": 1}}
        with self.assertRaisesRegex(self.compare.Failed, "B lacks 1 of A's benchmarks: y"):
            self.compare.rows_of(([two], [one]))
        self.assertEqual([row["benchmark"] for row in self.compare.rows_of(([one], [two]))], ["x"])

    def row(self, name, ratio, low, high):
        return {"benchmark": name, "ratio": ratio, "low": low, "high": high}

    def test_one_sentence_says_what_all_intervals_say(self):
        rows = [self.row("x", 1.05, 1.02, 1.08), self.row("y", 1.5, 1.2, 1.6), self.row("z", 1.0, 0.9, 1.1)]
        self.assertEqual(self.compare.closing_sentence(rows, "old", "new", 11),
                         "Of 3 benchmarks new is slower in 2 (most in y, by 50.0 %) and faster in none than old; "
                         "in 1 no difference can be told (by chance alone 0.035 would differ).")
        too_few = self.compare.closing_sentence([self.row("x", 1.5, None, None)], "old", "new", 5)
        self.assertIn("nothing can be said", too_few)

    def test_a_revision_that_does_not_exist_is_one_sentence(self):
        done = subprocess.run([sys.executable, "-B", str(PROGRAM), "no-such-revision", "HEAD"], capture_output=True,
                              text=True, check=False)
        self.assertEqual((done.returncode, done.stdout), (1, ""))
        self.assertEqual(done.stderr, "compare: there is no commit 'no-such-revision' in this repository\n")

    def test_the_fixed_set_has_both_back_ends_each_kind_and_small_and_large_meshes(self):
        names = [f"{kind}/{backend}/{mesh}/manual_time" for kind, mesh in (
            ("Cut", "cube"), ("Cut", "rook"), ("Scale", "asteroid/1000"), ("Scale", "asteroid/1000000"),
            ("Geometry", "asteroid/100000"), ("Prepare", "rook"), ("Prepare", "asteroid/1000000"))
            for backend in ("baseline/remap", "halfedge")]
        for name in names:
            self.assertRegex(name, self.compare.BENCHMARKS)
        self.assertNotRegex("Cut/baseline/scan/rook/manual_time", self.compare.BENCHMARKS)


if __name__ == "__main__":
    unittest.main()
