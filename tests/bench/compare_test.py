"""bench/compare times two revisions against each other."""

import importlib.machinery
import importlib.util
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
        # n = 11: below the true median at most 1 of 11 with probability 12/2048 < 2.5 %, at most 2 with 67/2048 > 2.5 %.
        self.assertEqual(self.compare.median_interval(list(range(1, 12))), (6, 2, 10))
        self.assertEqual(self.compare.median_interval([1, 2, 3, 4, 5]), (3, None, None))
        self.assertEqual(self.compare.median_interval([6, 5, 4, 3, 2, 1]), (3.5, 1, 6))

    def test_a_filter_that_matches_nothing_is_one_sentence(self):
        for program in ("/bin/true", "/no/such/program"):  # the harness writes nothing and ends well
            with self.assertRaises(self.compare.Failed):
                self.compare.run_once(program, "(", 0.1)

    def test_times_are_those_of_one_cut(self):
        self.assertEqual(self.compare.cuts_of({"name": "Scale/x", "real_time": 10.0, "cuts_each": 5}), 5)
        self.assertEqual(self.compare.cuts_of({"name": "Cut/x", "real_time": 10.0, "cut_ms": 1.0}), 10)
        self.assertEqual(self.compare.cuts_of({"name": "Recut/x", "real_time": 10.0, "cut_ms": 1.0}), 1)

    def test_rows_are_ratios_of_neighbouring_runs_and_counters_that_differ(self):
        runs = ([{"x": {"ms": ms, "touched": 5}} for ms in (1, 2, 4, 1, 2, 4)], [{"x": {"ms": 2 * ms, "touched": 6}} for ms in (1, 2, 4, 1, 2, 4)])
        row, = self.compare.rows_of(runs)
        self.assertEqual((row["ratio"], row["low"], row["high"]), (2, 2, 2))
        self.assertEqual(row["counters"], {"touched": (5, 6)})
        self.assertEqual(self.compare.verdict(row), "slower")


if __name__ == "__main__":
    unittest.main()
