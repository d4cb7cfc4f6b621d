"""Medians and spreads of repeated benchmarks."""

import unittest

from report.repetitions import WrongResult, collect, median, spread_of, worst_spread


class Repetitions(unittest.TestCase):
    RUN = {"run_type": "iteration", "name": "Cut/halfedge/rook/manual_time"}

    def test_the_median_of_repetitions_is_taken_with_the_least_and_the_greatest(self):
        table = collect([self.RUN | {"real_time": ms} for ms in (3.0, 1.0, 2.0)])
        self.assertEqual(table["Cut/halfedge/rook"]["real_time"], (2.0, 1.0, 3.0))
        self.assertEqual(table["Cut/halfedge/rook"]["repetitions"], (3, 3, 3))

    def test_a_wrong_result_stops_everything_and_is_named(self):
        with self.assertRaisesRegex(WrongResult, "Cut/halfedge/rook .*a side is not closed"):
            collect([self.RUN | {"error_occurred": True, "error_message": "a side is not closed"}])

    def test_times_are_those_of_one_cut_if_a_round_is_timed(self):
        table = collect([self.RUN | {"cuts_each": 5, "real_time": ms} for ms in (5.0, 10.0)])
        self.assertEqual(table["Cut/halfedge/rook"]["real_time"], (1.5, 1.0, 2.0))

    def test_what_the_harness_sums_up_itself_is_left_out(self):
        self.assertEqual(collect([{"run_type": "aggregate", "name": "Cut/halfedge/rook/manual_time_mean",
                                   "real_time": 1.0}]), {})

    def test_iterations_are_no_part_of_a_name(self):
        self.assertEqual(list(collect([self.RUN | {"name": "Many/x/1000/iterations:1/manual_time", "real_time": 1.0}])),
                         ["Many/x/1000"])

    def test_a_spread_needs_two_runs_and_a_median(self):
        counters = {"ms": (2.0, 1.0, 4.0), "zero": (0.0, 0.0, 0.0), "repetitions": (3, 3, 3)}
        self.assertEqual(spread_of(counters, "ms"), 1.5)
        for nothing in (None, counters | {"repetitions": (1, 1, 1)}):
            self.assertIsNone(spread_of(nothing, "ms"))
        self.assertIsNone(spread_of(counters, "zero"))
        self.assertEqual(worst_spread([(None, "ms"), (counters, "ms"), (counters, "zero")]), 1.5)
        self.assertIsNone(worst_spread([]))

    def test_a_counter_that_is_not_there_has_no_median(self):
        self.assertIsNone(median(None, "ms"))
        self.assertIsNone(median({}, "ms"))
        self.assertEqual(median({"ms": (2.0, 1.0, 4.0)}, "ms"), 2.0)


if __name__ == "__main__":
    unittest.main()
