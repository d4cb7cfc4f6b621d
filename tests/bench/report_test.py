"""The Python part of the benchmarks: fits, tables, stages, the comparison of revisions, and the page against its CSV.

Nothing here needs matplotlib except the test of the page, which is skipped without it.
"""

import csv
import importlib.machinery
import importlib.util
import io
import json
import math
import os
import re
import sys
import tempfile
import unittest
from html.parser import HTMLParser
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "bench"))

from report import fits, measurements  # noqa: E402  (found through the line above)
from report.chapters import all_sections  # noqa: E402
from report.chapters.growth import chain_turn  # noqa: E402
from report.measurements import Measurements  # noqa: E402
from report.names import Kind  # noqa: E402
from report.page import inline  # noqa: E402
from report.plan import FULL, NORMAL, QUICK, Stage, plan  # noqa: E402
from report.progress import Progress, time_text  # noqa: E402
from report.readme import BEGIN, END, with_results  # noqa: E402
from report.sections import Facts, all_tables  # noqa: E402
from report.stages import Programs, StageFailed, Stages  # noqa: E402
from report.tables import Column, Table, count_short, crossovers_table, digits, milliseconds, percent, rounded  # noqa: E402

HAS_MATPLOTLIB = importlib.util.find_spec("matplotlib") is not None


def load_program(name):
    """A program without the ending .py, as a module."""
    loader = importlib.machinery.SourceFileLoader(name, str(ROOT / "bench" / name))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader(name, loader))
    loader.exec_module(module)
    return module


def some_measurements():
    """A linear and a half-edge back end whose times are known exactly: n / 1000 and sqrt(n) / 10 ms."""
    found = Measurements()
    for size in (1_000, 10_000, 30_000, 100_000, 1_000_000):
        for backend, ms in (("baseline/remap", size / 1000), ("halfedge", math.sqrt(size) / 10)):
            counters = {"real_time": ms, "triangles": size, "crossing": math.sqrt(size), "touched": 10 * math.sqrt(size),
                        "nodes": math.sqrt(size), "upload_bytes": 200 * math.sqrt(size), "ns_per_crossing": 1e6 * ms / math.sqrt(size),
                        "ms_find": ms / 2, "ms_cap": ms / 2, "repetitions": 1, "iterations": 1}
            for kind in ("Scale", "Geometry"):
                found.bench[f"{kind}/{backend}/asteroid/{size}"] = {key: (v, v, v) for key, v in counters.items()}
    return found


class Fits(unittest.TestCase):
    def test_a_power_law_gives_its_exponent_and_factor(self):
        fitted = fits.exponent([(n, 3.0 * n**1.5) for n in (10, 100, 1000, 10000)])
        self.assertAlmostEqual(fitted.value, 1.5)
        self.assertAlmostEqual(fitted.factor, 3.0)
        self.assertLess(fitted.half_width, 1e-6)

    def test_scatter_widens_the_interval_by_students_t(self):
        # Residuals +d, -2d, +d in logarithms around slope 1: worked out by hand.
        d = 0.1
        fitted = fits.exponent([(math.e**x, math.e**(x + r)) for x, r in ((0, d), (1, -2 * d), (2, d))])
        self.assertAlmostEqual(fitted.value, 1.0)
        one_degree = math.tan(0.475 * math.pi)  # Student's distribution is Cauchy's there
        self.assertAlmostEqual(fitted.half_width, one_degree * math.sqrt(6 * d * d / 1 / 2))

    def test_quantiles_of_students_t_are_those_of_printed_tables(self):
        for degrees, t in ((1, 12.706), (2, 4.303), (3, 3.182), (4, 2.776), (10, 2.228), (13, 2.160), (30, 2.042)):
            self.assertAlmostEqual(fits.student_quantile(degrees), t, places=3)

    def test_leaving_out_the_point_that_bends_a_line_gives_it_back(self):
        points = [(n, float(n)) for n in (1, 10, 100)] + [(1000, 5000.0)]
        self.assertAlmostEqual(fits.without_each(points)[3].value, 1.0)
        self.assertGreater(fits.without_each(points)[0].value, 1.1)

    def test_slopes_are_those_between_neighbours(self):
        self.assertEqual([round(slope, 9) for slope in fits.slopes([(100, 1e4), (1, 1.0), (10, 10.0)])], [1.0, 3.0])

    def test_too_few_sizes_give_no_exponent_or_no_interval(self):
        self.assertIsNone(fits.exponent([(10, 1.0)]))
        self.assertIsNone(fits.exponent([(10, 1.0), (10, 2.0)]))
        self.assertIsNone(fits.exponent([(10, 1.0), (100, 2.0)]).half_width)

    def test_preparing_is_paid_back_by_quicker_cuts_only(self):
        self.assertEqual(fits.cuts_to_pay_back(100.0, 0.0, 1.0, 3.0), 50.0)
        self.assertIsNone(fits.cuts_to_pay_back(100.0, 0.0, 3.0, 3.0))


