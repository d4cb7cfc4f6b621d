"""The report's Tables 1 and 2, ours beside them, and how the report's own times grow."""

import statistics

from report import fits
from report.chapters.section import Facts, Section, ShownFigure, ShownTable
from report.measurements import Measurements
from report.tables.model_tables import (cuts_table, frames_table, hulls_table, model_exponents_table, sizes_table,
                                        worst_frames_table)
from report.tables.numbers import digits


def write(found: Measurements, machine: dict[str, str], facts: Facts) -> list[Section]:
    cuts = cuts_table(found)
    if not any(row.get("halfedge_ms") for row in cuts.rows):
        return []
    return [sizes(found), times(found, facts), report_fit(found, facts), hulls(found), frames(found)]


def sizes(found: Measurements) -> Section:
    return Section("models", "The models", [
        "The report measured fifteen models that it does not publish. Ours are made by a program (`./run models`) to have "
        "the same kind of shape, the report's number of faces to within one, and nearly its vertices. A vertex is a "
        "combination of position, normal and uv, so seams count twice. The report's Cube row has its two columns swapped; "
        "here they are the right way round.",
        ShownTable(sizes_table(found), "The report's Table 1.", published=True)])


def times(found: Measurements, facts: Facts) -> Section:
    table = cuts_table(found)
    slower = [row["halfedge_ms"] / row["baseline/remap_ms"] for row in table.rows
              if row.get("halfedge_ms") and row.get("baseline/remap_ms")]
    parts = [
        "Each model is cut by ten seeded random planes through its middle; a time is the mean of the ten cuts, the median "
        "over repetitions, processor time of one thread. `scan` and `two_bucket_hash` are the two ways to look up "
        "vertices that the report describes, `hash` is the dictionary it should have had; these three include its loop "
        "that rewrites every vertex around the new pivot. `remap` is the best linear method we know: it looks up indices, "
        "not vertices. `halfedge` touches only what the plane meets. Every result is checked before it is timed.",
        ShownTable(table, "The report's Table 2, cutting: ms per cut. Its times are its laptop's. Spread: (highest − lowest) / median of "
                   "the repetitions, the worst of the row.", published=True),
        ShownFigure("models", "The same numbers. The report's times lie far above every method that runs here, and rise "
                    "more steeply than a loop over triangles would.", published=True)]
    if (factors := lookup_factors(found, facts)) and slower:
        ours, theirs = (statistics.median(row[f"{name}_ms"] for row in table.rows if row.get(f"{name}_ms"))
                        for name in ("baseline/remap", "halfedge"))
        parts.append(
            f"What the report blamed on the number of triangles is its vertex look-up: on the same models and machine {factors}. "
            f"On models as small as these **the half-edge back end is not the fastest**: "
            f"it takes {facts.say('halfedge to remap, median', statistics.median(slower), digits(1))} times what `remap` "
            f"takes (median), because both are done in less than a tenth of a millisecond (medians "
            f"{facts.say('halfedge microseconds, median', 1e3 * theirs, digits(0))} and "
            f"{facts.say('remap microseconds, median', 1e3 * ours, digits(0))} µs) and a loop over a thousand triangles is hard to beat.")
    return Section("table2", "Cutting the report's models", parts)


def lookup_factors(found: Measurements, facts: Facts) -> str:
    """What the look-up costs, in factors between back ends that differ in it; empty where one of them was not timed."""
    rows = [row for row in cuts_table(found).rows
            if all(row.get(f"baseline/{lookup}_ms") for lookup in ("scan", "two_bucket_hash", "hash", "remap"))]
    if not rows:
        return ""

    def factor(slower: str, faster: str) -> str:
        ratio = statistics.median(row[f"baseline/{slower}_ms"] / row[f"baseline/{faster}_ms"] for row in rows)
        return facts.say(f"{slower} to {faster}, median", ratio, digits(1))

    return (f"a hash that knows two buckets takes {factor('two_bucket_hash', 'hash')} times as long as one that tells vertices apart, which "
            f"is the same method but for the hash function; a list {factor('scan', 'hash')} times. Indices in place of "
            f"a dictionary of vertices, without the loop that moves every vertex to the new pivot (`remap`), are a further "
            f"{factor('hash', 'remap')} times quicker (medians of the models)")


