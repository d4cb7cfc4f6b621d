"""Sections as HTML."""

import unittest

from report.chapters.section import Section, ShownFigure, ShownTable
from report.page.html_page import inline, page_html, section_html
from report.plots.drawing import Drawing
from report.tables.table import Column, Table


class Sentences(unittest.TestCase):
    def test_markdown_becomes_html_and_html_stays_text(self):
        self.assertEqual(inline("**a** *b* `c` <d>"), "<strong>a</strong> <em>b</em> <code>c</code> &lt;d&gt;")


class Pages(unittest.TestCase):
    TABLE = Table("t", [Column("a", "A & B"), Column("n", "n")], [{"a": "<x>", "n": 1}])

    def test_a_table_names_its_csv_and_texts_are_escaped(self):
        html = section_html(Section("s", "S", [ShownTable(self.TABLE, "What it *is*.")]), {})
        self.assertIn('<table data-table="t">', html)
        self.assertIn('href="csv/t.csv"', html)
        self.assertIn("<th class=text>A &amp; B</th>", html)
        self.assertIn('<td class="text">&lt;x&gt;</td><td>1</td>', html)

    def test_a_folded_table_is_opened_by_its_caption(self):
        html = section_html(Section("s", "S", [ShownTable(self.TABLE, "What it is.", folded=True)]), {})
        self.assertRegex(html, r"<details><summary>What it is\. 1 row</summary>.*<table")

    def test_a_listing_is_folded_too(self):
        self.assertIn("<details>", section_html(Section("s", "S", [ShownTable(self.TABLE, "All.", listing=True)]), {}))

    def test_the_answer_stands_above_the_links(self):
        page = page_html("Title", ["Lead."], [], [Section("answer", "", ["It is 7."]), Section("s", "S", ["Text."])],
                         {})
        self.assertLess(page.index("<p>It is 7.</p>"), page.index("Lead."))
        self.assertLess(page.index("Lead."), page.index("<nav>"))
        self.assertNotIn('href="#answer"', page)

    def test_a_figure_that_was_not_drawn_leaves_no_gap(self):
        figure = ShownFigure("f", "How it looks.")
        self.assertNotIn("figure", section_html(Section("s", "S", [figure]), {}))
        html = section_html(Section("s", "S", [figure]), {id(figure): Drawing("f", "<svg viewBox='0 0 1 1'></svg>")})
        self.assertIn('aria-label="How it looks."', html)
        self.assertIn("<figcaption>How it looks.</figcaption>", html)

    def test_the_head_has_a_link_to_each_section_and_the_warnings(self):
        html = page_html("Title", ["Lead."], ["Busy."], [Section("s", "S", ["Text."])], {})
        self.assertIn('<a href="#s">S</a>', html)
        self.assertIn('<p class="warning">Busy.</p>', html)


if __name__ == "__main__":
    unittest.main()
