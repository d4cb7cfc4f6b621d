"""Sections as Markdown."""

import unittest

from report.chapters.section import Section, ShownFigure, ShownTable
from report.page.markdown import results_markdown, table_markdown
from report.plots.drawing import Drawing
from report.tables.table import Column, Table


class Markdown(unittest.TestCase):
    TABLE = Table("t", [Column("a", "what"), Column("n", "n")], [{"a": "x|y", "n": 1}, {"a": "z", "n": None}])

    def test_numbers_stand_to_the_right_and_bars_are_escaped(self):
        self.assertEqual(table_markdown(self.TABLE), "| what | n |\n|---|--:|\n| x\\|y | 1 |\n| z | – |")

    def test_only_what_is_published_is_kept(self):
        kept, left = ShownTable(self.TABLE, "Kept.", published=True), ShownTable(self.TABLE, "Left.")
        text = results_markdown("Title", ["Lead."], [], [Section("s", "S", ["Said.", kept, left]), Section("e", "E", [left])], {})
        for there in ("# Title", "Lead.", "## S", "Said.", "Kept."):
            self.assertIn(there, text)
        for gone in ("Left.", "## E"):
            self.assertNotIn(gone, text)

    def test_a_figure_has_both_themes_and_a_description(self):
        figure = ShownFigure("f", "How it looks.", published=True)
        text = results_markdown("Title", [], [], [Section("s", "S", [figure])], {id(figure): Drawing("f", "<svg/>")})
        self.assertIn('srcset="images/results_f_dark.svg"', text)
        self.assertIn('alt="How it looks." src="images/results_f_light.svg"', text)


if __name__ == "__main__":
    unittest.main()