class Tables(unittest.TestCase):
    def test_the_csv_keeps_what_the_page_rounds(self):
        table = Table("t", [Column("a", "A"), Column("ms", "time", milliseconds)], [{"a": "x", "ms": 1.23456}, {"a": "y", "ms": None}])
        self.assertEqual(table.cells(), [["x", "1.235"], ["y", "–"]])
        self.assertEqual(list(csv.DictReader(io.StringIO(table.csv_text()))), [{"a": "x", "ms": "1.23456"}, {"a": "y", "ms": ""}])

    def test_a_value_without_a_column_is_refused(self):
        with self.assertRaises(ValueError):
            Table("t", [Column("a", "A")], [{"b": 1}]).csv_text()

    def test_numbers_are_shown_as_people_write_them(self):
        self.assertEqual([count_short(n) for n in (12, 3_000, 100_000, 4_000_000)], ["12", "3 k", "100 k", "4 M"])
        self.assertEqual([percent(share) for share in (0.0, 1e-16, 0.012, 0.25, 5.82)], ["0", "0", "1.2 %", "25 %", "582 %"])
        self.assertEqual([rounded(n).replace("\u202f", " ") for n in (19354, 308138, 47, 0.123, 0)], ["19 000", "310 000", "47", "0.12", "0"])
        self.assertEqual([milliseconds(ms) for ms in (0.0123, 9.9994, 123.4)], ["0.012", "9.999", "123.4"])

    def test_the_crossover_is_where_the_lines_meet(self):
        row = next(row for row in crossovers_table(some_measurements()).rows if row["extent"] == "whole chain")
        self.assertAlmostEqual(row["from_triangles"], 10_000)  # n / 1000 = sqrt(n) / 10

    def test_a_chain_pays_back_where_its_balance_turns_for_good(self):
        rows = [{"cuts": cuts, "balance_ms": ms} for cuts, ms in ((1, -5.0), (10, 1.0), (100, -1.0), (300, 2.0), (1000, 9.0))]
        self.assertEqual(chain_turn(rows, "balance_ms"), (100, 300))
        self.assertIsNone(chain_turn(rows[:3], "balance_ms"))
        self.assertEqual(chain_turn(rows[3:], "balance_ms"), (0, 300))

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


class Plans(unittest.TestCase):
    def test_stages_have_names_of_their_own_and_sizes_within_the_extent(self):
        for extent in (QUICK, NORMAL, FULL):
            stages = plan(extent, Path("scratch"), with_vtk=True)
            names = [stage.name for stage in stages]
            self.assertEqual(len(names), len(set(names)))
            sizes = [int(name.split("-")[1]) for name in names if name.startswith("growth-")]
            self.assertEqual(max(sizes), extent.most_triangles)

    def test_quadratic_lookups_are_left_out_above_their_limit(self):
        patterns = {stage.name: re.compile(stage.arguments[0]) for stage in plan(NORMAL, Path("scratch")) if stage.kind == Kind.BENCH}
        self.assertTrue(patterns["growth-30000"].search("Scale/baseline/scan/asteroid/30000/manual_time"))
        self.assertFalse(patterns["growth-100000"].search("Scale/baseline/scan/asteroid/100000/manual_time"))
        self.assertTrue(patterns["growth-100000"].search("Scale/baseline/hash/shuffled/100000/manual_time"))
        self.assertFalse(patterns["growth-10000"].search("Scale/halfedge/asteroid/100000/manual_time"))


class ProgressOfStages(unittest.TestCase):
    def test_time_left_follows_the_pace_so_far(self):
        now = [0.0]
        progress = Progress({"a": 10.0, "b": 10.0}, stream=io.StringIO(), clock=lambda: now[0])
        self.assertEqual(progress.seconds_left(), 20.0)
        progress.begin("a")
        now[0] = 20.0  # twice as long as expected
        progress.end()
        self.assertEqual(progress.share(), 0.5)
        self.assertEqual(progress.seconds_left(), 15.0)  # half trusted
        self.assertEqual(time_text(75), "1 min 15 s")


