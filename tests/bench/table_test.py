"""What a table is."""

import csv
import io
import unittest

from report.tables.numbers import percent, timed
from report.tables.table import Column, Table


class Tables(unittest.TestCase):
    def test_the_csv_keeps_what_the_page_rounds(self):
        table = Table("t", [Column("a", "A"), Column("ms", "time", timed)],
                      [{"a": "x", "ms": 1.23456}, {"a": "y", "ms": None}])
        self.assertEqual(table.cells(), [["x", "1.23"], ["y", "–"]])
        self.assertEqual(list(csv.DictReader(io.StringIO(table.csv_text()))),
                         [{"a": "x", "ms": "1.23456"}, {"a": "y", "ms": ""}])

    def test_times_have_as_many_digits_as_the_spread_of_their_row_allows(self):
        table = Table("t", [Column("ms", "time", timed), Column("spread", "spread", percent)],
                      [{"ms": 1.23456, "spread": 0.05}, {"ms": 1.23456, "spread": 0.42}, {"ms": 1.23456}])
        self.assertEqual([cells[0] for cells in table.cells()], ["1.23", "1.2", "1.23"])

    def test_a_value_without_a_column_is_refused(self):
        with self.assertRaises(ValueError):
            Table("t", [Column("a", "A")], [{"b": 1}]).csv_text()


if __name__ == "__main__":
    unittest.main()
