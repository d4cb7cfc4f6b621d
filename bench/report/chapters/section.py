"""What the page says: sections of sentences, tables and figures. Renderers make a page, Markdown or text of them.

Sentences are plain text with `code` and **strong** in Markdown's way. Numbers that were measured enter them through
Facts only, so that each of them can be found in a CSV.
"""

from dataclasses import dataclass, field
from typing import Any

from report.tables.numbers import Formatter
from report.tables.table import Column, Table


@dataclass(frozen=True)
class ShownTable:
    """A table with the sentence above it. `published` ones are in docs/results.md too."""

    table: Table
    caption: str
    published: bool = False
    folded: bool = False  # a figure tells the same: shown when the reader asks
    listing: bool = False  # every row of something: folded as well, and only of use beside the CSV


@dataclass(frozen=True)
class ShownFigure:
    """A figure by the name of the function that draws it (report.plots), with the sentence below it."""

    name: str
    caption: str
    published: bool = False
    wide: bool = False
    arguments: tuple[Any, ...] = ()


Part = str | ShownTable | ShownFigure


@dataclass
class Section:
    """One heading with what belongs to it, in order: sentences are strings. The answer, which opens the page, has no
    title."""

    slug: str
    title: str
    parts: list[Part] = field(default_factory=list)


class Facts:
    """Numbers that sentences name: each said number is kept for the CSV."""

    def __init__(self) -> None:
        self.table = Table("facts", [Column("section", "section"), Column("name", "name"), Column("value", "value"),
                                     Column("shown", "shown")])
        self.section = ""

    def say(self, name: str, value: float, show: Formatter) -> str:
        shown = show(value)
        self.table.rows.append({"section": self.section, "name": name, "value": value, "shown": shown})
        return shown


def all_tables(sections: list[Section], facts: Facts) -> dict[str, Table]:
    """Every table by name. Names are file names, so each is there once."""
    tables: dict[str, Table] = {}
    for section in sections:
        for part in section.parts:
            if isinstance(part, ShownTable):
                if part.table.name in tables:
                    raise ValueError(f"two tables are called {part.table.name}")
                tables[part.table.name] = part.table
    tables[facts.table.name] = facts.table
    return tables
