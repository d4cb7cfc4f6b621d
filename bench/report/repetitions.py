"""What repeated runs of a benchmark say: the median of each counter, and how far the runs lie apart."""

import re
import statistics
from typing import Any, Iterable

Counters = dict[str, tuple[float, float, float]]  # counter -> median, lowest, highest of the repetitions


class WrongResult(Exception):
    """A benchmark was not timed because what it computes is wrong; the text says which."""


def collect(benchmarks: Iterable[dict[str, Any]]) -> dict[str, Counters]:
    """The counters of each benchmark, from the runs that the harness wrote. Raises WrongResult."""
    runs: dict[str, list[dict[str, Any]]] = {}
    for entry in benchmarks:
        if entry.get("run_type") != "iteration":
            continue
        name = re.sub(r"(/iterations:\d+)?/(manual|real)_time.*", "", entry["name"])
        if entry.get("error_occurred"):
            raise WrongResult(f"{name} was not timed because its result is wrong: {entry['error_message']}")
        runs.setdefault(name, []).append(per_cut(entry))
    return {name: counters_of(entries) for name, entries in runs.items()}


def per_cut(entry: dict[str, Any]) -> dict[str, Any]:
    """A run with its time divided by the cuts in it, if an iteration is a round of several (`cuts_each`)."""
    return entry | {"real_time": entry["real_time"] / entry.get("cuts_each", 1)}


def counters_of(entries: list[dict[str, Any]]) -> Counters:
    """Of the runs of one benchmark."""
    counters: Counters = {}
    for key in (key for key, value in entries[0].items() if isinstance(value, (int, float))):
        values = [entry[key] for entry in entries]
        counters[key] = (statistics.median(values), min(values), max(values))
    return counters | {"repetitions": (len(entries),) * 3}


def median(counters: Counters | None, counter: str) -> float | None:
    return counters[counter][0] if counters and counter in counters else None


def spread_of(counters: Counters | None, counter: str) -> float | None:
    """(highest - lowest) / median of the repetitions; None if there is but one."""
    if not counters or counter not in counters or counters["repetitions"][0] < 2 or not counters[counter][0]:
        return None
    middle, lowest, highest = counters[counter]
    return (highest - lowest) / middle


def worst_spread(cells: Iterable[tuple[Counters | None, str]]) -> float | None:
    """The worst spread of some benchmarks' counters; None if nothing was repeated."""
    spreads = [spread_of(counters, counter) for counters, counter in cells]
    return max((spread for spread in spreads if spread is not None), default=None)
