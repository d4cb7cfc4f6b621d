"""Measurements that are known exactly, for the tests of the report."""

import importlib.util
import math

from report.measurements import Measurements

HAS_MATPLOTLIB = importlib.util.find_spec("matplotlib") is not None


def some_measurements():
    """A linear and a half-edge back end whose times are known exactly: n / 1000 and sqrt(n) / 10 ms."""
    found = Measurements()
    for size in (1_000, 10_000, 30_000, 100_000, 1_000_000):
        for backend, ms in (("baseline/remap", size / 1000), ("halfedge", math.sqrt(size) / 10)):
            counters = {"real_time": ms, "triangles": size, "crossing": math.sqrt(size),
                        "touched": 10 * math.sqrt(size),
                        "nodes": math.sqrt(size), "upload_bytes": 200 * math.sqrt(size),
                        "ns_per_crossing": 1e6 * ms / math.sqrt(size),
                        "ms_find": ms / 2, "ms_cap": ms / 2, "repetitions": 1, "iterations": 1}
            for kind in ("Scale", "Geometry"):
                found.bench[f"{kind}/{backend}/asteroid/{size}"] = {key: (v, v, v) for key, v in counters.items()}
    return found
