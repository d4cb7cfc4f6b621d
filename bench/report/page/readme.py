"""The part of README.md that shows results: one figure, one table, and where the half-edge back end is not better."""

from report.chapters.section import Section
from report.tables.numbers import ABSENT, count_short, digits, short, timed
from report.tables.table import Column, Table, Value

BEGIN = "<!-- results: written by ./run report --publish -->"
END = "<!-- results end -->"
SIZES = (1_000, 10_000, 100_000, 1_000_000, 4_000_000, 16_000_000)
SHOWN_LIMITS = 4  # what weighs most; docs/results.md has the rest
PICTURE = "docs/images/results_scaling_scale_asteroid"


def exponent_text(row: dict[str, Value]) -> str:
    """With its interval, and the slopes from size to size."""
    if row.get("exponent") is None:
        return ABSENT
    text = digits(2)(row["exponent"])
    if row.get("exponent_half_width") is not None:
        text += " ± " + digits(2)(row["exponent_half_width"])
    if row.get("least_slope") is not None:
        text += f" ({digits(2)(row['least_slope'])} to {digits(2)(row['most_slope'])})"
    return text


def shown_sizes(scaling: Table) -> list[int]:
    there = {column.key for column in scaling.columns}
    return [size for size in SIZES if f"ms_{size}" in there]


def table_lines(scaling: Table) -> list[str]:
    """The scaling table with fewer sizes."""
    sizes = shown_sizes(scaling)
    heads = ["ms per cut", *(count_short(size) for size in sizes), "time ~ triangles^e (from size to size)"]
    lines = ["| " + " | ".join(heads) + " |", "|---|" + "--:|" * len(sizes) + "---|"]
    for row in scaling.rows:
        cells = [Column(f"ms_{size}", count_short(size), timed).cell(row) for size in sizes]
        lines.append("| " + " | ".join([f"`{short(row['backend'])}`", *cells, exponent_text(row)]) + " |")
    return lines


def results_block(scaling: Table, limits: Section | None, processor: str) -> str:
    """What stands between the two marks."""
    sizes = [count_short(size) for size in shown_sizes(scaling)]
    lines = [f'<picture><source media="(prefers-color-scheme: dark)" srcset="{PICTURE}_dark.svg">'
             '<img alt="Time of a cut by the size of the mesh, one line a back end" '
             f'src="{PICTURE}_light.svg" width="520"></picture>', "",
             f"An asteroid of {sizes[0]} to {sizes[-1]} triangles is cut through its middle. The time includes all "
             "that a game needs of the two pieces: closed meshes with all attributes, mass properties, collision hulls, "
             f"draw ranges. Processor: {processor.partition(',')[0]}, one thread.", "", *table_lines(scaling)]
    if limits:
        shown = [part for part in limits.parts if isinstance(part, str)][:SHOWN_LIMITS]
        anchor = limits.title.lower().replace(" ", "-")
        lines += ["", f"**{limits.title}** ([all of "
                      f"it](docs/results.md#{anchor})):", "", *(f"* {text}" for text in shown)]
    return "\n".join(lines)


def with_results(readme: str, block: str) -> str:
    """The README with its results replaced. Raises ValueError when the marks are not there."""
    before, begin, rest = readme.partition(BEGIN)
    _, end, after = rest.partition(END)
    if not begin or not end:
        raise ValueError("README.md has no marks for the results")
    return f"{before}{BEGIN}\n{block}\n{END}{after}"
