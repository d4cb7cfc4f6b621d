"""Tables of what happens to pieces: chains of cuts, proxies, many cuts; other libraries; and what was run."""

import unittest

from report_cases import whole_measurements
from report.names import BACKENDS
from report.tables.chain_tables import chain_decades_table, chains_table
from report.tables.distribution_tables import distribution_table, viewer_cuts_table, viewer_distribution_table
from report.tables.peer_tables import peers_by_mesh_table, peers_table, problem_of
from report.tables.proxy_tables import proxies_table, swipes_table
from report.tables.run_tables import numbers_table, stages_table

FOUND = whole_measurements()


class Chains(unittest.TestCase):
    def test_the_worst_cut_is_set_beside_the_mean(self):
        rows = {row["backend"]: row for row in chains_table(FOUND).rows}
        self.assertAlmostEqual(rows["halfedge"]["worst_to_mean"], 5.0)
        self.assertEqual(rows["halfedge"]["chains"], 5 * 3)  # five an iteration, three repetitions

    def test_draw_ranges_are_those_of_a_piece(self):
        rows = {(row["backend"], row["mode"], row["cuts"]): row for row in chain_decades_table(FOUND).rows}
        self.assertEqual(len(rows), 3 * 3)
        self.assertEqual(rows[("halfedge", "kept", 100)]["ranges_per_piece"], 10.0)
        self.assertEqual(rows[("halfedge", "compacted", 1000)]["compactions"], 5)


class Proxies(unittest.TestCase):
    def test_a_proxy_is_a_row_with_medians_over_the_models(self):
        rows = {row["kind"]: row for row in proxies_table(FOUND).rows}
        hull = rows["bounded_hull"]
        self.assertEqual((hull["build_ms"], hull["points"], hull["volume_ratio"], hull["halfedge_build_ms"]),
                         (0.3, 3, 1.5, 0.05))
        self.assertEqual((rows["box"]["frame_ms"], rows["box"]["touching_pairs"]), (9.0, 7))

    def test_swipes_and_frames_of_physics_are_what_the_simulation_costs(self):
        self.assertEqual([(row["what"], row["size"]) for row in swipes_table(FOUND).rows],
                         [("swipe", 100_000), ("swipe", 100_000), ("frame of physics, pieces in a heap", 300)])


class Distributions(unittest.TestCase):
    def test_quantiles_of_many_cuts_are_taken_as_they_were_measured(self):
        row = distribution_table(FOUND).rows[-1]
        self.assertEqual((row["backend"], row["cuts"], row["p50_ms"], row["worst_ms"], row["over_frame"]),
                         ("halfedge", 200, 1.0, 10.0, 1))

    def test_the_viewers_cuts_are_counted_by_back_end_and_the_worst_is_named(self):
        rows = {(row["models"], row["backend"]): row for row in viewer_distribution_table(FOUND).rows}
        row = rows[("the report's", "halfedge")]
        self.assertEqual((row["cuts"], row["median_ms"], row["worst_ms"], row["over_frame"], row["worst_model"]),
                         (3, 14, 140, 1, "rook"))
        self.assertEqual(len(viewer_cuts_table(FOUND).rows), 2 * len(BACKENDS) * 3)


class Peers(unittest.TestCase):
    def test_what_is_not_right_is_said_and_a_split_is_no_wrong_answer(self):
        problems = {row["cutter"]: problem_of(row) for row in peers_table(FOUND).rows}
        self.assertEqual(problems["cgal_clip"], "volumes do not add up")
        self.assertEqual(problems["cgal_split"], "")
        self.assertEqual(problems["halfedge"], "")

    def test_a_mesh_is_a_row_with_the_back_ends_first(self):
        table = peers_by_mesh_table(FOUND)
        self.assertEqual([column.title for column in table.columns],
                         ["mesh", "triangles", "remap", "halfedge", "cgal clip", "cgal split", "not right"])
        row = next(row for row in table.rows if row["shape"] == "asteroid" and row["triangles"] == 1_000)
        self.assertEqual((row["cgal_clip_ms"], row["not_right"]), (3.0, "cgal_clip: volumes do not add up"))


class Runs(unittest.TestCase):
    def test_a_stage_is_a_row_with_the_load_around_it(self):
        row, = stages_table(FOUND).rows
        self.assertEqual((row["stage"], row["repetitions"], row["load_before"], row["load_after"]),
                         ("cuts", 3, 0.5, 1.0))

    def test_every_counter_is_a_row_but_the_harness_own(self):
        counters = {row["counter"] for row in numbers_table(FOUND).rows}
        self.assertIn("cut_ms", counters)
        self.assertNotIn("repetitions", counters)


if __name__ == "__main__":
    unittest.main()