class Resuming(unittest.TestCase):
    """Stages are run by a program that counts how often it is called."""

    def setUp(self):
        self.before = Path.cwd()
        self.folder = tempfile.TemporaryDirectory()
        os.chdir(self.folder.name)
        self.program = Path("program")
        self.write_program('echo call >> calls; echo "{\\"rows\\": 1}"')
        self.stage = Stage("compare-x", Kind.COMPARE, ("--planes", "1"), 1.0)

    def tearDown(self):
        os.chdir(self.before)
        self.folder.cleanup()

    def write_program(self, text):
        self.program.write_text("#!/bin/sh\n" + text + "\n")
        self.program.chmod(0o755)

    def stages(self):
        program = self.program.absolute()
        return Stages(Path("stages"), Programs(program, program, program, program, program))

    def run_stage(self, stage):
        stages = self.stages()
        if not stages.finished(stage):
            stages.run(stage, Progress({stage.name: 1.0}, stream=io.StringIO()))

    def calls(self):
        return len(Path("calls").read_text().splitlines())

    def test_a_finished_stage_is_not_run_again(self):
        self.run_stage(self.stage)
        self.run_stage(self.stage)
        self.assertEqual(self.calls(), 1)
        self.assertEqual(json.loads(self.stages().file(self.stage).read_text())["result"], {"rows": 1})

    def test_other_arguments_and_another_program_make_it_run_again(self):
        self.run_stage(self.stage)
        self.run_stage(Stage("compare-x", Kind.COMPARE, ("--planes", "2"), 1.0))
        self.assertEqual(self.calls(), 2)
        self.write_program('echo call >> calls; echo "{\\"rows\\": 2}"')
        self.run_stage(self.stage)
        self.assertEqual(self.calls(), 3)

    def test_half_a_file_counts_as_nothing(self):
        self.run_stage(self.stage)
        file = self.stages().file(self.stage)
        file.write_text(file.read_text()[:40])
        self.run_stage(self.stage)
        self.assertEqual(self.calls(), 2)

    def test_a_program_that_fails_leaves_nothing_behind(self):
        self.write_program("echo it is broken >&2; exit 3")
        with self.assertRaisesRegex(StageFailed, "exit status 3.*\nit is broken"):
            self.run_stage(self.stage)
        self.assertFalse(self.stages().finished(self.stage))
        self.assertEqual(list(Path("stages").glob("*")) if Path("stages").exists() else [], [])

    def test_a_comparison_that_finds_differences_is_a_result(self):
        self.write_program('echo "{\\"rows\\": 1}"; exit 1')
        self.run_stage(self.stage)
        self.assertTrue(self.stages().finished(self.stage))


class Revisions(unittest.TestCase):
    """bench/compare."""

    @classmethod
    def setUpClass(cls):
        cls.compare = load_program("compare")

    def test_the_interval_of_a_median_holds_the_stated_share(self):
        # n = 11: below the true median at most 1 of 11 with probability 12/2048 < 2.5 %, at most 2 with 67/2048 > 2.5 %.
        self.assertEqual(self.compare.median_interval(list(range(1, 12))), (6, 2, 10))
        self.assertEqual(self.compare.median_interval([1, 2, 3, 4, 5]), (3, None, None))
        self.assertEqual(self.compare.median_interval([6, 5, 4, 3, 2, 1]), (3.5, 1, 6))

    def test_a_filter_that_matches_nothing_is_one_sentence(self):
        for program in ("/bin/true", "/no/such/program"):  # the harness writes nothing and ends well
            with self.assertRaises(self.compare.Failed):
                self.compare.run_once(program, "(", 0.1)

    def test_times_are_those_of_one_cut(self):
        self.assertEqual(self.compare.cuts_of({"name": "Scale/x", "real_time": 10.0, "cuts_each": 5}), 5)
        self.assertEqual(self.compare.cuts_of({"name": "Cut/x", "real_time": 10.0, "cut_ms": 1.0}), 10)
        self.assertEqual(self.compare.cuts_of({"name": "Recut/x", "real_time": 10.0, "cut_ms": 1.0}), 1)

    def test_rows_are_ratios_of_neighbouring_runs_and_counters_that_differ(self):
        runs = ([{"x": {"ms": ms, "touched": 5}} for ms in (1, 2, 4, 1, 2, 4)], [{"x": {"ms": 2 * ms, "touched": 6}} for ms in (1, 2, 4, 1, 2, 4)])
        row, = self.compare.rows_of(runs)
        self.assertEqual((row["ratio"], row["low"], row["high"]), (2, 2, 2))
        self.assertEqual(row["counters"], {"touched": (5, 6)})
        self.assertEqual(self.compare.verdict(row), "slower")


class ParsedTables(HTMLParser):
    """Tables of a page by the name of their CSV."""

    def __init__(self, text):
        super().__init__()
        self.tables, self.row, self.cell = {}, None, None
        self.feed(text)

    def handle_starttag(self, tag, attrs):
        if tag == "table":
            self.name = dict(attrs)["data-table"]
            self.tables[self.name] = []
        elif tag == "tr":
            self.row = []
        elif tag == "td":
            self.cell = ""

    def handle_endtag(self, tag):
        if tag == "td":
            self.row.append(self.cell)
            self.cell = None
        elif tag == "tr" and self.row:
            self.tables[self.name].append(self.row)

    def handle_data(self, data):
        if self.cell is not None:
            self.cell += data


