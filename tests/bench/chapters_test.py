"""Chapters are made of what there is."""

import unittest

from report_cases import some_measurements
from report.chapters import all_sections
from report.chapters.section import Facts, Section, ShownFigure, ShownTable, all_tables
from report.measurements import Measurements
from report.tables.table import Table


class Chapters(unittest.TestCase):
    def test_every_chapter_is_made_of_what_there_is_and_says_the_exponents(self):
        facts = Facts()
        sections = all_sections(some_measurements(), {"processor": "p", "commit": "c"}, facts)
        self.assertIn("scaling", [section.slug for section in sections])
        self.assertNotIn("peers", [section.slug for section in sections])
        said = {row["name"]: row["shown"] for row in facts.table.rows}
        self.assertEqual(said["halfedge e"], "0.50")
        self.assertEqual(said["remap e"], "1.00")
        self.assertEqual(said["remap to halfedge"], "10.0")
        all_tables(sections, facts)  # each name once

    def test_nothing_measured_leaves_what_says_how_it_is_done(self):
        self.assertEqual([section.slug for section in all_sections(Measurements(), {}, Facts())], ["method"])

    def test_the_page_opens_with_an_answer_of_at_most_three_sentences_and_a_figure(self):
        answer = all_sections(some_measurements(), {}, Facts())[0]
        self.assertEqual((answer.slug, answer.title), ("answer", ""))
        *sentences, figure = answer.parts
        self.assertEqual(sentences, ["At **1 M triangles** a cut takes **100 ms** with the half-edge back end and "
                                     "**1\u202f000 ms** with the best linear method, `remap`.",
                                     "Meshes of fewer than about **10\u202f000 triangles** are cut faster by `remap`, with "
                                     "everything that a game needs of the pieces."])
        self.assertIsInstance(figure, ShownFigure)

    def test_figures_come_before_prose_and_prose_before_tables(self):
        for section in all_sections(some_measurements(), {}, Facts())[1:]:
            kinds = [type(part) for part in section.parts]
            if ShownFigure in kinds and str in kinds:
                self.assertLess(kinds.index(ShownFigure), kinds.index(str), section.slug)

    def test_what_is_said_is_kept_with_its_chapter_and_value(self):
        facts = Facts()
        facts.section = "growth"
        self.assertEqual(facts.say("largest size", 1234.5, lambda value: f"{value:.0f}"), "1234")
        self.assertEqual(facts.table.rows, [{"section": "growth", "name": "largest size", "value": 1234.5,
                                             "shown": "1234"}])

    def test_two_tables_of_one_name_are_refused(self):
        shown = ShownTable(Table("t", []), "")
        with self.assertRaises(ValueError):
            all_tables([Section("a", "A", [shown, shown])], Facts())


if __name__ == "__main__":
    unittest.main()
