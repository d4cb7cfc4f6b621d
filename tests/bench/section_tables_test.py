"""Sections of what stays whole: times of each, and what they are compared with."""

import unittest

from report.chapters import looking
from report.chapters.section import Facts
from report.measurements import Measurements
from report.tables.section_tables import real_sections_table, sections_table, slicers_table, stacks_table
from report_cases import whole_measurements


class SectionTables(unittest.TestCase):
    def setUp(self):
        self.found = whole_measurements()

    def test_times_are_those_of_one_section(self):
        rows = sections_table(self.found).rows
        self.assertEqual([row["triangles"] for row in rows], [10_000, 100_000, 1_000_000])
        for row in rows:
            self.assertAlmostEqual(row["loops_ms"], row["triangles"]**0.5 / 1000)
            self.assertAlmostEqual(row["to_cut"], 100)
            self.assertAlmostEqual(row["through_vertices_ms"], row["triangles"]**0.5 / 900)
            self.assertAlmostEqual(row["remap_ms"], row["triangles"] / 1000)

    def test_stacks_stand_beside_two_threads_and_the_loop_where_those_were_timed(self):
        rows = stacks_table(self.found).rows
        self.assertEqual([(row["triangles"], row["heights"]) for row in rows],
                         [(size, heights) for size in (10_000, 100_000, 1_000_000) for heights in (10, 1000)])
        del self.found.bench["StackThreads/2/halfedge/asteroid/10000/10"]
        first, second = stacks_table(self.found).rows[:2]
        self.assertIsNone(first["threads_ms"])
        self.assertAlmostEqual(second["threads_ms"], second["halfedge_ms"] / 2)
        self.assertAlmostEqual(second["each_us"], 100.0)

    def test_meshes_that_are_not_round_have_a_row_each(self):
        row, = real_sections_table(self.found).rows
        self.assertEqual((row["mesh"], row["halfedge_ms"], row["remap_ms"]), ("sponge", 1.0, 4.0))

    def test_libraries_are_compared_where_the_same_was_asked_for(self):
        rows = {(row["by"], row["heights"]): row for row in slicers_table(self.found).rows if row["triangles"] == 1_000_000}
        self.assertAlmostEqual(rows["cgal_slicer", 1]["to_halfedge"], 8.0)
        self.assertAlmostEqual(rows["vtk_cutter", 1000]["to_halfedge"], 9.0)
        self.assertIsNone(rows["halfedge", 1]["to_halfedge"])
        self.found.slicers = []
        self.assertEqual(slicers_table(self.found).rows, [])

    def test_the_chapter_says_how_sections_grow(self):
        section, = looking.write(self.found, {}, Facts())
        text = "\n".join(part for part in section.parts if isinstance(part, str))
        self.assertIn("power 0.50", text)
        self.assertIn("100 times as long", text)
        self.assertIn("through three vertices it is 1.11 ms, along an edge 1.25, in a face 1.43.", text)

    def test_without_sections_there_is_no_chapter(self):
        self.assertEqual(looking.write(Measurements(), {}, Facts()), [])


if __name__ == "__main__":
    unittest.main()
