"""Which function draws which figure.

A figure is a function of all tables (by name) and gives a Drawing, or None when what it shows was not measured.
"""

from typing import Any, Callable

from report.plots import (cap_plots, chain_plots, distribution_plots, growth_plots, model_plots, peer_plots,
                          phase_plots, prepare_plots, proxy_plots, section_plots)
from report.plots.drawing import Drawing
from report.tables.table import Table

FIGURES: dict[str, Callable[..., Drawing | None]] = {
    "models": model_plots.times_by_size,
    "report_growth": model_plots.report_growth,
    "scaling": growth_plots.scaling,
    "crossing": growth_plots.crossing,
    "counters": growth_plots.counters,
    "phases": phase_plots.phases,
    "prepare": prepare_plots.prepare,
    "fan_errors": cap_plots.fan_errors,
    "gallery": cap_plots.gallery,
    "angles": cap_plots.angles,
    "chain_ranges": chain_plots.chain_ranges,
    "chain_times": chain_plots.chain_times,
    "proxies": proxy_plots.proxies,
    "distribution": distribution_plots.distribution,
    "viewer_cuts": distribution_plots.viewer_cuts,
    "peers": peer_plots.peers,
    "sections": section_plots.sections,
}


def draw(name: str, arguments: tuple[Any, ...], tables: dict[str, Table]) -> Drawing | None:
    return FIGURES[name](tables, *arguments)
