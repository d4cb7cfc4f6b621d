"""What a table is, and how numbers are shown."""

import csv
import io
import math
from dataclasses import dataclass, field
from typing import Any, Callable, Iterable

from report.measurements import Counters

Value = float | int | str | None
Formatter = Callable[[Any], str]

ABSENT = "–"
MICROSECOND_DIGITS = 3


def milliseconds(value: float) -> str:
    return f"{value:.{MICROSECOND_DIGITS}f}" if value < 10 else f"{value:.1f}"


def count(value: float) -> str:
    return f"{value:,.0f}".replace(",", "\u202f")


def microseconds(value: float) -> str:
    """Milliseconds, with more digits where they are few: a box takes less than a thousandth."""
    return f"{value:.5f}" if value < 1e-2 else milliseconds(value)


def rounded(value: float) -> str:
    """Two digits, as a sentence wants them of what is known to no more: 19 354 as "19 000"."""
    if value == 0:
        return "0"
    step = 10 ** (math.floor(math.log10(abs(value))) - 1)
    nearest = round(value / step) * step
    return count(nearest) if nearest >= 10 else f"{nearest:.2g}"


def spread_of(counters: Counters | None, counter: str) -> float | None:
    """(highest - lowest) / median of the repetitions; None where there is but one."""
    if not counters or counter not in counters or counters["repetitions"][0] < 2 or not counters[counter][0]:
        return None
    middle, lowest, highest = counters[counter]
    return (highest - lowest) / middle


def worst_spread(cells: Iterable[tuple[Counters | None, str]]) -> float | None:
    """The worst spread of some benchmarks' counters; None where nothing was repeated."""
    return max((spread for counters, counter in cells if (spread := spread_of(counters, counter)) is not None), default=None)


def count_short(value: float) -> str:
    """100000 as "100 k", 4000000 as "4 M"."""
    if value >= 1e6:
        return f"{value / 1e6:.3g} M"
    return f"{value / 1e3:.3g} k" if value >= 1e3 else f"{value:.0f}"


def plain(value: Any) -> str:
    return str(value)


def digits(number: int) -> Formatter:
    return lambda value: f"{value:.{number}f}"


def percent(value: float) -> str:
    """Of a share; rounding errors of doubles are 0."""
    if abs(value) < 1e-9:
        return "0"
    return f"{100 * value:.2g} %" if abs(value) < 0.1 else f"{100 * value:,.0f} %"


def scientific(value: float) -> str:
    return "0" if value == 0 else f"{value:.1e}"


@dataclass(frozen=True)
class Column:
    """`key` heads the column in the CSV, `title` on the page."""

    key: str
    title: str
    show: Formatter = plain


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
        return [[ABSENT if row.get(column.key) is None else column.show(row[column.key]) for column in self.columns]
                for row in self.rows]


def short(backend: str) -> str:
    return backend.split("/")[-1]


def median(counters: Counters | None, counter: str) -> float | None:
    return counters[counter][0] if counters and counter in counters else None
