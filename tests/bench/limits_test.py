"""What the page says against the half-edge back end, and what else it says in words."""

import unittest

from report_cases import repeated, some_measurements, whole_measurements
from report.chapters import all_sections, chains, limits, models, peers, proxies, unflattering
from report.chapters.section import Facts, ShownTable, all_tables
from report.measurements import Measurements


class Limits(unittest.TestCase):
    FOUND = whole_measurements()

    def test_what_weighs_most_comes_first(self):
        section, = limits.write(self.FOUND, {}, Facts())
        heads = [part.split(".**")[0].lstrip("*") for part in section.parts]
        self.assertEqual(heads, ["Small meshes", "The report's models", "Memory", "Preparing",
                                 "The worst cut and the worst frame",
                                 "Draw calls", "Flat faces in the plane's direction", "Connected pieces", "Licence"])

    def test_nothing_measured_limits_nothing(self):
        section, = limits.write(Measurements(), {}, Facts())
        self.assertEqual(section.parts, [])

    def test_the_longer_worst_frame_is_admitted(self):
        self.assertIn("Of 2 models it has the longer worst frame in 2, and without drawing, as with a graphics card, in 0.",
                      unflattering.frames(self.FOUND, Facts()))

    def test_a_worse_tail_and_a_worse_chain_are_admitted_and_better_ones_are_not_named(self):
        self.assertIn("10.0 ms against 1.00 at 100 k", unflattering.tail(self.FOUND, Facts()))
        self.assertIn("one takes 10.0 ms at 100 k triangles (`remap`'s worst: 1.00 ms)", unflattering.longest(self.FOUND, Facts()))
        self.assertEqual(unflattering.tail(some_measurements(), Facts()), "")
        self.assertEqual(unflattering.longest(some_measurements(), Facts()), "")

    def test_meshes_that_a_linear_method_cuts_faster_are_named(self):
        found = some_measurements()
        for kind, half, linear in (("Real", 2.0, 1.0), ("RealChain", 3.0, 4.0)):
            for backend, ms in (("halfedge", half), ("linear", linear)):
                found.bench[f"{kind}/{backend}/wall"] = repeated(real_time=ms, triangles=100.0, ns_per_crossing=1.0,
                                                                 crossing=10.0, cuts_each=1.0)
        said = limits.long_sections(found, Facts())
        self.assertIn("wall, cut(): 2.0 against 1.00 ms", said)
        self.assertNotIn("whole chain", said)
        self.assertNotIn("fans", said)
        found.bench["Real/baseline/remap/wall"] = repeated(real_time=0.5, triangles=100.0, ns_per_crossing=1.0, crossing=10.0,
                                                           cuts_each=1.0)
        self.assertIn("`remap` is faster in cut() of wall, by fans", limits.long_sections(found, Facts()))
        self.assertEqual(limits.long_sections(some_measurements(), Facts()), "")

    def test_a_crossover_that_there_is_not_is_said(self):
        self.assertEqual(limits.words({"from_triangles": None}, Facts()), "nowhere that was measured")

    def test_small_models_are_where_it_is_not_the_fastest(self):
        self.assertIn("it takes 2.0 times what `remap` takes (medians 2000 and 1000 µs)",
                      models.small_models(self.FOUND, Facts()))
        self.assertIn("takes 4.0 times as long", models.lookup_factors(self.FOUND, Facts()))
        self.assertEqual(models.lookup_factors(some_measurements(), Facts()), "")


class Chapters(unittest.TestCase):
    FOUND = whole_measurements()

    def test_the_worst_of_a_thousand_cuts_is_named(self):
        found = some_measurements()
        found.bench["Chain/kept/halfedge/asteroid/100000"] = repeated(
            triangles=100_000, worst_ms_1=3.0, worst_ms_1000=2.0, worst_to_predicted=1.75, worst_to_predicted_at=7, chains=5)
        table = chains.long_chains_table(found)
        self.assertEqual([(row["worst_cut_ms"], row["worst_at"]) for row in table.rows], [(3.0, 7)])
        self.assertIn("none costs more than 1.75 times", chains.smooth(table, Facts()))
        self.assertNotIn("small meshes", chains.smooth(table, Facts()))
        table.rows.append({"backend": "halfedge", "mode": "kept", "triangles": 100.0, "worst_cut_ms": 1.25,
                           "worst_to_predicted": 30.0})
        self.assertIn("at 100 triangles one cut costs 30 times that, 1.25 ms", chains.smooth(table, Facts()))
        self.assertEqual(chains.smooth(chains.long_chains_table(some_measurements()), Facts()), "")

    def test_a_compacted_chain_says_what_compacting_cost(self):
        table = next(part.table for part in chains.write(self.FOUND, {}, Facts())[0].parts
                     if isinstance(part, ShownTable) and part.table.name == "chain_decades")
        self.assertIn("5 at 100 k triangles (1 ms)", chains.compacted(table, Facts()))
        self.assertEqual(chains.dearer(table, Facts()), "")  # `remap` does not get dearer here

    def test_boxes_that_cost_more_than_hulls_are_explained(self):
        table = next(part.table for part in proxies.write(self.FOUND, {}, Facts())[0].parts
                     if isinstance(part, ShownTable))
        self.assertIn("7 and 7 pairs touch, 7 of bounded hulls", proxies.pairs(table, Facts()))

    def test_libraries_have_a_chapter_only_if_they_were_timed(self):
        self.assertEqual(peers.write(some_measurements(), {}, Facts()), [])
        self.assertIn("at most 4.0", " ".join(part for part in peers.write(self.FOUND, {}, Facts())[0].parts
                                              if isinstance(part, str)))

    def test_all_of_them_together_name_each_table_once(self):
        facts = Facts()
        sections = all_sections(self.FOUND, {"processor": "p"}, facts)
        self.assertGreater(len(all_tables(sections, facts)), 20)
        self.assertEqual([section.slug for section in sections][:2], ["answer", "table2"])


if __name__ == "__main__":
    unittest.main()