def report_fit(found: Measurements, facts: Facts) -> Section:
    table = model_exponents_table(found)
    by_name = {row["times"]: row for row in table.rows}
    report = by_name["the report's cut"]
    half = report["half_width"] or 0.0
    parts = [
        f"Fitted over all fifteen models the report's cut times grow as the number of faces to the power of "
        f"{facts.say('exponent of the report', report['exponent'], digits(2))} ± {facts.say('its half width', half, digits(2))} "
        f"(95 % confidence; least squares in logarithms). Its text says that the method is linear. That it is not hangs on few models: "
        + fragile(found, facts),
        "The reason is in its section 3.2.1. Every vertex that is added to a fragment is looked up among those added before. "
        "With a dictionary that compares one vertex that is linear; with a list, or a dictionary whose hash sends all "
        "vertices to a few buckets, each look-up walks through the vertices so far, and the cut is quadratic. Our "
        "`two_bucket_hash` repeats that" + followed(found, facts) + "; `hash` differs from it in nothing but the hash function.",
        ShownFigure("report_growth", "The report's times and the power of the number of faces that fits them."),
        ShownTable(table, "Exponents over the fifteen models; and the least and the greatest of those that leaving "
                   "out one model gives.", published=True)]
    return Section("report-growth", "Why the report's times grow faster than linearly", parts)


def fragile(found: Measurements, facts: Facts) -> str:
    """What leaving out one model makes of the exponent of the report's cuts."""
    rows = cuts_table(found).rows
    faces = {row["model"]: row["report_faces"] for row in sizes_table(found).rows}
    without = fits.without_each([(faces[row["model"]], row["report_cut_ms"]) for row in rows])
    fitted = [(exponent, str(row["model"])) for exponent, row in zip(without, rows) if exponent and exponent.half_width is not None]
    if not fitted:
        return "there are too few to tell."
    least, most = min(fitted, key=lambda pair: pair[0].value)[0], max(fitted, key=lambda pair: pair[0].value)[0]
    linear = [pair for pair in fitted if pair[0].value - pair[0].half_width <= 1.0]
    text = (f"when one is left out the exponent lies between {facts.say('least exponent without a model', least.value, digits(2))} and "
            f"{facts.say('greatest exponent without a model', most.value, digits(2))}")
    if linear:
        text += ", and " + ", ".join(f"without the {model} ({facts.say(f'exponent without {model}', exponent.value, digits(2))} ± "
                                     f"{facts.say(f'its half width without {model}', exponent.half_width, digits(2))})"
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
    return (f", and its exponent {'agrees' if agrees else 'does not agree'} with the report's within both intervals; model by model it follows "
            f"loosely: the report's laptop takes "
            f"{facts.say('report to two_bucket_hash, least', min(ratios), digits(1))} to "
            f"{facts.say('report to two_bucket_hash, most', max(ratios), digits(0))} times as long")


def hulls(found: Measurements) -> Section:
    return Section("hulls", "Collision hulls of the report's models", [
        "The report hands every vertex of a fragment to the physics engine's hull shape, one by one (`every vertex`). "
        "The other columns are the proxies offered here, for both fragments of a cut together, built by a loop over the fragment's "
        "vertices; the last but a few by the half-edge back end, off its tree. The bounded hull takes the "
        "extreme vertices along 32 fixed directions.",
        ShownTable(hulls_table(found), "The report's Table 2, convex hulls: ms for both fragments.", published=True)])


def frames(found: Measurements) -> Section:
    graphics = found.runs[0].graphics if found.runs else ""
    return Section("frames", "Frames while cutting", [] if not found.runs else [
        f"The viewer runs without a screen: a seeded autopilot throws one model at a time and cuts its pieces, "
        f"ten to twenty cuts a model, as the report did by hand. *Simulate* is processor time of a frame's physics and cutting. "
        f"Preparing happens on a worker, off the frame, and is not in it; the first run of every process warms the driver up and is not "
        f"counted. Frames per second come with drawing, here by `{graphics}`: on a machine "
        f"without a graphics card a program draws, and drawing decides them. The report had a GTX 1050 and waited for the screen.",
        ShownTable(worst_frames_table(found), "The worst frame while cutting, ms of processor time for physics and cutting.", published=True),
        ShownTable(frames_table(found), "The report's Table 2, frames per second, and ours; `asteroid` is a large one of our own.",
                   published=True)])
