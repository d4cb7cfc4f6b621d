"""How the cost of a cut grows with the mesh, and what it is spent on."""

from report.chapters.section import Facts, Part, Section, ShownFigure, ShownTable
from report.measurements import Measurements
from report.names import QUADRATIC
from report.repetitions import median
from report.tables.growth_tables import (EXTENTS, ORDERS, counter_exponents_table, counters_table, crossing_table,
                                         crossovers_table, phases_table, scaling_points_table, scaling_table)
from report.tables.numbers import count_short, digits, percent, rounded, timed
from report.tables.table import Table

LEAF_PHASES = ("find", "split", "rebuild")  # of the half-edge back end: they read and write leaves
WHAT = {"Scale": "**Whole chain**: two closed fragments with all attributes, volume, centre of mass and inertia, a "
                 "bounded hull each, draw ranges and the bytes to upload.",
        "Geometry": "**Geometry only**: two closed fragments with all attributes."}


def write(found: Measurements, machine: dict[str, str], facts: Facts) -> list[Section]:
    if not found.growth("Scale", "asteroid"):
        return []
    return [scaling(found, facts), crossing(found, facts), phases(found, facts)]


def scaling(found: Measurements, facts: Facts) -> Section:
    parts: list[Part] = []
    for kind, extent in EXTENTS:
        # The figure of the whole chain in coherent order opens the page.
        shapes = [(shape, order) for shape, order in ORDERS if found.growth(kind, shape)]
        parts += [ShownFigure("scaling", f"{extent.capitalize()}, {order} order.", arguments=(kind, shape))
                  for shape, order in shapes if (kind, shape) != ("Scale", "asteroid")]
    parts += [headline(found, facts), exponents(found, facts)]
    for kind, _ in EXTENTS:
        parts.append(WHAT[kind])
        parts += [ShownTable(scaling_table(found, kind, shape), f"ms per cut by triangles, {order} order.", folded=True,
                             published=shape == "asteroid") for shape, order in ORDERS if found.growth(kind, shape)]
    parts.append(ShownTable(crossovers_table(found),
                            "From which size on the half-edge back end takes less time; the range is "
                            "what the repetitions' spread allows.", published=True))
    parts += [method(found, facts), dearer_alone(found, facts)]
    parts.append(ShownTable(scaling_points_table(found), "Every time above, with its planes, rounds over them, and the "
                            "range of its repetitions.", listing=True))
    return Section("scaling", "How the cost of a cut grows", [part for part in parts if part])


def method(found: Measurements, facts: Facts) -> str:
    return ("An asteroid of every size is cut by the same five seeded planes through its middle, in whole rounds over "
            "all of them. Each cut gets a fresh copy; copying and destroying it is not timed. The exponent is that of "
            "time ~ trianglesᵉ, fitted from 10 000 triangles up, with the half width of its 95 % confidence interval. "
            "A slope is the exponent between two neighbouring sizes. Spread is (highest − lowest) / median of the "
            "repetitions, the worst of the row. In coherent order, neighbours in space are neighbours in the file, as "
            "programs write them; random order costs a linear method its caches. " + quadratic(found, facts)).rstrip()


def dearer_alone(found: Measurements, facts: Facts) -> str:
    """Says how often the tables show the geometry alone at a longer time than the whole chain: noise, and called so."""
    whole, geometry = found.growth("Scale", "asteroid"), found.growth("Geometry", "asteroid")
    pairs = [(geometry[key]["real_time"][0], whole[key]["real_time"][0]) for key in geometry.keys() & whole.keys()]
    odd = [alone for alone, both in pairs if alone > both and timed(alone) != timed(both)]
    if not odd:
        return ""
    return (f"In coherent order, {facts.say('cells with dearer geometry', len(odd), digits(0))} of "
            f"{facts.say('cells of geometry', len(pairs), digits(0))} times of the geometry alone are longer than that of "
            "the whole chain of which it is a part. That is noise: mass properties and hulls cost less there than runs "
            "of the same cut differ by.")


