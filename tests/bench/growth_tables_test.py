"""Tables of growth."""

import unittest

from report_cases import some_measurements
from report.tables.growth_tables import crossing_table, crossovers_table, scaling_points_table, scaling_table


class GrowthTables(unittest.TestCase):
    def test_the_crossover_is_where_the_lines_meet(self):
        row = next(row for row in crossovers_table(some_measurements()).rows if row["extent"] == "whole chain")
        self.assertAlmostEqual(row["from_triangles"], 10_000)  # n / 1000 = sqrt(n) / 10

    def test_a_row_of_the_scaling_table_has_the_exponent_of_its_times(self):
        rows = {row["backend"]: row for row in scaling_table(some_measurements(), "Scale", "asteroid").rows}
        self.assertAlmostEqual(rows["halfedge"]["exponent"], 0.5)
        self.assertAlmostEqual(rows["baseline/remap"]["exponent"], 1.0)
        self.assertEqual(rows["baseline/remap"]["ms_30000"], 30.0)
        self.assertEqual(rows["halfedge"]["exponent_points"], 4)  # the smallest size is fixed cost

    def test_every_time_is_a_row_of_points(self):
        self.assertEqual(len(scaling_points_table(some_measurements()).rows), 2 * 2 * 5)  # extents, back ends, sizes

    def test_what_a_crossing_triangle_costs_does_not_grow(self):
        touched = [row["touched_per_crossing"] for row in crossing_table(some_measurements()).rows]
        self.assertEqual(len(touched), 5)
        for each in touched:
            self.assertAlmostEqual(each, 10.0)


if __name__ == "__main__":
    unittest.main()
