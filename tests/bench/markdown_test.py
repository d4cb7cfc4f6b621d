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

    def test_only_what_is_published_is_kept_and_the_rest_is_named(self):
        kept, left = ShownTable(self.TABLE, "Kept.", published=True), ShownTable(self.TABLE, "Left.")
        text = results_markdown("Title", ["Lead."], [],
                                [Section("s", "S", ["Said.", kept, left]), Section("e", "E", [left])], {})
        for there in ("# Title", "Lead.", "## S", "Said.", "Kept.", "Only there: E."):
            self.assertIn(there, text)
        for gone in ("Left.", "## E"):
            self.assertNotIn(gone, text)

    def test_the_answer_comes_first(self):
        text = results_markdown("Title", ["Lead."], ["Busy."],
                                [Section("s", "S", []), Section("answer", "", ["It is 7."])], {})
        self.assertRegex(text, r"(?s)# Title\n\nIt is 7\.\n\n> Busy\.\n\nLead\.")

    def test_a_folded_table_is_opened_by_its_caption(self):
        shown = ShownTable(self.TABLE, "Kept.", published=True, folded=True)
        text = results_markdown("Title", [], [], [Section("s", "S", [shown])], {})
        self.assertIn("<details><summary>Kept.</summary>\n\n| what | n |", text)
        self.assertIn("| z | – |\n\n</details>", text)

    def test_columns_that_hold_nothing_are_left_out(self):
        table = Table("t", [Column("a", "what"), Column("n", "n")], [{"a": "x", "n": None}])
        self.assertEqual(table_markdown(table), "| what |\n|---|\n| x |")

    def test_a_figure_has_both_themes_and_a_description(self):
        figure = ShownFigure("f", "How it looks.", published=True)
        text = results_markdown("Title", [], [], [Section("s", "S", [figure])], {id(figure): Drawing("f", "<svg/>")})
        self.assertIn('srcset="images/results_f_dark.svg"', text)
        self.assertIn('alt="How it looks." src="images/results_f_light.svg"', text)


if __name__ == "__main__":
    unittest.main()
