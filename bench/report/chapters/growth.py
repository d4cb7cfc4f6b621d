"""How cost grows with the mesh."""

from report.measurements import Measurements
from report.sections import Facts, Section, ShownFigure, ShownTable
from report.tables import (EXTENTS, ORDERS, count_short, counters_table, counter_exponents_table, crossing_table,
                           crossovers_table, digits, milliseconds, phases_table, prepare_table, scaling_table)

WHAT = {"Scale": "Whole chain: two closed fragments with all attributes, volume, centre of mass and inertia, a bounded hull "
                 "each, draw ranges and the bytes to upload.",
        "Geometry": "Geometry only: two closed fragments with all attributes."}


def write(found: Measurements, machine: dict[str, str], facts: Facts) -> list[Section]:
    if not found.growth("Scale", "asteroid"):
        return []
    return [scaling(found, facts), crossing(found, facts), phases(found), prepare(found, facts)]


def scaling(found: Measurements, facts: Facts) -> Section:
    parts: list = [headline(found, facts),
                   "An asteroid of every size is cut by seeded random planes through its middle, a fresh copy for each cut; copying "
                   "and destroying stay untimed. *e* is the exponent in time ~ trianglesᵉ, fitted from 10 000 triangles up, with "
                   "the half width of its 95 % confidence interval. In coherent order neighbours in space are neighbours in the "
                   "file, as programs write them; in random order they are not, which costs a linear method its caches. "
                   "The quadratic methods stop at 30 000 triangles, where one cut takes most of a second."]
    for kind, _ in EXTENTS:
        parts.append(f"**{WHAT[kind]}**")
        for shape, order in ORDERS:
            if not found.growth(kind, shape):
                continue
            table = scaling_table(found, kind, shape)
            parts += [ShownFigure("scaling", f"{'Whole chain' if kind == 'Scale' else 'Geometry only'}, {order} order.",
                                  arguments=(kind, shape), published=kind == "Scale" and shape == "asteroid"),
                      ShownTable(table, f"ms per cut by triangles, {order} order; spread: (highest − lowest) / median of the "
                                 "repetitions, the worst of the row's sizes.", published=shape == "asteroid")]
    parts.append(ShownTable(crossovers_table(found), "From which size on the half-edge back end takes less time.", published=True))
    return Section("scaling", "How the cost of a cut grows", parts)


def headline(found: Measurements, facts: Facts) -> str:
    table = scaling_table(found, "Scale", "asteroid")
    rows = {row["backend"]: row for row in table.rows}
    half, linear = rows.get("halfedge"), rows.get("baseline/remap")
    sizes = [int(column.key[3:]) for column in table.columns if column.key.startswith("ms_")]
    shared = [size for size in sizes if half and linear and half.get(f"ms_{size}") and linear.get(f"ms_{size}")]
    if not shared:
        return ""
    size = shared[-1]
    ours, theirs = half[f"ms_{size}"], linear[f"ms_{size}"]
    text = (f"At {facts.say('largest size', size, count_short)} triangles a cut with everything a game needs takes "
            f"{facts.say('halfedge ms', ours, milliseconds)} ms with the half-edge back end and "
            f"{facts.say('remap ms', theirs, milliseconds)} ms with the best linear one: "
            f"{facts.say('remap to halfedge', theirs / ours, digits(1))} times as much.")
    # From three sizes the interval is too wide to say anything.
    if half.get("exponent_points", 0) > 3 and linear.get("exponent_points", 0) > 3:
        text += (f" Its time grows as triangles to the power of {facts.say('halfedge e', half['exponent'], digits(2))} ± "
                 f"{facts.say('halfedge e half width', half['exponent_half_width'], digits(2))}; the linear one's as "
                 f"{facts.say('remap e', linear['exponent'], digits(2))} ± "
                 f"{facts.say('remap e half width', linear['exponent_half_width'], digits(2))}. A plane crosses about √n of "
                 f"n triangles, so an exponent of one half is what a method that touches only those can reach.")
    return text


def crossing(found: Measurements, facts: Facts) -> Section:
    return Section("crossing", "What a crossing triangle costs", [
        "Counters say more than times: they are exact, the same on every run and machine, and checked in the tests. For the "
        "half-edge back end all of them grow with the square root of the mesh, because they count what the plane meets: "
        "triangle records read or written, nodes of the tree looked at, bytes that the graphics card does not have yet.",
        ShownFigure("counters", "Exact counters of one cut, mean of the planes. The dotted line is a method that looks at every triangle."),
        ShownFigure("crossing", "Time of the whole chain by triangle crossed: no more in a large mesh than in a small one, "
                    "apart from fixed costs (left) and caches (right)."),
        ShownTable(crossing_table(found), "Half-edge, asteroid in coherent order, for each crossing triangle.", published=True),
        ShownTable(counters_table(found), "The counters themselves.", folded=True),
        ShownTable(counter_exponents_table(found), "Exponents of the counters in the number of triangles.", published=True)])


def phases(found: Measurements) -> Section:
    return Section("phases", "Where the time goes", [
        "The linear methods spend it copying triangles that the plane does not meet; the half-edge back end finds, "
        "splits, caps and rebuilds along the section. *find*: which triangles are on which side; *walk*: following the section; "
        "*split*: new vertices and pieces; *copy*: untouched triangles; *cap*: closing the section; *rebuild*: trees and "
        "draw ranges; *mass*: volume, centre and inertia; *proxy*: bounded hulls; *draw*: draw ranges and what to upload. "
        "Phases are read from the wall clock, so their sum can exceed the processor time above on a busy machine.",
        ShownFigure("phases", "Phases of the whole chain."),
        ShownTable(phases_table(found), "ms in each phase, and bytes to upload.", folded=True)])


def prepare(found: Measurements, facts: Facts) -> Section:
    table = prepare_table(found)
    rows = [row for row in table.rows if row["backend"] == "halfedge" and row.get("paid_back_remap")]
    parts: list = [
        "The half-edge back end sorts triangles, links half-edges, builds a tree and reserves memory before the first cut. "
        "Bytes are what the program holds more of afterwards, vertices and indices included."]
    if rows:
        row = rows[-1]
        parts.append(f"At {facts.say('size', row['triangles'], count_short)} triangles preparing costs "
                     f"{facts.say('prepare ms', row['prepare_ms'], milliseconds)} ms and is paid back after "
                     f"{facts.say('cuts', row['paid_back_remap'], digits(0))} cuts against `remap`. An object that is cut "
                     "once and thrown away should be cut by a linear method, unless preparing happens while a level loads.")
    parts += [ShownFigure("prepare", "Preparing once and then cutting: where lines cross, preparing is paid back."),
              ShownTable(table, "Preparing, memory, and after how many cuts it is paid back (– : never).", published=True)]
    return Section("prepare", "Preparing, and the memory it takes", parts)
