"""Preparing a mesh, what it costs, and when it is paid back."""

from report.chapters.section import Facts, Part, Section, ShownFigure, ShownTable
from report.measurements import Measurements
from report.tables.numbers import count_short, digits, rounded, timed
from report.tables.prepare_tables import (chain_balance_table, choice_table, from_arrays_table, prepare_table,
                                           prepare_threads_table)
from report.tables.table import Table


def write(found: Measurements, machine: dict[str, str], facts: Facts) -> list[Section]:
    if not found.growth("Scale", "asteroid"):
        return []
    table, balance = prepare_table(found), chain_balance_table(found)
    rows = [row for row in table.rows if row["backend"] == "halfedge" and row.get("paid_back_remap")]
    parts: list[Part] = [
        ShownFigure("prepare", "Preparing once and then cutting. Solid: copies of the whole, each cut once. Dashed: "
                    "one object cut to pieces. If lines of a kind cross, preparing is paid back "
                    "there.", published=True),
        "The half-edge back end sorts triangles, links half-edges, builds a tree and reserves memory before the first "
        "cut. The viewer prepares on a worker, so that no frame waits for it."]
    if rows:
        row = rows[-1]
        parts.append(f"**Many copies of one object**, each cut once, as a game throws them: at "
                     f"{facts.say('size', row['triangles'], count_short)} triangles preparing costs "
                     f"{facts.say('prepare ms', row['prepare_ms'], timed)} ms. It is paid back after "
                     f"{facts.say('cuts', row['paid_back_remap'], rounded)} cuts against `remap` (copying is not "
                     "counted).")
    if balance.rows:
        parts.append("**One object cut to pieces**: a cut consumes its object, pieces get smaller, and there is less "
                     f"and less to save. {paid_back_in_chains(balance, facts)}")
    parts.append(ShownTable(table, "Preparing, the bytes that the program holds more of afterwards, and after how "
                            "many cuts of fresh copies it is paid back (– : never).", published=True))
    if balance.rows:
        parts.append(ShownTable(balance, "One object cut to pieces, whole chain and cut() alone, ms for all cuts so "
                                "far. A balance above zero: preparing is paid back.", folded=True))
    parts += threads_and_arrays(found, facts)
    choice = choice_table(found)
    if choice.rows:
        worst = max(choice.rows, key=lambda row: row["worst"])
        parts.append("**The choice.** `prepare()` chooses a back end by the number of cuts that the program announces. "
                     f"With everything that a game needs, preparing among it, the choice between `linear` and `halfedge` costs at most "
                     f"{facts.say('choice, worst', worst['worst'], digits(2))} times what the better one costs "
                     f"({worst['mesh']}, {facts.say('choice, worst size', worst['triangles'], count_short)} triangles)."
                     f"{against_fans(choice, facts)}")
        parts.append(ShownTable(choice, "The back end that is chosen, against the better of both: the time of so many "
                                "cuts of copies, preparing among it. Fans, the caps of `remap`, are never chosen: they are wrong "
                                "where a section is not star-shaped. The last column counts them as a third choice.", folded=True))
    return [Section("prepare", "Preparing, and the memory it takes", parts)]


def against_fans(choice: Table, facts: Facts) -> str:
    """What the choice costs whom wrong caps are right for."""
    rows = [row for row in choice.rows if row.get("worst_to_best")]
    if not rows:
        return ""
    row = max(rows, key=lambda row: row["worst_to_best"])
    return (f" If the fans of `remap` counted as a third choice it would be "
            f"{facts.say('choice with fans, worst', row['worst_to_best'], digits(2))} at most ({row['mesh']}).")


def threads_and_arrays(found: Measurements, facts: Facts) -> list[Part]:
    parts: list[Part] = []
    threads, arrays = prepare_threads_table(found), from_arrays_table(found)
    if threads.rows:
        row = threads.rows[-1]
        parts += [f"**Two threads** prepare {facts.say('threads, size', row['triangles'], count_short)} triangles in "
                  f"{facts.say('threads, to one', row['two_to_one'], digits(2))} times the time of one.",
                  ShownTable(threads, "Preparing by `PrepareOptions::threads`, the time that passes.", published=True)]
    if arrays.rows:
        parts.append(ShownTable(arrays, "From a program's arrays to an object: `Mesh::make()` checks and joins them, "
                                "`prepare()` makes them ready to be cut.", published=True))
    return parts


def paid_back_in_chains(balance: Table, facts: Facts) -> str:
    """Between which marks of the largest chain the balance turns."""
    size = max(row["triangles"] for row in balance.rows)
    rows = [row for row in balance.rows if row["triangles"] == size]
    text = f"Of {facts.say('chain size', size, count_short)} triangles, always the largest piece cut, "
    text += f"preparing is {turns_text(rows, '', facts)}."
    if "extra_on_two_ms" in rows[-1]:
        text += f" By two threads it is {turns_text(rows, 'on_two_', facts)}."
    return text


def turns_text(rows: list[dict], how: str, facts: Facts) -> str:
    """When it is paid back, with everything and counting cut() alone; `how` is part of the columns' names."""
    whole, cutting = (turn_text(f"{key}, cuts", chain_turn(rows, key), rows[-1]["cuts"], facts)
                      for key in (f"balance_{how}ms", f"cutting_balance_{how}ms"))
    if whole == cutting:
        return f"{whole}, with everything a game needs as for cut() alone"
    return f"{whole} with everything a game needs, and {cutting} counting cut() alone"


def turn_text(name: str, turn: tuple[float, float] | None, most: float, facts: Facts) -> str:
    if turn is None:
        return f"not paid back within {facts.say(f'{name}, most', most, digits(0))} cuts"
    if turn[0] == 0:
        return "paid back by the first cut"
    return (f"paid back between {facts.say(f'{name}, before', turn[0], digits(0))} and "
            f"{facts.say(f'{name}, after', turn[1], digits(0))} cuts")


def chain_turn(rows: list[dict], key: str) -> tuple[float, float] | None:
    """The marks between which a balance turns from loss to gain for good; 0 as the first if it is a gain from the
    start, None if it never is one."""
    if rows[-1][key] <= 0:
        return None
    losses = [number for number, row in enumerate(rows) if row[key] <= 0]
    return (rows[losses[-1]]["cuts"], rows[losses[-1] + 1]["cuts"]) if losses else (0, rows[0]["cuts"])
