"""What the half-edge back end does worst, in a few sentences: its worst frame, the tail of its cuts, preparing."""

from report.chapters.prepare import paid_back_in_chains
from report.chapters.section import Facts
from report.measurements import Measurements
from report.tables.chain_tables import chain_decades_table
from report.tables.distribution_tables import distribution_table
from report.tables.model_tables import worst_frames_table
from report.tables.numbers import count_short, milliseconds
from report.tables.prepare_tables import chain_balance_table

HALF, LINEAR = "halfedge", "baseline/remap"


def unflattering(found: Measurements, facts: Facts) -> str:
    return " ".join(part for part in (frames(found, facts), tail(found, facts), longest(found, facts), paid_back(found, facts)) if part)


def frames(found: Measurements, facts: Facts) -> str:
    rows = [row for row in worst_frames_table(found).rows if row.get(f"{HALF}_ms") and row.get(f"{LINEAR}_ms")]
    if not rows:
        return ""
    worst = max(rows, key=lambda row: row[f"{HALF}_ms"])
    slower = sum(row[f"{HALF}_ms"] > row[f"{LINEAR}_ms"] for row in rows)
    return (f"In the viewer its worst frame, {facts.say('worst frame ms', worst[f'{HALF}_ms'], milliseconds)} ms of processor time for "
            f"physics and cutting, is with the {worst['model']}, where `remap`'s is {facts.say('remap worst frame ms', worst[f'{LINEAR}_ms'], milliseconds)} "
            f"ms; of {facts.say('models with frames', len(rows), count_short)} models it has the longer worst frame in "
            f"{facts.say('models with the longer worst frame', slower, count_short)}.")


def tail(found: Measurements, facts: Facts) -> str:
    """Sizes at which its slowest cut of many is slower than the linear method's."""
    rows = {(row["backend"], row["triangles"]): row for row in distribution_table(found).rows}
    said = []
    for (backend, size), row in rows.items():
        linear = rows.get((LINEAR, size))
        if backend == HALF and linear and row["worst_ms"] > linear["worst_ms"]:
            said.append(f"{facts.say(f'worst of many ms, {size}', row['worst_ms'], milliseconds)} ms against "
                        f"{facts.say(f'remap worst of many ms, {size}', linear['worst_ms'], milliseconds)} at "
                        f"{facts.say(f'size with the worse tail, {size}', size, count_short)}")
    return f"Its slowest of many cuts is the slower one: {', '.join(said)} triangles." if said else ""


def longest(found: Measurements, facts: Facts) -> str:
    """The worst cut of a chain of a thousand, when it is the half-edge back end's."""
    rows = [row for row in chain_decades_table(found).rows if row["mode"] == "kept"]
    worst = {name: max((row for row in rows if row["backend"] == name), key=lambda row: row["worst_cut_ms"], default=None)
             for name in (HALF, LINEAR)}
    half, linear = worst[HALF], worst[LINEAR]
    if not half or not linear or half["worst_cut_ms"] < linear["worst_cut_ms"]:
        return ""
    return (f"In a chain of a thousand cuts one takes {facts.say('worst of a chain ms', half['worst_cut_ms'], milliseconds)} ms "
            f"(`remap`'s worst: {facts.say('remap worst of a chain ms', linear['worst_cut_ms'], milliseconds)}): the reserved room is used "
            "up, and all buffers move.")


def paid_back(found: Measurements, facts: Facts) -> str:
    balance = chain_balance_table(found)
    return "An object that is cut to pieces pays preparing back late: " + decapitalised(paid_back_in_chains(balance, facts)) if balance.rows else ""


def decapitalised(text: str) -> str:
    return text[:1].lower() + text[1:]
