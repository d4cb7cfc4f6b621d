"""What a report leaves behind: the page, CSV and JSON of every number, and on request docs/results.md."""

from pathlib import Path
from typing import Any

from report import files
from report.chapters import all_sections
from report.chapters.section import Facts, Section, ShownFigure, all_tables
from report.measurements import Measurements
from report.page.html_page import page_html
from report.page.markdown import results_markdown
from report.page.readme import results_block, with_results
from report.plots.catalogue import draw
from report.plots.drawing import Drawing
from report.plots.palette import THEMES

TITLE = "What it costs to cut a mesh"
BUSY = 1.5  # load per core above which times deserve a warning


class Report:
    """Sections, their tables and drawings, made of measurements."""

    def __init__(self, found: Measurements, machine: dict[str, str], extent: str, cores: int):
        self.found, self.machine, self.extent, self.cores = found, machine, extent, cores
        self.facts = Facts()
        self.sections: list[Section] = all_sections(found, machine, self.facts)
        self.tables = all_tables(self.sections, self.facts)
        self.drawings: dict[int, Drawing] = {}
        for section in self.sections:
            for part in section.parts:
                if isinstance(part, ShownFigure) and (drawing := draw(part.name, part.arguments, self.tables)):
                    self.drawings[id(part)] = drawing

    def lead(self) -> list[str]:
        dates = sorted(stage["date"] for stage in self.found.stages)
        when = f"{dates[0]} to {dates[-1]}" if dates else "never"
        return ["The student report “Real-time mesh cutting” cuts with a loop over all triangles. Kerf does that, "
                "too, and walks a half-edge mesh along the section. This page sets both beside the report's tables.",
                f"Measured {when} on {self.machine['processor']}; commit `{self.machine['commit']}`, extent "
                f"`{self.extent}`."]

    def warnings(self) -> list[str]:
        loads = [stage["load"][0] for stage in self.found.stages]
        if loads and sorted(loads)[len(loads) // 2] > BUSY * self.cores:
            return [f"The machine was busy (median load {sorted(loads)[len(loads) // 2]:.1f} on {self.cores} cores): "
                    "counters and exponents hold, times are longer and less certain than on a quiet one, and phases "
                    "and frames, which are read from the wall clock, are worth little."]
        return []

    def write(self, folder: Path) -> Path:
        """The page, csv/*.csv and results.json in `folder`; gives the page's path."""
        for name, table in self.tables.items():
            files.write_text(folder / "csv" / f"{name}.csv", table.csv_text())
        for stale in set((folder / "csv").glob("*.csv")) - {folder / "csv" / f"{name}.csv" for name in self.tables}:
            stale.unlink()
        files.write_json(folder / "results.json", self.as_json())
        page = folder / "index.html"
        files.write_text(page, page_html(TITLE, self.lead(), self.warnings(), self.sections, self.drawings))
        return page

    def as_json(self) -> dict[str, Any]:
        return {"extent": self.extent, "machine": self.machine,
                "tables": {name: table.rows for name, table in self.tables.items()}}

    def publish(self, docs: Path, readme: Path) -> Path:
        """docs/results.md with its figures in both themes under docs/images, and the README's part on results."""
        self.publish_figures(docs / "images")
        if "scaling_scale_asteroid" in self.tables:
            limits = next((section for section in self.sections if section.slug == "limits"), None)
            block = results_block(self.tables["scaling_scale_asteroid"], limits, self.machine["processor"])
            files.write_text(readme, with_results(readme.read_text(encoding="utf-8"), block))
        path = docs / "results.md"
        files.write_text(path, results_markdown(TITLE, self.lead(), self.warnings(), self.sections, self.drawings))
        return path

    def publish_figures(self, folder: Path) -> None:
        """Both themes of each published figure; those that were published before and are no longer go."""
        figures = [part for section in self.sections for part in section.parts
                   if isinstance(part, ShownFigure) and part.published and id(part) in self.drawings]
        written = set()
        for drawing in (self.drawings[id(figure)] for figure in figures):
            for theme in THEMES:
                path = folder / f"results_{drawing.name}_{theme}.svg"
                files.write_text(path, drawing.for_file(theme) + "\n")
                written.add(path)
        for stale in set(folder.glob("results_*.svg")) - written:
            stale.unlink()
