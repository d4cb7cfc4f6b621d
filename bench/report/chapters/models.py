"""The report's Tables 1 and 2, ours beside them, and how the report's own times grow."""

import statistics

from report import fits
from report.chapters.section import Facts, Part, Section, ShownFigure, ShownTable
from report.measurements import Measurements
from report.tables.model_tables import (cuts_table, frames_table, hulls_table, model_exponents_table, sizes_table,
                                        worst_frames_table)
from report.tables.numbers import count, digits, short
from report.tables.real_tables import model_chains_table


def write(found: Measurements, machine: dict[str, str], facts: Facts) -> list[Section]:
    cuts = cuts_table(found)
    if not any(row.get("halfedge_ms") for row in cuts.rows):
        return []
    return [times(found, facts), sizes(found), report_fit(found, facts), hulls(found), frames(found)]


def sizes(found: Measurements) -> Section:
    return Section("models", "The models", [
        "The report measured fifteen models that it does not publish. Ours are made by a program (`./run models`): "
        "the same kind of shape, the report's number of faces to within one, and nearly its vertices. A vertex is a "
        "combination of position, normal and uv, so seams count twice. The report's Cube row has its two columns "
        "swapped; here they are the right way round.",
        ShownTable(sizes_table(found), "The report's Table 1.")])


def times(found: Measurements, facts: Facts) -> Section:
    parts: list[Part] = [
        ShownFigure("models", "The report's Table 2, cutting: its laptop's times and ours. The report's rise more "
                    "steeply than a loop over triangles would.", published=True),
        "`scan` and `two_bucket_hash` are the two ways to look up vertices that the report describes. `hash` is the "
        "dictionary that it should have had. These three include its loop that rewrites every vertex around the new "
        "pivot. `remap` is the best linear method that we know: it looks up indices, not vertices. `halfedge` touches "
        "only what the plane meets."]
    parts += [text for text in (lookups(found, facts), small_models(found, facts), whole_chain(found, facts)) if text]
    parts.append(ShownTable(cuts_table(found), "The report's Table 2, cutting: ms per cut, mean of ten seeded random "
                            "planes through the model's middle. The report's times are its "
                            "laptop's.", published=True, folded=True))
    chains = model_chains_table(found)
    if chains.rows:
        parts.append(ShownTable(chains, "The whole chain on the same models: two closed pieces, masses, "
                                "bounded hulls and draw views; ms.", published=True, folded=True))
    return Section("table2", "Cutting the report's models", parts)


def lookups(found: Measurements, facts: Facts) -> str:
    factors = lookup_factors(found, facts)
    if not factors:
        return ""
    return ("What the report blamed on the number of triangles is its vertex look-up. On the same models and machine "
            + factors)


def small_models(found: Measurements, facts: Facts) -> str:
    """How the half-edge back end compares with the best linear method on models as small as the report's."""
    rows = [row for row in cuts_table(found).rows if row.get("halfedge_ms") and row.get("baseline/remap_ms")]
    if not rows:
        return ""
    ratio = statistics.median(row["halfedge_ms"] / row["baseline/remap_ms"] for row in rows)
    ours, theirs = (1e3 * statistics.median(row[f"{name}_ms"] for row in rows)
                    for name in ("halfedge", "baseline/remap"))
    return (f"On models as small as these **the half-edge back end is not the fastest**: it takes "
            f"{facts.say('halfedge to remap, median', ratio, digits(1))} times what `remap` takes (medians "
            f"{facts.say('halfedge microseconds, median', ours, digits(0))} and "
            f"{facts.say('remap microseconds, median', theirs, digits(0))} µs). A loop over a thousand triangles is "
            "hard to beat.")


def whole_chain(found: Measurements, facts: Facts) -> str:
    """The same with everything that a game needs of the pieces."""
    rows = [row for row in model_chains_table(found).rows if row.get("halfedge_ms")]
    said = []
    for backend in ("linear", "baseline/remap"):
        known = [row for row in rows if row.get(f"{backend}_ms")]
        if not known:
            continue
        wins = sum(row["halfedge_ms"] < row[f"{backend}_ms"] for row in known)
        ratio = statistics.median(row["halfedge_ms"] / row[f"{backend}_ms"] for row in known)
        name = short(backend)
        said.append(f"{facts.say(f'whole chain, halfedge to {name}, median', ratio, digits(2))} times what `{name}` takes, "
                    f"and less on {facts.say(f'models faster than {name}, whole chain', wins, count)} of "
                    f"{facts.say(f'models against {name}, whole chain', len(known), count)}")
    if not said:
        return ""
    return ("**With everything that a game needs** of the pieces, masses and hulls among it, it takes "
            + "; ".join(said) + " (medians).")


def lookup_factors(found: Measurements, facts: Facts) -> str:
    """What the look-up costs, in factors between back ends that differ in it; empty if one of them was not timed."""
    rows = [row for row in cuts_table(found).rows
            if all(row.get(f"baseline/{lookup}_ms") for lookup in ("scan", "two_bucket_hash", "hash", "remap"))]
    if not rows:
        return ""

    def factor(slower: str, faster: str) -> str:
        ratio = statistics.median(row[f"baseline/{slower}_ms"] / row[f"baseline/{faster}_ms"] for row in rows)
        return facts.say(f"{slower} to {faster}, median", ratio, digits(1))

    return (f"a hash that knows two buckets takes {factor('two_bucket_hash', 'hash')} times as long as one that tells "
            f"vertices apart, which is the same method but for the hash function. A list takes "
            f"{factor('scan', 'hash')} times as long. Indices in place of vertices (`remap`), without the loop over "
            f"the pivot, are {factor('hash', 'remap')} times quicker "
            "than the better hash (medians of the models).")


