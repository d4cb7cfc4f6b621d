"""Meshes that are not round: scanned ones, and sections of many loops."""

from report.chapters.section import Facts, Part, Section, ShownTable
from report.measurements import Measurements
from report.tables.numbers import count, digits
from report.tables.real_tables import real_chains_table, real_cuts_table


def write(found: Measurements, machine: dict[str, str], facts: Facts) -> list[Section]:
    cuts, chains = real_cuts_table(found), real_chains_table(found)
    if not cuts.rows:
        return []
    parts: list[Part] = [
        "An asteroid is round, and its sections are one loop. These meshes are not: `brain` is a folded surface from a "
        "scanner, `skull` a scan with holes, `cheese` and `sponge` are full of tunnels, so a section has many loops, one "
        "inside another. `folded`, a wall that is rolled up, and `tunnels`, a sponge, are generated; the others are "
        "measured where their files are.",
        asteroids(cuts.rows, facts), faster(chains.rows, facts)]
    parts += [ShownTable(cuts, "cut() alone: ms, mean of five seeded planes through the middle. `remap` closes with a fan, "
                         "which is mostly wrong here; `linear` is the same loop with right caps.", published=True),
              ShownTable(chains, "The whole chain: two closed pieces, masses, bounded hulls and draw views; ms.",
                         published=True)]
    return [Section("real", "Real meshes", [part for part in parts if part])]


def asteroids(rows: list[dict], facts: Facts) -> str:
    known = [row for row in rows if row.get("to_asteroid")]
    if not known:
        return ""
    worst = max(known, key=lambda row: row["to_asteroid"])
    return (f"For each triangle that the plane crosses, the half-edge back end takes at most "
            f"{facts.say('real mesh to asteroid, worst', worst['to_asteroid'], digits(2))} times what it takes on an "
            f"asteroid of the same size ({worst['mesh']}): sections inside others are closed by bridges and ears, not by "
            "a general triangulation.")


def faster(rows: list[dict], facts: Facts) -> str:
    known = [row for row in rows if row.get("halfedge_ms") and row.get("linear_ms")]
    if not known:
        return ""
    wins = [row for row in known if row["halfedge_ms"] < row["linear_ms"]]
    most = max(known, key=lambda row: row["linear_ms"] / row["halfedge_ms"])
    return (f"With everything that a game needs it is faster than `linear` on "
            f"{facts.say('real meshes that halfedge cuts faster', len(wins), count)} of "
            f"{facts.say('real meshes', len(known), count)}, by a factor of up to "
            f"{facts.say('linear to halfedge, most', most['linear_ms'] / most['halfedge_ms'], digits(1))} "
            f"({most['mesh']}).")