def quadratic(found: Measurements, facts: Facts) -> str:
    """Where the quadratic look-ups stop."""
    cells = found.growth("Scale", "asteroid") | found.growth("Scale", "shuffled")
    last = max((size for name, size in cells if name == "baseline/scan"), default=None)
    if last is None:
        return ""
    times = [c["real_time"][0] for shape, _ in ORDERS for (name, size), c in found.growth("Scale", shape).items()
             if size == last and name in QUADRATIC]
    return (f"The quadratic look-ups stop at {facts.say('largest quadratic size', last, count_short)} triangles, "
            f"where a cut takes {facts.say('least quadratic ms', min(times), rounded)} to "
            f"{facts.say('most quadratic ms', max(times), rounded)} ms.")


def sizes_of(table: Table) -> list[int]:
    return [int(column.key[3:]) for column in table.columns if column.key.startswith("ms_")]


def at_largest(found: Measurements, kind: str) -> tuple[int, float, float] | None:
    """The largest size that both back ends have cut, and ms of `halfedge` and `remap` there."""
    table = scaling_table(found, kind, "asteroid")
    rows = {row["backend"]: row for row in table.rows}
    half, linear = rows.get("halfedge"), rows.get("baseline/remap")
    if not half or not linear:
        return None
    shared = [size for size in sizes_of(table) if half.get(f"ms_{size}") and linear.get(f"ms_{size}")]
    return (shared[-1], half[f"ms_{shared[-1]}"], linear[f"ms_{shared[-1]}"]) if shared else None


def headline(found: Measurements, facts: Facts) -> str:
    """How both compare at the largest size."""
    whole, geometry = at_largest(found, "Scale"), at_largest(found, "Geometry")
    if not whole:
        return ""
    size, ours, theirs = whole
    text = (f"At {facts.say('largest size', size, count_short)} triangles `remap` takes "
            f"{facts.say('remap to halfedge', theirs / ours, digits(1))} times as long as the half-edge back end.")
    if geometry and geometry[0] == size:
        _, ours, theirs = geometry
        text += (f" For the two closed pieces alone it takes "
                 f"{facts.say('remap to halfedge, geometry only', theirs / ours, digits(1))} times as long: "
                 f"{facts.say('remap geometry ms', theirs, timed)} against "
                 f"{facts.say('halfedge geometry ms', ours, timed)} ms. The rest of the difference is mass properties "
                 "and collision hulls: a tree keeps them, a linear method works them out anew.")
    return text


def exponents(found: Measurements, facts: Facts) -> str:
    """How both grow; nothing from three sizes, whose interval is too wide to say anything."""
    rows = {kind: {row["backend"]: row for row in scaling_table(found, kind, "asteroid").rows} for kind, _ in EXTENTS}
    half, geometry, linear = (rows[kind].get(name) for kind, name in (
        ("Scale", "halfedge"), ("Geometry", "halfedge"), ("Scale", "baseline/remap")))
    if not half or not linear or not geometry:
        return ""
    if min(row.get("exponent_points", 0) for row in (half, geometry, linear)) <= 3:
        return ""

    def fitted(name: str, row: dict) -> str:
        return (f"{facts.say(name, row['exponent'], digits(2))} ± "
                f"{facts.say(f'{name} half width', row['exponent_half_width'], digits(2))}")

    return (f"The half-edge back end's time grows as triangles to the power of {fitted('halfedge e', half)}; for the "
            f"geometry alone {fitted('halfedge e, geometry', geometry)}. `remap` fits no such line: its slope goes "
            f"from {facts.say('remap least slope', linear['least_slope'], digits(2))} to "
            f"{facts.say('remap greatest slope', linear['most_slope'], digits(2))} (a line through all of it: "
            f"{facts.say('remap e', linear['exponent'], digits(2))}), because small meshes have fixed costs and large "
            "ones leave the caches. A plane crosses about √n of n triangles, and a tree over them adds a logarithm: "
            "the best exponent to expect is slightly above 0.5.")


