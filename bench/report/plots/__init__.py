"""Every figure of the page, drawn from its tables: what is plotted is in a CSV too.

A figure is a function of all tables (by name) and gives a Drawing, or None when what it shows was not measured.
"""

from typing import Any, Callable

from report.drawing import Drawing
from report.plots import caps, growth, models, pieces
from report.tables import Table

FIGURES: dict[str, Callable[..., Drawing | None]] = {
    "models": models.times_by_size,
    "report_growth": models.report_growth,
    "scaling": growth.scaling,
    "crossing": growth.crossing,
    "counters": growth.counters,
    "phases": growth.phases,
    "prepare": growth.prepare,
    "fan_errors": caps.fan_errors,
    "gallery": caps.gallery,
    "angles": caps.angles,
    "chain_ranges": pieces.chain_ranges,
    "chain_times": pieces.chain_times,
    "proxies": pieces.proxies,
    "distribution": pieces.distribution,
    "viewer_cuts": pieces.viewer_cuts,
    "peers": growth.peers,
}


def draw(name: str, arguments: tuple[Any, ...], tables: dict[str, Table]) -> Drawing | None:
    return FIGURES[name](tables, *arguments)
