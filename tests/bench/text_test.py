"""Tables as text."""

import unittest

from report.chapters.section import Section, ShownTable
from report.page.text import plain_text, table_text, text_page
from report.tables.numbers import digits
from report.tables.table import Column, Table


class Text(unittest.TestCase):
    TABLE = Table("t", [Column("name", "name"), Column("ms", "ms", digits(1)), Column("gone", "gone")],
                  [{"name": "a", "ms": 12.34, "gone": None}, {"name": "longer", "ms": None, "gone": None}])

    def test_columns_are_aligned_and_empty_ones_left_out(self):
        self.assertEqual(table_text(self.TABLE), "name      ms\n------  ----\na       12.3\nlonger     –")

    def test_marks_of_markdown_are_left_out(self):
        self.assertEqual(plain_text("**a** *b* `c`"), "a b c")

    def test_listings_are_left_out_and_so_are_empty_tables(self):
        sections = [Section("s", "Growth", ["Prose.", ShownTable(self.TABLE, "Shown."),
                                            ShownTable(self.TABLE, "Listed.", listing=True)]),
                    Section("e", "Empty", [ShownTable(Table("e", []), "Nothing.")])]
        text = text_page(sections, ["The end."])
        self.assertTrue(text.startswith("Growth\n======\n\nShown.\n\nname"))
        self.assertTrue(text.endswith("\n\nThe end.\n"))
        for gone in ("Prose", "Listed", "Empty", "Nothing"):
            self.assertNotIn(gone, text)


if __name__ == "__main__":
    unittest.main()
