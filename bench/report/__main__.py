"""Measures, compares, and writes build/report/index.html with CSV and JSON of every number.

What was measured is kept: an interrupted report goes on where it was, and only what a change of the programs
concerns is measured again. With --text the benchmarks alone are run, always anew, and their tables are printed.
Exit status: 0 done, 1 a program failed, 2 wrong use, 130 interrupted.
"""

import argparse
import importlib.util
import os
import signal
import sys
import time
from pathlib import Path
from typing import Any

from report import files, machine, measurements
from report.chapters import all_sections
from report.chapters.section import Facts
from report.judged_caps import worst_fans
from report.measurements import Measurements
from report.page.text import text_page
from report.plan import FULL, NORMAL, QUICK, SHOWN_FANS, Extent, gallery_stages, plan, text_plan
from report.progress import time_text
from report.repetitions import WrongResult, collect
from report.stages import Programs, StageFailed, Stages

ROOT = Path(__file__).resolve().parents[2]
FOLDER = Path("build/report")
TEXT_FOLDER = Path("build/bench")


def parse_arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="./run report", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    extents = parser.add_mutually_exclusive_group()
    extents.add_argument("--quick", action="store_true",
                         help="meshes up to 100 000 triangles, each timed once: under three minutes")
    extents.add_argument("--full", action="store_true",
                         help="meshes up to 16 million triangles: needs 16 GiB and some 25 minutes")
    parser.add_argument("--peers", action="store_true", help="time VTK and Open3D beside CGAL, too; ./run installs them (600 MB)")
    parser.add_argument("--again", action="store_true", help="measure everything again, whatever is there")
    parser.add_argument("--stored", action="store_true",
                        help="measure nothing: write the page from what was measured before, with whatever programs")
    parser.add_argument("--publish", action="store_true",
                        help="write docs/results.md, its pictures and the README's part on results, too")
    parser.add_argument("--text", action="store_true", help="run the benchmarks and print their tables; writes no page")
    parser.add_argument("--out", type=Path, metavar="JSON", default=TEXT_FOLDER / "results.json",
                        help="with --text: where the benchmarks' JSON goes (default: %(default)s)")
    parser.add_argument("--show", type=Path, metavar="JSON",
                        help="with --text: run nothing, print an earlier run's tables")
    parser.add_argument("--programs", type=Path, default=Path("build/release"), help=argparse.SUPPRESS)
    return parser.parse_args()


def extent_of(arguments: argparse.Namespace) -> Extent:
    return QUICK if arguments.quick else FULL if arguments.full else NORMAL


def say(sentence: str) -> None:
    print(f"report: {sentence}", file=sys.stderr)


def measure(arguments: argparse.Namespace, stages: Stages, has_vtk: bool, has_open3d: bool) -> Measurements:
    """What all stages of the page say. With --stored: those that are there."""
    def done(to_do: list[Any]) -> list[Path]:
        if not arguments.stored:
            stages.run_all(to_do)
        return [stages.file(stage) for stage in to_do if stages.file(stage).exists()]

    if arguments.again and not arguments.stored:
        stages.forget()
    measured = done(plan(extent_of(arguments), FOLDER / "models", has_vtk, has_open3d))
    # Which caps are drawn depends on which fans turned out to be the worst.
    pictures = done(gallery_stages(worst_fans(measurements.load(measured), SHOWN_FANS)))
    return measurements.load(measured + pictures)


def write_page(arguments: argparse.Namespace) -> int:
    extent = extent_of(arguments)
    stages = Stages(FOLDER / "stages" / extent.name, Programs.in_build(arguments.programs))
    has_vtk = importlib.util.find_spec("vtkmodules") is not None
    has_open3d = importlib.util.find_spec("open3d") is not None
    for has_it, name, package in ((has_vtk, "VTK", "python3-vtk9"), (has_open3d, "Open3D", "python3-open3d")):
        if arguments.peers and not has_it:
            say(f"{name} is not there; Debian's package is {package}")
            return 1
    if not arguments.stored and (missing := stages.programs.missing()):
        say(f"{missing} is not there; `./run report` builds it")
        return 1
    start = time.monotonic()
    found = measure(arguments, stages, has_vtk, has_open3d)
    if not found.stages:
        say(f"nothing of extent {extent.name} was measured yet")
        return 1
    from report.page.export import Report  # matplotlib takes a second to load, and is not needed until here
    # What is shown was measured at the stages' commits, whatever is checked out by now.
    described = machine.describe(arguments.programs) | {"commit": measurements.commits(found)}
    report = Report(found, described, extent.name, os.cpu_count() or 1)
    page = report.write(FOLDER)
    if arguments.publish:
        say(f"wrote {report.publish(Path('docs'), Path('README.md'))}")
    say(f"done in {time_text(time.monotonic() - start)}")
    print(page.resolve())
    return 0


def run_for_text(arguments: argparse.Namespace, out: Path) -> Any:
    """Runs the benchmarks anew and keeps their JSON in `out`, as the harness would write it of one run."""
    extent = extent_of(arguments)
    stages = Stages(TEXT_FOLDER / "stages" / extent.name, Programs.in_build(arguments.programs))
    stages.forget()
    to_do = text_plan(extent)
    stages.run_all(to_do)
    results = [files.read_json(stages.file(stage))["result"] for stage in to_do]
    merged = {"context": results[0]["context"], "benchmarks": [entry for result in results
                                                               for entry in result["benchmarks"]]}
    files.write_json(out, merged)
    return merged


def print_text(arguments: argparse.Namespace, show: Path | None, out: Path) -> int:
    if show is not None:
        try:
            results = files.read_json(show)
            benchmarks, context = results["benchmarks"], results["context"]
        except (OSError, ValueError, KeyError, TypeError) as error:
            say(f"{show} holds no benchmarks: {getattr(error, 'strerror', None) or 'it is not the JSON of a run'}")
            return 1
    else:
        bench = Programs.in_build(arguments.programs).bench
        if not bench.exists():
            say(f"{bench} is not there; `./run bench` builds it")
            return 1
        results = run_for_text(arguments, out)
        benchmarks, context = results["benchmarks"], results["context"]
    closing = [f"{context['num_cpus']} cores, load {context['load_avg'][0]:.2f}, {context['date'][:10]}. One thread, "
               "Release; processor time of that thread."]
    if show is None:
        closing = [f"{machine.processor()}, {closing[0]} All numbers: {os.path.relpath(out)}"]
    print(text_page(all_sections(Measurements(bench=collect(benchmarks)), {}, Facts()), closing), end="")
    return 0


def main() -> int:
    arguments = parse_arguments()
    # What the caller names lies where the caller is; everything else is run in the project's folder.
    show, out = (path and path.absolute() for path in (arguments.show, arguments.out))
    if arguments.out == TEXT_FOLDER / "results.json":
        out = ROOT / arguments.out
    os.chdir(ROOT)
    signal.signal(signal.SIGTERM, signal.default_int_handler)
    try:
        return print_text(arguments, show, out) if arguments.text else write_page(arguments)
    except (StageFailed, WrongResult) as error:
        print(file=sys.stderr)
        say(str(error))
        return 1
    except KeyboardInterrupt:
        print(file=sys.stderr)
        say("interrupted" + ("" if arguments.text else "; the same command goes on from here"))
        return 130


if __name__ == "__main__":
    sys.exit(main())
