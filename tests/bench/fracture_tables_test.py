"""Objects broken into cells: times of each, of a piece, and what they are compared with."""

import unittest

from report.chapters import fracture
from report.chapters.section import Facts
from report.measurements import Measurements
from report.tables.fracture_tables import cells_table, fracture_exponents, fractures_table
from report_cases import whole_measurements


class FractureTables(unittest.TestCase):
    def setUp(self):
        self.found = whole_measurements()

    def test_each_mesh_and_number_of_cells_has_a_row(self):
        rows = fractures_table(self.found).rows
        self.assertEqual([(row["mesh"], row["triangles"], row["cells"]) for row in rows],
                         [("asteroid", size, cells) for size in (10_000, 100_000, 1_000_000) for cells in (10, 100, 1000)] +
                         [("sponge", 9_000, 100)])
        self.assertAlmostEqual(rows[1]["halfedge_ms"], 2.0)
        self.assertAlmostEqual(rows[1]["linear_ms"], 1.0)
        self.assertAlmostEqual(rows[1]["us_per_piece"], 20.0)
        self.assertIsNone(rows[-1]["linear_ms"])

    def test_exponents_are_those_of_cells_and_triangles(self):
        exponents = fracture_exponents(self.found)
        self.assertAlmostEqual(exponents["cells"], 0.30103, places=4)
        self.assertAlmostEqual(exponents["triangles"], 1.0)
        self.assertEqual(fracture_exponents(Measurements()), {})

    def test_other_libraries_are_compared_cell_by_cell(self):
        row, = cells_table(self.found).rows
        self.assertAlmostEqual(row["to_halfedge"], 100.0 / (2.0 / 100))

    def test_the_chapter_is_left_out_where_nothing_was_measured(self):
        self.assertEqual(fracture.write(Measurements(), {}, Facts()), [])
        section, = fracture.write(self.found, {}, Facts())
        text = "\n".join(part for part in section.parts if isinstance(part, str))
        self.assertIn("power of 0.30", text)
        self.assertIn("5\u202f000", text)


if __name__ == "__main__":
    unittest.main()
