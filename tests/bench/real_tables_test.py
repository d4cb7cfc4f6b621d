"""Meshes that are not round, and the whole chain of the report's models."""

import unittest

from report_cases import repeated, whole_measurements
from report.chapters import limits, models, real
from report.chapters.section import Facts
from report.measurements import Measurements
from report.tables.real_tables import asteroid_ns, model_chains_table, real_cuts_table


def measured():
    """A mesh of 30 000 triangles that takes half-edges twice as long as an asteroid; models on which they win but one."""
    found = whole_measurements()
    for kind in ("Real", "RealChain"):
        for backend, ms in (("halfedge", 2.0), ("linear", 6.0), ("baseline/remap", 1.0)):
            found.bench[f"{kind}/{backend}/cheese"] = repeated(real_time=ms, triangles=30_000, crossing=500, cuts_each=5,
                                                              ns_per_crossing=2 * asteroid_ns(found, 30_000))
    for number, model in enumerate(("car", "cube", "rook")):
        found.bench[f"ModelChain/halfedge/{model}"] = repeated(real_time=1.0)
        found.bench[f"ModelChain/linear/{model}"] = repeated(real_time=1.5 if number else 0.5)
    return found


class RealTables(unittest.TestCase):
    FOUND = measured()

    def test_a_mesh_is_compared_with_an_asteroid_of_its_size(self):
        row, = real_cuts_table(self.FOUND).rows
        self.assertEqual((row["mesh"], row["halfedge_ms"], row["linear_ms"], row["halfedge/cgal_ms"]),
                         ("cheese", 2.0, 6.0, None))
        self.assertAlmostEqual(row["to_asteroid"], 2.0)

    def test_between_two_sizes_an_asteroid_costs_something_between(self):
        small, large = asteroid_ns(self.FOUND, 10_000), asteroid_ns(self.FOUND, 100_000)
        self.assertLessEqual(min(small, large), asteroid_ns(self.FOUND, 50_000))
        self.assertGreaterEqual(max(small, large), asteroid_ns(self.FOUND, 50_000))
        self.assertIsNone(asteroid_ns(self.FOUND, 10))

    def test_models_that_were_not_timed_have_no_row(self):
        self.assertEqual([row["model"] for row in model_chains_table(self.FOUND).rows], ["car", "cube", "rook"])


class RealChapter(unittest.TestCase):
    FOUND = measured()

    def test_it_says_how_far_the_worst_mesh_is_from_round(self):
        section, = real.write(self.FOUND, {}, Facts())
        said = " ".join(part for part in section.parts if isinstance(part, str))
        self.assertIn("at most 2.00 times", said)
        self.assertIn("faster than `linear` on 1 of 1, by a factor of up to 3.0 (cheese)", said)

    def test_it_is_there_only_if_such_meshes_were_cut(self):
        self.assertEqual(real.write(Measurements(), {}, Facts()), [])

    def test_models_are_judged_with_all_that_a_game_needs(self):
        self.assertIn("0.67 times what `linear` takes, and less on 2 of 3", models.whole_chain(self.FOUND, Facts()))
        self.assertEqual(models.whole_chain(whole_measurements(), Facts()), "")
        self.assertTrue(limits.models(self.FOUND, Facts()).endswith("is wanted."))


if __name__ == "__main__":
    unittest.main()
