"""What scripts print of sections by other libraries: the rows that `kerf_peers sections` prints, too."""

import time
from collections import Counter

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


def timed(function):
    """Seconds of processor time, of all threads of the process, and what the function gives."""
    start = time.process_time()
    result = function()
    return time.process_time() - start, result


def rows_of_segments(peer, entry, triangles, share, budget, one, stack):
    """Rows of a library that gives segments in no order. one(plane) gives seconds and a length, stack(heights), too."""
    times, problems = [], Counter()
    for plane in entry["planes"]:
        if times and sum(times) >= budget:
            break
        seconds, length = one(plane)
        times.append(seconds)
        problems[segments_or_wrong(length, plane, share)] += 1
    rows = [row_of(peer, entry, triangles, times, problems)]
    for expected in entry["stacks"]:
        seconds, length = stack(expected["heights"])
        rows.append(row_of(peer, entry, triangles, [seconds], Counter([segments_or_wrong(length, expected, share)]),
                           len(expected["heights"])))
    return rows


def segments_or_wrong(length, expected, share):
    return "segments in no order" if has_length(length, expected, share) else "wrong length"