def report_fit(found: Measurements, facts: Facts) -> Section:
    table = model_exponents_table(found)
    report = next(row for row in table.rows if row["times"] == "the report's cut")
    return Section("report-growth", "Why the report's times grow faster than linearly", [
        ShownFigure("report_growth", "The report's times and the power of the number of faces that fits them."),
        f"The report's cut times grow as the number of faces to the power of "
        f"{facts.say('exponent of the report', report['exponent'], digits(2))} ± "
        f"{facts.say('its half width', report['half_width'] or 0.0, digits(2))} (95 % confidence; least squares in "
        "logarithms, all fifteen models). Its text says that the method is linear. That it is not hangs on few models: "
        + fragile(found, facts),
        "The reason is in its section 3.2.1. Every vertex that is added to a fragment is looked up among those added "
        "before. With a dictionary that compares one vertex, that is linear. With a list, or a dictionary whose hash "
        "sends all vertices to a few buckets, each look-up walks through the vertices so far: the cut is quadratic. "
        f"Our `two_bucket_hash` repeats that{followed(found, facts)}. `hash` differs from it in nothing but the hash "
        "function.",
        ShownTable(table, "Exponents over the fifteen models; and the least and the greatest of those that leaving "
                   "out one model gives.")])


def fragile(found: Measurements, facts: Facts) -> str:
    """What leaving out one model makes of the exponent of the report's cuts."""
    rows = cuts_table(found).rows
    faces = {row["model"]: row["report_faces"] for row in sizes_table(found).rows}
    without = fits.without_each([(faces[row["model"]], row["report_cut_ms"]) for row in rows])
    fitted = [(exponent, str(row["model"])) for exponent, row in zip(without, rows)
              if exponent and exponent.half_width is not None]
    if not fitted:
        return "there are too few to tell."
    values = [exponent.value for exponent, _ in fitted]
    text = (f"if one is left out the exponent lies between "
            f"{facts.say('least exponent without a model', min(values), digits(2))} and "
            f"{facts.say('greatest exponent without a model', max(values), digits(2))}")
    linear = [(exponent, model) for exponent, model in fitted if exponent.value - (exponent.half_width or 0.0) <= 1.0]
    if linear:
        text += ", and " + ", ".join(
            f"without the {model} ({facts.say(f'exponent without {model}', exponent.value, digits(2))} ± "
            f"{facts.say(f'its half width without {model}', exponent.half_width or 0.0, digits(2))})"
            for exponent, model in linear) + " it cannot be told from 1"
    return text + "."


def followed(found: Measurements, facts: Facts) -> str:
    """How the report's times compare with the look-up that repeats its method, on another machine and other models."""
    ratios = [row["report_cut_ms"] / row["baseline/two_bucket_hash_ms"] for row in cuts_table(found).rows
              if row.get("baseline/two_bucket_hash_ms")]
    if not ratios:
        return ""
    rows = {row["times"]: row for row in model_exponents_table(found).rows}
    report, ours = rows["the report's cut"], rows["baseline/two_bucket_hash"]
    apart = abs(report["exponent"] - ours["exponent"])
    agrees = apart <= min(report["half_width"] or 0.0, ours["half_width"] or 0.0)
    return (f", and its exponent {'agrees' if agrees else 'does not agree'} with the report's within both intervals; "
            f"model by model it follows loosely: the report's laptop takes "
            f"{facts.say('report to two_bucket_hash, least', min(ratios), digits(1))} to "
            f"{facts.say('report to two_bucket_hash, most', max(ratios), digits(0))} times as long")


def hulls(found: Measurements) -> Section:
    return Section("hulls", "Collision hulls of the report's models", [
        "The report hands every vertex of a fragment to the physics engine's hull shape, one by one (`every vertex`). "
        "The other columns are the proxies offered here, for both fragments of a cut together, built by a loop over "
        "the fragment's vertices; *bounded hull, halfedge* is read off the half-edge back end's tree. The bounded "
        "hull takes the extreme vertices along 32 fixed directions.",
        ShownTable(hulls_table(found), "The report's Table 2, convex hulls: ms for both fragments.")])


def frames(found: Measurements) -> Section:
    if not found.runs:
        return Section("frames", "Frames while cutting")
    return Section("frames", "Frames while cutting", [
        "The viewer runs without a screen. A seeded autopilot throws one model at a time and cuts its pieces, ten to "
        "twenty cuts a model, as the report did by hand. *Simulate* is processor time of a frame's physics and "
        "cutting. Preparing happens on a worker and is not in it. A first run of each back end warms up the driver and "
        "what the processor keeps of code, and is not counted. Of `remap` and the half-edge back end there are five runs "
        "more, by turns, and the times are their medians: which frame is the worst changes from run to run. *Not drawn* "
        "are five runs of each in which nothing is drawn: where a program draws, it empties the processor's caches "
        "between two frames, and a small cut, which takes 3 µs if its code is there, waits for memory most of the time. "
        "A graphics card does not do that.",
        ShownTable(worst_frames_table(found), "The worst frame while cutting, ms of processor time for physics and "
                                              "cutting.",
                   published=True),
        ShownTable(frames_table(found), "The report's Table 2, frames per second, and ours, drawn by "
                   f"`{found.runs[0].graphics}`: if that is a program and no graphics card, drawing decides them. The "
                   "report had a GTX 1050 and waited for the screen. `asteroid` is a large one of our own.",
                   listing=True)])
