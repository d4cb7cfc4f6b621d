"""What the half-edge back end does worst, in a few sentences: its worst frame and the tail of its cuts."""

from report.chapters.section import Facts
from report.measurements import Measurements
from report.tables.chain_tables import chain_decades_table
from report.tables.distribution_tables import distribution_table
from report.tables.model_tables import worst_frames_table
from report.tables.numbers import count_short, timed

HALF, LINEAR = "halfedge", "baseline/remap"


def frames(found: Measurements, facts: Facts) -> str:
    table = worst_frames_table(found).rows
    rows = [row for row in table if row.get(f"{HALF}_ms") and row.get(f"{LINEAR}_ms")]
    if not rows:
        return ""
    worst = max(rows, key=lambda row: row[f"{HALF}_ms"])
    slower = sum(row[f"{HALF}_ms"] > row[f"{LINEAR}_ms"] for row in rows)
    ours, theirs = worst[f"{HALF}_ms"], worst[f"{LINEAR}_ms"]
    undrawn = [row for row in table if row.get(f"{HALF}_undrawn_ms") and row.get(f"{LINEAR}_undrawn_ms")]
    slower_undrawn = sum(row[f"{HALF}_undrawn_ms"] > row[f"{LINEAR}_undrawn_ms"] for row in undrawn)
    without = (f", and without drawing, as with a graphics card, in "
               f"{facts.say('models with the longer worst frame, not drawn', slower_undrawn, count_short)}"
               if undrawn else "")
    return (f"In the viewer its worst frame takes {facts.say('worst frame ms', ours, timed)} ms of processor time for "
            f"physics and cutting, with the {worst['model']}; `remap`'s takes "
            f"{facts.say('remap worst frame ms', theirs, timed)} ms there. Of "
            f"{facts.say('models with frames', len(rows), count_short)} models it has the longer worst frame in "
            f"{facts.say('models with the longer worst frame', slower, count_short)}{without}.")


def tail(found: Measurements, facts: Facts) -> str:
    """Sizes at which its slowest cut of many is slower than the linear method's."""
    rows = {(row["backend"], row["triangles"]): row for row in distribution_table(found).rows}
    said = []
    for (backend, size), row in rows.items():
        linear = rows.get((LINEAR, size))
        if backend == HALF and linear and row["worst_ms"] > linear["worst_ms"]:
            said.append(f"{facts.say(f'worst of many ms, {size}', row['worst_ms'], timed)} ms against "
                        f"{facts.say(f'remap worst of many ms, {size}', linear['worst_ms'], timed)} at "
                        f"{facts.say(f'size with the worse tail, {size}', size, count_short)}")
    return f"Its slowest of many cuts is the slower one: {', '.join(said)} triangles." if said else ""


def longest(found: Measurements, facts: Facts) -> str:
    """The worst cut of a chain of a thousand, at sizes at which it is the half-edge back end's."""
    worst: dict[tuple[str, float], float] = {}
    for row in chain_decades_table(found).rows:
        if row["mode"] == "kept":
            key = (row["backend"], row["triangles"])
            worst[key] = max(worst.get(key, 0.0), row["worst_cut_ms"])
    said = []
    for (backend, size), half in worst.items():
        linear = worst.get((LINEAR, size))
        if backend == HALF and linear and half > linear:
            said.append(f"{facts.say(f'worst of a chain ms, {size:.0f}', half, timed)} ms at "
                        f"{facts.say(f'size of the worse chain, {size:.0f}', size, count_short)} triangles (`remap`'s worst: "
                        f"{facts.say(f'remap worst of a chain ms, {size:.0f}', linear, timed)} ms)")
    return (f"In a chain of a thousand cuts one takes {', '.join(said)}: the reserved room is used up, and buffers move."
            if said else "")
