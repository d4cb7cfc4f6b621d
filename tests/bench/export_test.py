"""The page against its CSV, and what is published."""

import csv
import io
import re
import tempfile
import unittest
from html.parser import HTMLParser
from pathlib import Path

from report_cases import HAS_MATPLOTLIB, whole_measurements
from report.page.readme import BEGIN, END


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
        from report.page.export import Report
        cls.report = Report(whole_measurements(), {"processor": "a processor", "commit": "abc"}, "quick", 2)
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
                    spread = float(values.get("spread") or 0)
                    expected = column.cell({"spread": spread,
                                            column.key: None if value == "" else float(value) if number else value})
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
        self.assertNotIn("#01", re.sub(r"&#01", "",
                                       "".join(re.findall(r"<svg.*?</svg>", self.page))))  # no colour left over
        identifiers = re.findall(r'<figure id="([^"]+)"', self.page)
        self.assertEqual(len(identifiers), len(set(identifiers)))

    def test_the_same_measurements_give_the_same_page(self):
        from report.page.export import Report
        again = Report(whole_measurements(), {"processor": "a processor", "commit": "abc"}, "quick", 2)
        with tempfile.TemporaryDirectory() as folder:
            self.assertEqual(again.write(Path(folder)).read_text(), self.page)

    def test_published_markdown_names_its_pictures(self):
        with tempfile.TemporaryDirectory() as folder:
            stale = Path(folder) / "images/results_gone_light.svg"
            stale.parent.mkdir()
            stale.touch()
            readme = Path(folder) / "README.md"
            readme.write_text(f"before\n{BEGIN}\nwas here\n{END}\nafter\n")
            text = self.report.publish(Path(folder), readme).read_text()
            pictures = re.findall(r'(?:src|srcset)="([^"]+)"', text)
            self.assertTrue(pictures)
            for picture in pictures:
                self.assertTrue((Path(folder) / picture).exists(), picture)
            self.assertRegex(readme.read_text(), r"(?s)^before\n.*\| `halfedge` \| 3\.2 \| .*\nafter\n$")
            self.assertFalse(stale.exists())
            self.assertNotIn("was here", readme.read_text())



if __name__ == "__main__":
    unittest.main()
