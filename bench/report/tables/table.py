"""What a table is."""

import csv
import io
from dataclasses import dataclass, field
from typing import Any

from report.tables.numbers import ABSENT, Formatter, plain, timed

Value = Any  # a number, a text, or None for what was not measured; what, the column knows


@dataclass(frozen=True)
class Column:
    """`key` heads the column in the CSV, `title` on the page."""

    key: str
    title: str
    show: Formatter = plain

    def cell(self, row: dict[str, Value]) -> str:
        """What the page shows of a row: times with as many digits as the row's spread allows."""
        value = row.get(self.key)
        if value is None:
            return ABSENT
        return timed(value, row.get("spread")) if self.show is timed else self.show(value)


@dataclass
class Table:
    """Rows of raw values: the CSV has them in full, the page rounded."""

    name: str
    columns: list[Column]
    rows: list[dict[str, Value]] = field(default_factory=list)

    def csv_text(self) -> str:
        out = io.StringIO()
        writer = csv.DictWriter(out, [column.key for column in self.columns], extrasaction="raise", lineterminator="\n")
        writer.writeheader()
        writer.writerows({key: "" if value is None else value for key, value in row.items()} for row in self.rows)
        return out.getvalue()

    def cells(self) -> list[list[str]]:
        """What the page shows."""
        return [[column.cell(row) for column in self.columns] for row in self.rows]
