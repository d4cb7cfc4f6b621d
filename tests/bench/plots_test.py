"""Figures are drawn in the colours of a theme, or not at all."""

import unittest

from report_cases import HAS_MATPLOTLIB, some_measurements, whole_measurements
from report.chapters import all_sections
from report.chapters.section import Facts, ShownFigure, all_tables
from report.measurements import Measurements
from report.names import BACKENDS
from report.plots.drawing import Drawing
from report.plots.palette import COLOURS, STYLES, style_of
from report.plots.svg_text import grouped_paths, rounded_coordinates, shortened


class Drawings(unittest.TestCase):
    DRAWING = Drawing("f", f'<svg viewBox="0 0 20 10"><path fill="{COLOURS["ink"].token}"/></svg>')

    def test_on_the_page_colours_follow_its_theme(self):
        self.assertIn('fill="var(--ink)"', self.DRAWING.for_page())

    def test_in_a_file_they_are_those_of_one_theme_on_its_paper(self):
        for theme in ("light", "dark"):
            text = self.DRAWING.for_file(theme)
            self.assertIn(f'<path fill="{COLOURS["ink"].of(theme)}"/>', text)
            self.assertIn(f'<rect width="20" height="10" fill="{COLOURS["paper"].of(theme)}"/>', text)

    def test_a_drawing_without_a_size_is_refused(self):
        with self.assertRaises(ValueError):
            Drawing("f", "<svg></svg>").for_file("light")


class Palette(unittest.TestCase):
    def test_no_two_colours_are_drawn_with_one_token(self):
        self.assertEqual(len({colour.token for colour in COLOURS.values()}), len(COLOURS))

    def test_every_back_end_has_a_marker_and_a_dash_pattern_of_its_own(self):
        styles = [(STYLES[name].marker, STYLES[name].dashes) for name in BACKENDS]
        self.assertEqual(len({marker for marker, _ in styles}), len(BACKENDS))
        self.assertEqual(style_of("unknown").marker, ".")


class SvgText(unittest.TestCase):
    def test_coordinates_are_rounded_and_nothing_else(self):
        rest = 'style="stroke-width: 0.8001"/><text>0.0123</text>'
        self.assertEqual(rounded_coordinates(f'<path d="M 1.234567 -20.000001" {rest}'), f'<path d="M 1.23 -20" {rest}')

    def test_neighbouring_paths_of_one_style_share_it(self):
        def path(number, style):
            return f'<path d="M {number} 0" style="{style}"/>'

        self.assertEqual(grouped_paths(path(1, "a") + path(2, "a") + path(3, "b")),
                         '<g style="a"><path d="M 1 0"/><path d="M 2 0"/></g><path d="M 3 0" style="b"/>')
        alone = path(1, "a") + "<text>x</text>" + path(2, "a")
        self.assertEqual(grouped_paths(alone), alone)

    def test_space_between_elements_is_left_out_and_space_in_texts_kept(self):
        self.assertEqual(shortened("<g>  <text>a  b</text>\n </g>"), "<g><text>a  b</text></g>")


@unittest.skipUnless(HAS_MATPLOTLIB, "matplotlib is not there")
class Figures(unittest.TestCase):
    def draw_all(self, found):
        """Name of each figure and its drawing."""
        from report.plots.catalogue import draw
        facts = Facts()
        sections = all_sections(found, {}, facts)
        tables = all_tables(sections, facts)
        figures = [part for section in sections for part in section.parts if isinstance(part, ShownFigure)]
        return {figure.name: draw(figure.name, figure.arguments, tables) for figure in figures}

    def test_every_figure_that_a_chapter_names_exists(self):
        drawn = self.draw_all(whole_measurements())
        for name in ("models", "report_growth", "scaling", "counters", "crossing", "phases", "prepare", "chain_times",
                     "chain_ranges", "proxies", "distribution", "viewer_cuts", "peers"):
            self.assertIsNotNone(drawn[name], name)

    def test_figures_of_nothing_are_not_drawn(self):
        from report.plots.catalogue import FIGURES
        for name in ("crossing", "counters", "phases", "prepare", "angles", "chain_ranges", "chain_times", "proxies",
                     "distribution",
                     "viewer_cuts", "peers"):
            self.assertIsNone(FIGURES[name]({}), name)
        self.assertEqual(self.draw_all(Measurements()), {})

    def test_the_same_figure_gives_the_same_text(self):
        first, second = (self.draw_all(some_measurements())["scaling"] for _ in range(2))
        self.assertEqual(first, second)
        self.assertNotIn("<metadata", first.svg)


if __name__ == "__main__":
    unittest.main()