@unittest.skipUnless(HAS_MATPLOTLIB, "matplotlib is not there")
class Page(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        from report.export import Report
        cls.report = Report(some_measurements(), {"processor": "a processor", "commit": "abc"}, "quick", 2)
        cls.folder = tempfile.TemporaryDirectory()
        cls.page = cls.report.write(Path(cls.folder.name)).read_text()

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def test_every_cell_is_the_csvs_value_as_its_column_shows_it(self):
        shown = ParsedTables(self.page).tables
        self.assertIn("scaling_scale_asteroid", shown)
        for name, rows in shown.items():
            table = self.report.tables[name]
            in_csv = list(csv.DictReader(io.StringIO((Path(self.folder.name) / "csv" / f"{name}.csv").read_text())))
            self.assertEqual(len(rows), len(in_csv))
            for cells, values in zip(rows, in_csv):
                for cell, column in zip(cells, table.columns):
                    value = values[column.key]
                    number = re.fullmatch(r"-?\d+(\.\d+)?(e[-+]?\d+)?", value)
                    expected = "–" if value == "" else column.show(float(value) if number and column.show is not str else value)
                    if cell != expected and number:  # whole numbers are written without a point
                        expected = column.show(int(float(value)))
                    self.assertEqual(cell, expected, (name, column.key))

    def test_numbers_in_sentences_are_facts(self):
        self.assertTrue(self.report.facts.table.rows)
        for row in self.report.facts.table.rows:
            self.assertIn(row["shown"], self.page)

    def test_the_page_stands_alone(self):
        self.assertNotRegex(self.page, r'(src|href)="(https?:)?//')
        self.assertNotRegex(self.page, r"@import|url\((?!#)")
        self.assertNotIn("#01", re.sub(r"&#01", "", "".join(re.findall(r"<svg.*?</svg>", self.page))))  # no colour left over
        identifiers = re.findall(r'<figure id="([^"]+)"', self.page)
        self.assertEqual(len(identifiers), len(set(identifiers)))

    def test_the_same_measurements_give_the_same_page(self):
        from report.export import Report
        again = Report(some_measurements(), {"processor": "a processor", "commit": "abc"}, "quick", 2)
        with tempfile.TemporaryDirectory() as folder:
            self.assertEqual(again.write(Path(folder)).read_text(), self.page)

    def test_published_markdown_names_its_pictures(self):
        with tempfile.TemporaryDirectory() as folder:
            readme = Path(folder) / "README.md"
            readme.write_text(f"before\n{BEGIN}\nold\n{END}\nafter\n")
            text = self.report.publish(Path(folder), readme).read_text()
            pictures = re.findall(r'(?:src|srcset)="([^"]+)"', text)
            self.assertTrue(pictures)
            for picture in pictures:
                self.assertTrue((Path(folder) / picture).exists(), picture)
            self.assertRegex(readme.read_text(), r"(?s)^before\n.*\| `halfedge` \| 3\.162 \| .*\nafter\n$")
            self.assertNotIn("old", readme.read_text())

    def test_a_readme_without_marks_is_left_alone(self):
        with self.assertRaises(ValueError):
            with_results("no marks", "block")


class Sentences(unittest.TestCase):
    def test_markdown_becomes_html_and_html_stays_text(self):
        self.assertEqual(inline("**a** *b* `c` <d>"), "<strong>a</strong> <em>b</em> <code>c</code> &lt;d&gt;")


class Measured(unittest.TestCase):
    def test_the_median_of_repetitions_is_taken_and_failed_results_stop_everything(self):
        from run_bench import collect
        entry = {"run_type": "iteration", "name": "Cut/halfedge/rook/manual_time"}
        table = collect({"benchmarks": [entry | {"real_time": ms} for ms in (3.0, 1.0, 2.0)]})
        self.assertEqual(table["Cut/halfedge/rook"]["real_time"], (2.0, 1.0, 3.0))
        with self.assertRaises(SystemExit):
            collect({"benchmarks": [entry | {"error_occurred": True, "error_message": "a side is not closed"}]})

    def test_times_are_those_of_one_cut_where_a_round_is_timed(self):
        from run_bench import collect
        entry = {"run_type": "iteration", "name": "Scale/halfedge/asteroid/1000/manual_time", "cuts_each": 5}
        table = collect({"benchmarks": [entry | {"real_time": ms} for ms in (5.0, 10.0)]})
        counters = table["Scale/halfedge/asteroid/1000"]
        self.assertEqual((counters["real_time"], counters["repetitions"]), ((1.5, 1.0, 2.0), (2, 2, 2)))

    def test_models_are_named_without_folder_and_size(self):
        self.assertEqual(measurements.model_name("build/x/asteroid-1000.ply"), "asteroid")


if __name__ == "__main__":
    unittest.main()
