"""Preparing, and when it is paid back."""

import unittest

from report_cases import some_measurements
from report.chapters.prepare import against_fans, chain_turn, turn_text
from report.chapters.section import Facts
from report.tables.prepare_tables import (chain_balance_table, choice_table, from_arrays_table, prepare_table,
                                           prepare_threads_table, signed_milliseconds)


class Preparing(unittest.TestCase):
    def test_a_chain_pays_back_where_its_balance_turns_for_good(self):
        rows = [{"cuts": cuts, "balance_ms": ms} for cuts,
                ms in ((1, -5.0), (10, 1.0), (100, -1.0), (300, 2.0), (1000, 9.0))]
        self.assertEqual(chain_turn(rows, "balance_ms"), (100, 300))
        self.assertIsNone(chain_turn(rows[:3], "balance_ms"))
        self.assertEqual(chain_turn(rows[3:], "balance_ms"), (0, 300))

    def test_when_it_is_paid_back_is_said_in_words(self):
        self.assertEqual(turn_text("x", None, 1000, Facts()), "not paid back within 1000 cuts")
        self.assertEqual(turn_text("x", (0, 1), 1000, Facts()), "paid back by the first cut")
        self.assertEqual(turn_text("x", (100, 300), 1000, Facts()), "paid back between 100 and 300 cuts")

    def measured(self):
        found = some_measurements()
        for backend, ms in (("baseline/remap", 10.0), ("halfedge", 100.0)):
            counters = {"real_time": ms, "ns_per_triangle": 1.0, "bytes_per_triangle": 1.0, "repetitions": 3}
            found.bench[f"Prepare/{backend}/asteroid/100000"] = {key: (value,) * 3 for key, value in counters.items()}
        return found

    def test_copies_pay_back_what_quicker_cuts_save(self):
        half = next(row for row in prepare_table(self.measured()).rows if row["backend"] == "halfedge")
        saved = 100_000 / 1000 - 100_000**0.5 / 10  # ms a cut
        self.assertAlmostEqual(half["paid_back_remap"], 90.0 / saved)

    def test_a_balance_is_what_cuts_have_saved_less_what_preparing_cost_more(self):
        found = self.measured()
        for backend, ms in (("baseline/remap", 130.0), ("halfedge", 30.0)):
            counters = {"triangles": 99_372, "whole_ms_10": ms, "cutting_ms_10": ms / 2}
            found.bench[f"Chain/kept/{backend}/asteroid/100000"] = {key: (value,) * 3 for key,
                                                                    value in counters.items()}
        row, = chain_balance_table(found).rows
        self.assertEqual((row["balance_ms"], row["cutting_balance_ms"]), (10.0, -40.0))
        self.assertNotIn("balance_on_two_ms", row)
        found.bench["PrepareThreads/2/halfedge/asteroid/100000"] = {"real_time": (50.0,) * 3}
        row, = chain_balance_table(found).rows
        self.assertEqual((row["extra_on_two_ms"], row["balance_on_two_ms"], row["cutting_balance_on_two_ms"]),
                         (40.0, 60.0, 10.0))
        self.assertEqual((row["balance_ms"], row["cutting_balance_ms"]), (10.0, -40.0))

    def test_a_choice_is_judged_for_each_number_of_cuts(self):
        found = self.measured()
        for name, triangles, ratios in (("asteroid/1000", 1_012, (1.0, 1.25)), ("model/cube", 12, (1.5, 1.0))):
            counters = {"triangles": triangles, "to_better_1": ratios[0], "to_better_20": ratios[1],
                        "worst_to_better": max(ratios)}
            found.bench[f"Automatic/{name}"] = {key: (value,) * 3 for key, value in counters.items()}
        self.assertEqual(against_fans(choice_table(found), Facts()), "")
        found.bench["Automatic/model/cube"]["worst_to_best"] = (1.75,) * 3
        self.assertIn("would be 1.75 at most (cube)", against_fans(choice_table(found), Facts()))
        cube, asteroid = choice_table(found).rows
        self.assertEqual((cube["mesh"], cube["cuts_1"], cube["cuts_20"], cube["worst"]), ("cube", 1.5, 1.0, 1.5))
        self.assertEqual((asteroid["mesh"], asteroid["triangles"], asteroid["worst"]), ("asteroid", 1_012, 1.25))

    def test_two_threads_are_compared_with_one_and_arrays_are_listed(self):
        found = self.measured()
        for threads, ms in ((1, 80.0), (2, 50.0)):
            found.bench[f"PrepareThreads/{threads}/halfedge/asteroid/100000"] = {"real_time": (ms,) * 3}
        for backend in ("baseline/hash", "linear", "halfedge"):
            counters = {"make_ms": 3.0, "prepare_ms": 7.0, "ns_per_triangle": 100.0, "real_time": 10.0,
                        "repetitions": 3}
            found.bench[f"FromArrays/{backend}/asteroid/100000"] = {key: (value,) * 3 for key, value in counters.items()}
        row, = prepare_threads_table(found).rows
        self.assertEqual((row["one_ms"], row["two_ms"], row["two_to_one"]), (80.0, 50.0, 0.625))
        self.assertEqual([row["backend"] for row in from_arrays_table(found).rows], ["linear", "halfedge"])

    def test_a_balance_has_a_sign(self):
        self.assertEqual([signed_milliseconds(ms)[0] for ms in (2.5, -2.5, 0.0)], ["+", "−", "0"])


if __name__ == "__main__":
    unittest.main()
