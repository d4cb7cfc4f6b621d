"""The report's tables, ours beside them."""

import unittest

from report_cases import whole_measurements
from report.measurements import Measurements
from report.tables.model_tables import (cuts_table, frames_table, hulls_table, model_exponents_table, sizes_table,
                                        worst_frames_table)


class ModelTables(unittest.TestCase):
    FOUND = whole_measurements()

    def row(self, table, model):
        return next(row for row in table.rows if row["model"] == model)

    def test_our_models_stand_beside_the_reports(self):
        row = self.row(sizes_table(self.FOUND), "rook")
        self.assertEqual((row["report_faces"], row["faces"], row["report_vertices"]), (926, 926, 1790))

    def test_what_was_not_measured_is_absent(self):
        self.assertIsNone(self.row(sizes_table(Measurements()), "rook")["faces"])
        self.assertEqual(worst_frames_table(Measurements()).rows, [])

    def test_a_cut_has_a_column_for_each_back_end_the_half_edge_first(self):
        table = cuts_table(self.FOUND)
        self.assertEqual([column.title for column in table.columns][:4], ["model", "report", "halfedge", "remap"])
        row = self.row(table, "rook")
        self.assertEqual((row["halfedge_ms"], row["baseline/remap_ms"], row["planes"], row["repetitions"]),
                         (2.0, 1.0, 10, 3))
        self.assertAlmostEqual(row["spread"], 0.2)

    def test_hulls_name_the_points_of_those_that_have_any(self):
        row = self.row(hulls_table(self.FOUND), "rook")
        self.assertEqual((row["report_hull_ms"], row["every_vertex_ms"], row["halfedge_bounded_hull_ms"]),
                         (10.985, 0.1, 0.05))
        self.assertEqual((row["full_hull_points"], row["bounded_hull_points"]), (2, 3))

    def test_frames_per_second_are_those_of_the_median_and_the_longest_frame(self):
        row = frames_table(self.FOUND).rows[0]
        self.assertEqual((row["model"], row["backend"], row["report_fps"], row["cuts"]),
                         ("rook", "halfedge", "60-56", 3))
        self.assertEqual((row["fps_median"], row["fps_least"], row["simulate_most_ms"]), (1000 / 70, 1000 / 140, 140.0))

    def test_the_asteroid_is_no_model_of_the_report(self):
        self.assertIsNone(self.row(frames_table(self.FOUND), "asteroid")["report_fps"])
        self.assertEqual(self.row(worst_frames_table(self.FOUND), "asteroid")["halfedge_ms"], 140.0)

    def test_frames_that_are_not_drawn_have_columns_of_their_own(self):
        table = worst_frames_table(self.FOUND)
        self.assertEqual([column.title for column in table.columns][:3],
                         ["model", "halfedge, not drawn", "remap, not drawn"])
        row = self.row(table, "rook")
        self.assertEqual((row["halfedge_undrawn_ms"], row["baseline/remap_undrawn_ms"], row["halfedge_ms"]),
                         (1.0, 2.0, 140.0))
        self.assertNotIn("halfedge_undrawn_ms", self.row(table, "asteroid"))

    def test_times_that_do_not_grow_have_an_exponent_of_0_with_any_model_left_out(self):
        row = next(row for row in model_exponents_table(self.FOUND).rows if row["times"] == "halfedge")
        for key in ("exponent", "least", "most"):
            self.assertAlmostEqual(row[key], 0.0)
        self.assertEqual(row["models"], 15)


if __name__ == "__main__":
    unittest.main()