def crossing(found: Measurements, facts: Facts) -> Section:
    return Section("crossing", "What a crossing triangle costs", [
        ShownFigure("counters", "Exact counters of one cut, mean of the planes. The dotted line is a method that "
                    "looks at every triangle."),
        ShownFigure("crossing", "Time of the whole chain by triangle crossed: no more in a large mesh than in a small "
                    "one, apart from fixed costs (left) and caches (right)."),
        "Counters are exact: they are the same on every run and machine, and the tests hold fixed cuts to theirs. "
        "They count triangle records read or written, nodes of the tree looked at, and bytes that the graphics card "
        "does not have yet. Triangles and bytes grow as the section does, about as the square root of the mesh. Nodes "
        "grow a little faster, because a larger mesh has a deeper tree.",
        ShownTable(crossing_table(found), "Half-edge, asteroid in coherent order, for each crossing triangle.",
                   published=True, folded=True),
        ShownTable(counters_table(found), "The counters themselves.", folded=True),
        ShownTable(counter_exponents_table(found), "Exponents of the counters in the number of triangles.",
                   folded=True)])


def shares(found: Measurements, facts: Facts) -> str:
    """What the best linear method spends its time on, at the largest size of the figure."""
    rows = [row for row in phases_table(found).rows
            if row["backend"] == "baseline/remap" and row["triangles"] <= 1_000_000 and row["total_ms"]]
    if not rows:
        return ""
    row = rows[-1]
    named = [(name, row.get(f"{name}_ms") or 0.0) for name in ("mass", "find", "copy", "proxy")]
    listed = ", ".join(f"{name} {facts.say(f'share of {name}, remap', ms / row['total_ms'], percent)}"
                       for name, ms in sorted(named, key=lambda pair: -pair[1]))
    return (f"A linear method does everything for every triangle. Of `remap`'s time at "
            f"{facts.say('size of the shares', row['triangles'], count_short)} triangles: {listed}. ")


def stages_of_a_crossing_triangle(found: Measurements, facts: Facts) -> str:
    """What becomes dearer with the size of a mesh: what reads and writes leaves, which no cache holds any more."""
    rows = {row["triangles"]: row for row in phases_table(found).rows if row["backend"] == "halfedge"}
    crossing = {size: median(cell, "crossing") for (backend, size), cell in found.growth("Scale", "asteroid").items()
                if backend == "halfedge"}
    said = []
    for size in (size for size in sorted(rows) if size >= 100_000):
        k = crossing[size]
        if not k:
            return ""
        leaves = sum(rows[size].get(f"{name}_ms") or 0.0 for name in LEAF_PHASES) * 1e6 / k
        total = rows[size]["total_ms"] * 1e6 / k
        said.append(f"{facts.say(f'ns of leaves, {size}', leaves, rounded)} of "
                    f"{facts.say(f'ns of all phases, {size}', total, rounded)} at "
                    f"{facts.say(f'size of these phases, {size}', size, count_short)}")
    if not said:
        return ""
    return ("With the half-edge back end, *find*, *split* and *rebuild*, which read and write leaves, take "
            f"{', '.join(said)} triangles: ns for each that is crossed. ")


def phases(found: Measurements, facts: Facts) -> Section:
    return Section("phases", "Where the time goes", [
        ShownFigure("phases", "Phases of the whole chain, as shares of each back end's time; beside it the time in "
                    "all, by the wall clock, and megabytes to upload."),
        shares(found, facts) + "The half-edge back end finds, splits, caps and rebuilds along the section.",
        "*find*: which triangles are on which side; *walk*: following the section; *split*: new vertices and pieces; "
        "*copy*: untouched triangles; *cap*: closing the section; *rebuild*: trees and draw ranges; *components*: "
        "which parts a side consists of; *growth*: buffers moved because reserved room was used up; *mass*: volume, "
        "centre and inertia; *proxy*: bounded hulls; *draw*: draw ranges and what to upload. Phases are read from the "
        "wall clock: on a busy machine their sum can exceed the processor time above.",
        stages_of_a_crossing_triangle(found, facts) + "What stands before faster cuts, as profiles say, is in "
        "`docs/halfedge.md`, \"What stands before faster cuts\".",
        ShownTable(phases_table(found), "ms in each phase, their sum, and bytes to upload.", folded=True)])
