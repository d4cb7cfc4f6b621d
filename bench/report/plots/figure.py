"""Figures by matplotlib."""

import io
import re
from typing import Any, Sequence

import matplotlib

matplotlib.use("svg")  # no display is needed

from matplotlib import pyplot  # noqa: E402  (the backend is chosen first)
from matplotlib.axes import Axes  # noqa: E402
from matplotlib.figure import Figure  # noqa: E402
from matplotlib.ticker import FuncFormatter, LogLocator  # noqa: E402

from report.plots.drawing import Drawing
from report.plots.palette import COLOURS, style_of
from report.plots.svg_text import shortened

WIDTH, HEIGHT = 4.2, 3.3  # inches: less than the width of a phone's screen, so that texts are not made smaller there
GROUP_ID = re.compile(r'<g id="[A-Za-z]+[._0-9A-Za-z]*">')


def token(name: str) -> str:
    return COLOURS[name].token


def new_figure(width: float = WIDTH, height: float = HEIGHT, rows: int = 1, columns: int = 1, **options):
    """Figure and axes in the page's style."""
    ink, muted, grid = token("ink"), token("muted"), token("grid")
    pyplot.rcParams.update({
        "svg.fonttype": "none", "font.family": "sans-serif", "font.sans-serif": ["DejaVu Sans"], "font.size": 10,
        "text.color": ink, "axes.labelcolor": ink, "axes.edgecolor": muted, "axes.titlecolor": ink,
        "axes.titlesize": 10.5,
        "axes.titleweight": "bold", "axes.titlelocation": "left", "axes.spines.top": False, "axes.spines.right": False,
        "axes.grid": True, "axes.axisbelow": True, "grid.color": grid, "grid.linewidth": 0.8, "xtick.color": muted,
        "ytick.color": muted, "xtick.labelcolor": ink, "ytick.labelcolor": ink, "legend.frameon": False,
        "legend.fontsize": 9, "figure.facecolor": "none", "axes.facecolor": "none", "savefig.facecolor": "none",
        "lines.linewidth": 1.8, "lines.markersize": 5.5, "figure.constrained_layout.use": True, "hatch.color": ink,
        "patch.edgecolor": ink})
    return pyplot.subplots(rows, columns, figsize=(width, height), **options)


def finished(name: str, figure: Figure) -> Drawing:
    """The figure as SVG. The same figure gives the same text on every run."""
    out = io.StringIO()
    pyplot.rcParams["svg.hashsalt"] = name  # ids are equal only where content is
    figure.savefig(out, format="svg", metadata={"Date": None, "Creator": None, "Type": None, "Format": None})
    pyplot.close(figure)
    text = out.getvalue()
    text = text[text.index("<svg"):]
    text = re.sub(r"<metadata>.*?</metadata>\s*", "", text, flags=re.DOTALL)
    text = GROUP_ID.sub("<g>", text)  # several figures share a page: ids must not repeat
    text = re.sub(r' width="[\d.]+pt"| height="[\d.]+pt"', "", text, count=2)
    text = text.replace("'DejaVu Sans'", "var(--font, 'DejaVu Sans'), sans-serif").replace("\n", "")
    return Drawing(name, shortened(text))


def series(axes, name: str, label: str, x: Sequence[float], y: Sequence[float], **more: Any) -> None:
    style = style_of(name)
    axes.plot(x, y, color=style.token, marker=style.marker, linestyle=style.dashes, label=label, **more)


def legend_above(axes: Axes, columns: int = 3) -> None:
    """Above the plot, where no line runs through it."""
    axes.legend(loc="lower left", bbox_to_anchor=(-0.14, 1.0), ncols=columns, handlelength=2.4, columnspacing=1.0,
                handletextpad=0.5, borderaxespad=0.2)


def more_ticks(axes: Axes) -> None:
    """Labels at 1, 2 and 5 of each decade of the y axis, where it spans so few that decades alone would say little."""
    axes.yaxis.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0)))
    axes.yaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))


def log_log(axes: Axes, x: str, y: str) -> None:
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.set_xlabel(x)
    axes.set_ylabel(y)
    axes.grid(True, which="major")
    axes.minorticks_off()
