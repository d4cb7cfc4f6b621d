#!/usr/bin/python3
"""Runs kerf_bench and prints its results beside the report's tables.

The JSON of every run is kept (build/bench/results.json by default); the tables can be printed again from it with --show.
"""

import argparse
import csv
import json
import math
import os
import re
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

HERE = Path(__file__).resolve().parent
LOOKUPS = ["scan", "two_bucket_hash", "hash", "remap"]
SIZES = [1_000, 3_000, 10_000, 30_000, 100_000, 300_000, 1_000_000, 4_000_000, 16_000_000]
PROXIES = ["every_vertex", "full_hull", "bounded_hull", "box", "sphere"]


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", type=Path, default=HERE.parent / "build/release/bench/kerf_bench",
                        help="the built kerf_bench")
    parser.add_argument("--out", type=Path, default=HERE.parent / "build/bench/results.json", help="where the JSON goes")
    parser.add_argument("--quick", action="store_true", help="one repetition and no mesh above 100 000 triangles")
    parser.add_argument("--full", action="store_true", help="meshes up to 16 million triangles; takes several minutes and 16 GiB")
    parser.add_argument("--show", type=Path, metavar="JSON", help="run nothing: print the tables of an earlier run")
    return parser.parse_args()


class LineOfProgress:
    """Shows how many benchmarks are done: one line on a terminal, now and then a line elsewhere."""

    def __init__(self, title):
        self.title, self.start = title, time.monotonic()

    def update(self, done, total, name):
        if sys.stderr.isatty():
            print(f"\r{self.title}: {done}/{total} {name:60.60}", end="", file=sys.stderr, flush=True)
        elif done % 50 == 0:
            print(f"{self.title}: {done}/{total}", file=sys.stderr, flush=True)

    def finish(self, done):
        if sys.stderr.isatty():
            print("\r" + " " * 100 + "\r", end="", file=sys.stderr)
        print(f"{self.title}: {done} benchmarks in {time.monotonic() - self.start:.0f} s", file=sys.stderr)


def run_one(program, pattern, repetitions, min_time, progress, out):
    """Runs the benchmarks whose name matches, tells `progress` about each, returns the parsed JSON.

    The program is killed when this is interrupted, so that nothing goes on in the background.
    """
    listed = subprocess.run([program, "--benchmark_list_tests", f"--benchmark_filter={pattern}"], check=True,
                            capture_output=True, text=True).stdout.splitlines()
    total, done = len(listed), 0
    messages = tempfile.TemporaryFile("w+")  # the harness writes its context there; shown only when something fails
    process = subprocess.Popen(
        [program, f"--benchmark_filter={pattern}", f"--benchmark_repetitions={repetitions}",
         f"--benchmark_min_time={min_time}", "--benchmark_enable_random_interleaving=false",
         f"--benchmark_out={out}", "--benchmark_out_format=json"],
        stdout=subprocess.PIPE, stderr=messages, text=True)
    seen = set()
    try:
        for line in process.stdout:
            match = re.match(r"(\S+?)/manual_time", line)
            if match and match.group(1) not in seen:
                seen.add(match.group(1))
                done += 1
                progress.update(done, total, match.group(1))
        process.wait()
    finally:
        process.kill()
        process.wait()
    if process.returncode != 0 or done != total:
        messages.seek(0)
        sys.exit(f"run_bench: {program} failed with exit status {process.returncode}:\n{messages.read().strip()}")
    progress.finish(done)
    with open(out) as file:
        return json.load(file)


def collect(results):
    """Median and spread of each benchmark's counters: {name: {counter: (median, lowest, highest)}}. Times are those of one
    cut, where an iteration is a round of several (`cuts_each`)."""
    runs = {}
    for entry in results["benchmarks"]:
        if entry.get("run_type") != "iteration":
            continue
        name = re.sub(r"(/iterations:\d+)?/manual_time.*", "", entry["name"])
        if entry.get("error_occurred"):
            sys.exit(f"run_bench: {name} was not timed because its result is wrong: {entry['error_message']}")
        runs.setdefault(name, []).append(per_cut(entry))
    table = {}
    for name, entries in runs.items():
        counters = [key for key, value in entries[0].items() if isinstance(value, (int, float))]
        table[name] = {}
        for key in counters:
            values = [entry[key] for entry in entries]
            table[name][key] = (statistics.median(values), min(values), max(values))
        table[name]["repetitions"] = (len(entries),) * 3
    return table


