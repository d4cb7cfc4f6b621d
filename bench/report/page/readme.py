"""The part of README.md that shows results: one figure, one table, and where the half-edge back end is not better."""

from report.chapters.section import Section
from report.tables.numbers import ABSENT, count_short, digits, milliseconds, short
from report.tables.table import Table

BEGIN = "<!-- results: written by ./run report --publish -->"
END = "<!-- results end -->"
SIZES = (1_000, 10_000, 100_000, 1_000_000, 4_000_000, 16_000_000)


def table_lines(scaling: Table) -> list[str]:
    """The scaling table with fewer sizes."""
    there = {column.key for column in scaling.columns}
    sizes = [size for size in SIZES if f"ms_{size}" in there]
    lines = ["| ms per cut | " + " | ".join(count_short(size) for size in sizes) + " | time ~ triangles^e (from size to size) |",
             "|---|" + "--:|" * len(sizes) + "---|"]
    for row in scaling.rows:
        cells = [milliseconds(row[f"ms_{size}"]) if row.get(f"ms_{size}") is not None else ABSENT for size in sizes]
        exponent = ABSENT if row.get("exponent") is None else digits(2)(row["exponent"])
        if row.get("exponent_half_width") is not None:
            exponent += " ± " + digits(2)(row["exponent_half_width"])
        if row.get("least_slope") is not None:
            exponent += f" ({digits(2)(row['least_slope'])} to {digits(2)(row['most_slope'])})"
        lines.append(f"| `{short(str(row['backend']))}` | " + " | ".join(cells) + f" | {exponent} |")
    return lines


def results_block(scaling: Table, limits: Section | None, processor: str) -> str:
    """What stands between the two marks."""
    lines = ['<picture><source media="(prefers-color-scheme: dark)" srcset="docs/images/results_scaling_scale_asteroid_dark.svg">'
             '<img alt="Time of a cut by the size of the mesh, one line a back end" '
             'src="docs/images/results_scaling_scale_asteroid_light.svg" width="520"></picture>', "",
             "An asteroid of so many triangles, cut through its middle, with everything that a game needs of the two pieces: closed "
             f"meshes with all attributes, mass properties, collision hulls, draw ranges. One thread of {processor.partition(',')[0]}.", ""]
    lines += table_lines(scaling)
    if limits:
        lines += ["", f"**{limits.title}:**", ""] + [f"* {part}" for part in limits.parts if isinstance(part, str)]
    return "\n".join(lines)


def with_results(readme: str, block: str) -> str:
    """The README with its results replaced. Raises ValueError when the marks are not there."""
    before, begin, rest = readme.partition(BEGIN)
    _, end, after = rest.partition(END)
    if not begin or not end:
        raise ValueError("README.md has no marks for the results")
    return f"{before}{BEGIN}\n{block}\n{END}{after}"
