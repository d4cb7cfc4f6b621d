"""What scripts print of sections by other libraries: the rows that `kerf_peers sections` prints, too."""

import time
from collections import Counter

STACKS = (10, 100, 1000)


def row_of(peer, entry, triangles, times, problems, heights=1, prepare_ms=0.0):
    """`problems`: how many of the sections had which."""
    verdict = "; ".join(problem if count == len(times) else f"{problem} in {count}"
                        for problem, count in sorted(problems.items()))
    return {"peer": peer, "mesh": entry["mesh"], "triangles": triangles, "heights": heights,
            "ms": sum(times) * 1e3 / len(times), "least_ms": min(times) * 1e3, "most_ms": max(times) * 1e3,
            "planes": len(times), "right": len(times) - sum(problems.values()), "verdict": verdict or "right",
            "prepare_ms": prepare_ms}


def has_length(length, expected, share):
    return abs(length - expected["length"]) <= share * expected["length"]


def middles_of_layers(entry, heights):
    """Where the planes of a stack are: each in the middle of one of as many layers."""
    step = (entry["highest"] - entry["lowest"]) / heights
    return [entry["lowest"] + (i + 0.5) * step for i in range(heights)]


def timed(function):
    """Seconds of processor time, of all threads of the process, and what the function gives."""
    start = time.process_time()
    result = function()
    return time.process_time() - start, result


def rows_of_segments(peer, entry, triangles, share, budget, one, stack):
    """Rows of a library that gives segments in no order. one(plane) gives seconds and a length, stack(heights) seconds."""
    times, problems = [], Counter()
    for plane in entry["planes"]:
        if times and sum(times) >= budget:
            break
        seconds, length = one(plane)
        times.append(seconds)
        problems["segments in no order" if has_length(length, plane, share) else "wrong length"] += 1
    rows = [row_of(peer, entry, triangles, times, problems)]
    return rows + [row_of(peer, entry, triangles, [stack(middles_of_layers(entry, heights))],
                          Counter(["segments in no order"]), heights) for heights in STACKS]