def per_cut(entry):
    """A run of a benchmark with the iteration's time divided by the cuts in it."""
    each = entry.get("cuts_each", 1)
    return entry | {"real_time": entry["real_time"] / each}


def report_rows():
    with open(HERE / "report_tables.csv") as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


def milliseconds(value):
    return f"{value:.3f}" if value < 10 else f"{value:.1f}"


def print_table(header, rows):
    widths = [max(len(str(row[i])) for row in [header] + rows) for i in range(len(header))]
    for number, row in enumerate([header] + rows):
        print("  ".join(str(cell).ljust(w) if i == 0 else str(cell).rjust(w) for i, (cell, w) in enumerate(zip(row, widths))))
        if number == 0:
            print("  ".join("-" * w for w in widths))
    print()


def print_models(table):
    backends = sorted({name.split("/", 1)[1].rsplit("/", 1)[0] for name in table
                       if name.startswith("Cut/")},
                      key=lambda name: (LOOKUPS + ["halfedge"]).index(name.split("/")[-1]))
    rows, spread = [], []
    for report in report_rows():
        model = report["model"]
        row = [model.capitalize()]
        first = table[f"Cut/{backends[0]}/{model}"]
        row += [int(first["triangles"][0]), int(first["vertices"][0]), report["cut_ms"]]
        for backend in backends:
            median, low, high = table[f"Cut/{backend}/{model}"]["cut_ms"]
            row.append(milliseconds(median))
            spread.append((high - low) / median)
        row.append(report["hull_ms"])
        row += [milliseconds(table[f"Proxy/{kind}/{model}"]["proxy_ms"][0]) for kind in PROXIES]
        rows.append(row)
    print("The report's fifteen models, ten cuts each, times in ms per cut (medians). Left the report's own times (its laptop),")
    print("then ours: the cut with each vertex lookup, and the collision proxies of both fragments. scan, two_bucket_hash and hash")
    print("include the report's loop that rewrites every vertex around the new pivot; remap and halfedge need none.\n")
    print_table(["model", "faces", "vertices", "report cut"] + [b.split("/")[-1] for b in backends] +
                ["report hull"] + PROXIES, rows)
    if spread:
        print(f"Spread of the repetitions of a cut, (highest - lowest) / median: median {statistics.median(spread):.0%}, "
              f"worst {max(spread):.0%}.\n")


def fitted_exponent(points):
    """Slope of log(time) over log(size) by least squares, and its standard error."""
    x = [math.log(size) for size, _ in points]
    y = [math.log(value) for _, value in points]
    n, mx, my = len(x), statistics.mean(x), statistics.mean(y)
    sxx = sum((a - mx) ** 2 for a in x)
    slope = sum((a - mx) * (b - my) for a, b in zip(x, y)) / sxx
    residual = sum((b - my - slope * (a - mx)) ** 2 for a, b in zip(x, y))
    return slope, math.sqrt(residual / max(n - 2, 1) / sxx)


def exponent_cell(rows, counter, is_fitted):
    """The exponent fitted to a counter over the sizes that `is_fitted` takes, for a table."""
    points = [(row["triangles"][0], row[counter][0]) for row in rows
              if is_fitted(row["triangles"][0]) and row[counter][0] > 0]
    return "%.2f ± %.2f" % fitted_exponent(points) if len(points) >= 3 else "-"


