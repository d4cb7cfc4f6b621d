"""The README's part on results."""

import unittest

from report_cases import some_measurements
from report.page.readme import BEGIN, END, results_block, table_lines, with_results
from report.chapters.section import Section
from report.tables.growth_tables import scaling_table


class Readme(unittest.TestCase):
    TABLE = scaling_table(some_measurements(), "Scale", "asteroid")

    def test_a_readme_without_marks_is_left_alone(self):
        with self.assertRaises(ValueError):
            with_results("no marks", "block")

    def test_what_stands_between_the_marks_is_replaced_and_nothing_else(self):
        self.assertEqual(with_results(f"before {BEGIN}old{END} after", "new"), f"before {BEGIN}\nnew\n{END} after")

    def test_the_table_has_the_sizes_that_were_measured(self):
        head, _, *rows = table_lines(self.TABLE)
        self.assertEqual(head, "| ms per cut | 1 k | 10 k | 100 k | 1 M | time ~ triangles^e (from size to size) |")
        self.assertRegex(rows[-1], r"^\| `halfedge` \| .* \| 0\.50 ± 0\.00 \(0\.50 to 0\.50\) \|$")

    def test_the_first_limits_are_listed_and_all_of_them_linked(self):
        limits = Section("limits", "Where it is not better", [f"**{n}.** B." for n in range(5)])
        block = results_block(self.TABLE, limits, "a processor, 2 cores")
        self.assertIn("An asteroid of 1 k to 1 M triangles is cut", block)
        self.assertIn("Processor: a processor, one thread.", block)
        self.assertIn("**Where it is not better** ([all of it](docs/results.md#where-it-is-not-better)):\n\n* **0.** "
                      "B.", block)
        self.assertEqual(block.count("\n* "), 4)


if __name__ == "__main__":
    unittest.main()
