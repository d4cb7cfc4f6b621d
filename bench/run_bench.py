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
PROXIES = ["every_vertex", "full_hull", "bounded_hull", "box", "sphere"]


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", type=Path, default=HERE.parent / "build/release/bench/kerf_bench",
                        help="the built kerf_bench")
    parser.add_argument("--out", type=Path, default=HERE.parent / "build/bench/results.json", help="where the JSON goes")
    parser.add_argument("--quick", action="store_true", help="one repetition and no mesh above 100 000 triangles")
    parser.add_argument("--show", type=Path, metavar="JSON", help="run nothing: print the tables of an earlier run")
    return parser.parse_args()


def run_one(program, pattern, repetitions, min_time, title, out):
    """Runs the benchmarks whose name matches, shows one line of progress, returns the parsed JSON."""
    listed = subprocess.run([program, "--benchmark_list_tests", f"--benchmark_filter={pattern}"], check=True,
                            capture_output=True, text=True).stdout.splitlines()
    total, done, start = len(listed), 0, time.monotonic()
    messages = tempfile.TemporaryFile("w+")  # the harness writes its context there; shown only when something fails
    process = subprocess.Popen(
        [program, f"--benchmark_filter={pattern}", f"--benchmark_repetitions={repetitions}",
         f"--benchmark_min_time={min_time}", "--benchmark_enable_random_interleaving=false",
         f"--benchmark_out={out}", "--benchmark_out_format=json"],
        stdout=subprocess.PIPE, stderr=messages, text=True)
    seen = set()
    for line in process.stdout:
        match = re.match(r"(\S+?)/manual_time", line)
        if match and match.group(1) not in seen:
            seen.add(match.group(1))
            done += 1
            if sys.stderr.isatty():
                print(f"\r{title}: {done}/{total} {match.group(1):60.60}", end="", file=sys.stderr, flush=True)
            elif done % 50 == 0:
                print(f"{title}: {done}/{total}", file=sys.stderr, flush=True)
    if process.wait() != 0 or done != total:
        messages.seek(0)
        sys.exit(f"run_bench: {program} failed with exit status {process.returncode}:\n{messages.read().strip()}")
    if sys.stderr.isatty():
        print("\r" + " " * 100 + "\r", end="", file=sys.stderr)
    print(f"{title}: {done} benchmarks in {time.monotonic() - start:.0f} s", file=sys.stderr)
    with open(out) as file:
        return json.load(file)


def collect(results):
    """Median and spread of each benchmark's counters: {name: {counter: (median, lowest, highest)}}."""
    runs = {}
    for entry in results["benchmarks"]:
        if entry.get("run_type") != "iteration":
            continue
        name = entry["name"].split("/manual_time")[0]
        if entry.get("error_occurred"):
            sys.exit(f"run_bench: {name} was not timed because its result is wrong: {entry['error_message']}")
        runs.setdefault(name, []).append(entry)
    table = {}
    for name, entries in runs.items():
        counters = [key for key, value in entries[0].items() if isinstance(value, (int, float))]
        table[name] = {}
        for key in counters:
            values = [entry[key] for entry in entries]
            table[name][key] = (statistics.median(values), min(values), max(values))
    return table


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
    backends = sorted({name.split("/", 1)[1].rsplit("/", 1)[0] for name in table if name.startswith("Cut/")},
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
    print("then ours: the cut with each vertex lookup, and the collision proxies of both fragments.\n")
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


def print_notes():
    print("Why two_bucket_hash is fitted below 2: both its buckets are lists with the newest vertex in front. Triangles in coherent")
    print("order find most of their vertices near the front; in random order half of the list is searched each time. The section adds")
    print("about sqrt(n) triangles and vertices, which count for more in small meshes. `hash` compares each vertex about once.\n")


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
        results = run_one(arguments.program, "^(Cut|Proxy|Prepare)/", repetitions, 0.01, "Models", partial)
        sizes = "(1000|3000|10000|30000|100000)" if arguments.quick else "(1000|3000|10000|30000|100000|300000|1000000)"
        scaling = run_one(arguments.program, f"^(Scale|Geometry)/.*/{sizes}/manual_time$", repetitions, 0.05, "Growth", partial)
        results["benchmarks"] += scaling["benchmarks"]
        with open(partial, "w") as file:
            json.dump(results, file, indent=1)
        os.replace(partial, arguments.out)
        print()
    table = collect(results)
    print_models(table)
    print_scaling(table)
    print_notes()
    print_machine(results)
    if not arguments.show:
        print(f"All numbers: {os.path.relpath(arguments.out)}")


if __name__ == "__main__":
    main()