def print_scaling(table):
    for kind, what in (("Geometry", "Geometry only: two closed fragments with all attributes"),
                       ("Scale", "Whole chain: fragments, caps, mass, two bounded hulls, draw views")):
        for shape, order in (("asteroid", "triangles in coherent order"), ("shuffled", "triangles in random order")):
            cells = {}
            for name, counters in table.items():
                parts = name.split("/")
                if parts[0] == kind and parts[-2] == shape:
                    cells[("/".join(parts[1:-2]), int(parts[-1]))] = counters
            if not cells:
                continue
            sizes = sorted({size for _, size in cells})
            backends = sorted({b for b, _ in cells}, key=lambda name: (LOOKUPS + ["halfedge"]).index(name.split("/")[-1]))
            rows = []
            for backend in backends:
                row = [backend]
                for size in sizes:
                    counters = cells.get((backend, size))
                    row.append(milliseconds(counters["real_time"][0]) if counters else "-")
                own = [counters for (b, _), counters in cells.items() if b == backend]
                row.append(exponent_cell(own, "real_time", lambda n: n <= 35_000))
                row.append(exponent_cell(own, "comparisons", lambda n: n <= 35_000))
                row.append(exponent_cell(own, "real_time", lambda n: n >= 10_000))
                largest = cells.get((backend, 1_000_000))
                row.append(f"{largest['ns_per_triangle'][0]:.1f}" if largest else "-")
                rows.append(row)
            print(f"{what}; {shape}, {order}.")
            print("ms per cut by triangles; exponents e fitted to time ~ triangles^e, and to the vertex comparisons.\n")
            print_table(["back end"] + [f"{size:,}".replace(",", " ") for size in sizes] +
                        ["e 1k-30k", "of comparisons", "e from 10k", "ns/triangle at 1M"], rows)
            print_crossovers(cells)


def crossover(cells, slower, faster):
    """Triangles from which on `faster` takes less time than `slower`, by interpolation between sizes; None if it never does."""
    sizes = sorted(size for backend, size in cells if backend == faster and (slower, size) in cells)
    ratios = [(cells[(faster, size)]["triangles"][0],
               cells[(faster, size)]["real_time"][0] / cells[(slower, size)]["real_time"][0]) for size in sizes]
    result = None
    for (n0, r0), (n1, r1) in reversed(list(zip(ratios, ratios[1:]))):
        if r1 >= 1:
            return result
        if r0 >= 1:
            share = math.log(r0) / (math.log(r0) - math.log(r1))
            return math.exp(math.log(n0) + share * (math.log(n1) - math.log(n0)))
        result = n0
    return result


def print_crossovers(cells):
    for slower in ("baseline/hash", "baseline/remap"):
        if not any(backend == "halfedge" for backend, _ in cells):
            return
        size = crossover(cells, slower, "halfedge")
        smallest = min(size for _, size in cells)
        if size is None:
            print(f"halfedge is not faster than {slower} at the largest size.")
        elif size <= 1.2 * smallest:
            print(f"halfedge is faster than {slower} at every size measured.")
        else:
            print(f"halfedge is faster than {slower} from about {size:,.0f} triangles on.".replace(",", " "))
    print()


def print_crossing_costs(table):
    rows = []
    for name, counters in table.items():
        parts = name.split("/")
        if parts[0] != "Scale" or parts[1] != "halfedge" or parts[-2] != "asteroid":
            continue
        k = counters["crossing"][0]
        phases = {key[3:]: value[0] for key, value in counters.items() if key.startswith("ms_")}
        rows.append([parts[-1], f"{k:.0f}", f"{counters['ns_per_crossing'][0]:.0f}",
                     f"{counters['touched'][0] / k:.1f}", f"{counters['nodes'][0] / k:.2f}",
                     f"{counters['upload_bytes'][0] / k:.0f}",
                     ", ".join(f"{phase} {ms * 1e6 / k:.0f}" for phase, ms in sorted(phases.items(), key=lambda p: -p[1])
                               if ms * 1e6 / k >= 5)])
    if not rows:
        return
    rows.sort(key=lambda row: int(row[0]))
    print("The half-edge back end's whole chain by what the plane crosses (k triangles), asteroid in coherent order:")
    print("time, triangle records touched, tree nodes visited and bytes to upload for each crossing triangle; phases are wall-clock.\n")
    print_table(["triangles", "k", "ns/k", "touched/k", "nodes/k", "bytes/k", "ns/k by phase"], rows)
    for counter in ("touched", "nodes", "upload_bytes", "crossing"):
        points = [(c["triangles"][0], c[counter][0]) for name, c in table.items()
                  if re.match(r"Scale/halfedge/asteroid/", name) and c["triangles"][0] >= 9_000]
        if len(points) >= 3:
            print("  exponent of %s in the number of triangles, from 10 000 up: %.3f ± %.3f" %
                  ((counter,) + fitted_exponent(points)))
    print()


def print_chains(table):
    rows = [[name.split("/", 1)[1], milliseconds(c["cut_ms"][0]), milliseconds(c["worst_cut_ms"][0]),
             f"{c['ns_per_crossing'][0]:.0f}", f"{c['worst_to_predicted'][0]:.2f}", f"{c['most_draw_ranges'][0]:.0f}"]
            for name, c in table.items() if name.startswith("Recut/")]
    if rows:
        print("A chain of 100 cuts, always the largest piece through its centre of mass: ms per cut, draw ranges of a piece.")
        print("\"worst to predicted\": the cut that costs the most compared with what its crossing triangles predict, by a line through")
        print("all cuts of the chain; each cut is the median of five chains.\n")
        print_table(["", "mean cut", "worst cut", "ns per crossing triangle", "worst to predicted", "most ranges"], rows)
    rows = [[name.split("/", 1)[1], milliseconds(c["real_time"][0]), f"{c['ns_per_triangle'][0]:.0f}",
             f"{c['bytes_per_triangle'][0]:.0f}"]
            for name, c in table.items() if name.startswith("Prepare/") and "bytes_per_triangle" in c]
    if rows:
        print("Preparing a mesh, and the memory it takes from then on.\n")
        print_table(["", "ms", "ns/triangle", "bytes/triangle"], rows)


def print_notes():
    print("two_bucket_hash is quadratic: read its exponent in random order, where half of the list is searched for each vertex. Both its")
    print("buckets are lists with the newest vertex in front, so coherent input finds most vertices near the front and only new ones search")
    print("all of it: about 1.6 up to 30 000 triangles. The section adds about sqrt(n) triangles, which count for more in small meshes and")
    print("pull all exponents down. `hash` is linear (it compares each vertex about once); above 100 000 triangles its dictionary no longer")
    print("fits into the caches, which shows most in random order.\n")


def print_machine(results):
    context = results["context"]
    model = next((line.split(":", 1)[1].strip() for line in open("/proc/cpuinfo") if line.startswith("model name")), "?")
    print(f"{model}, {context['num_cpus']} cores, load {context['load_avg'][0]:.2f}, {context['date'][:10]}. One thread, Release;")
    print("processor time of that thread, so that other load on the machine counts as little as it can.")
    print("(The benchmark library's note \"built as DEBUG\" is about Debian's harness, not about Kerf.)")


def main():
    arguments = parse_arguments()
    if arguments.show:
        with open(arguments.show) as file:
            results = json.load(file)
    else:
        arguments.out.parent.mkdir(parents=True, exist_ok=True)
        partial = arguments.out.with_suffix(".partial.json")
        repetitions = 1 if arguments.quick else 3
        results = run_one(arguments.program, "^Cut/|^Proxy/|^Prepare/.*/[a-z]+/manual_time$", repetitions, 0.01,
                          LineOfProgress("Models"), partial)
        most = 100_000 if arguments.quick else 16_000_000 if arguments.full else 4_000_000
        sizes = "|".join(str(size) for size in SIZES if size <= most)
        for pattern, min_time, title in ((f"^(Scale|Geometry)/.*/({sizes})/manual_time$", 0.05, "Growth"),
                                         (f"^(Recut|Prepare)/.*/({sizes})/manual_time$", 0.01, "Chains")):
            results["benchmarks"] += run_one(arguments.program, pattern, repetitions, min_time, LineOfProgress(title),
                                              partial)["benchmarks"]
        with open(partial, "w") as file:
            json.dump(results, file, indent=1)
        os.replace(partial, arguments.out)
        print()
    table = collect(results)
    print_models(table)
    print_scaling(table)
    print_notes()
    print_crossing_costs(table)
    print_chains(table)
    print_machine(results)
    if not arguments.show:
        print(f"All numbers: {os.path.relpath(arguments.out)}")


if __name__ == "__main__":
    main()
