#!/usr/bin/python3
"""Measures, compares, and writes build/report/index.html with CSV and JSON of every number.

What was measured is kept: an interrupted report goes on where it was, and only what a change of the programs
concerns is measured again. Exit status: 0 done, 1 a program failed, 2 wrong use, 130 interrupted.
"""

import argparse
import importlib.util
import os
import signal
import sys
import time
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))

from report import machine, measurements  # noqa: E402  (found through the line above)
from report.plan import FULL, NORMAL, QUICK, Stage, gallery_stages, plan  # noqa: E402
from report.progress import Progress, time_text  # noqa: E402
from report.stages import Programs, StageFailed, Stages  # noqa: E402

FOLDER = Path("build/report")


def parse_arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="./run report", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    extents = parser.add_mutually_exclusive_group()
    extents.add_argument("--quick", action="store_true", help="meshes up to 100 000 triangles, each timed once: under three minutes")
    extents.add_argument("--full", action="store_true", help="meshes up to 16 million triangles: needs 16 GiB and some 25 minutes")
    parser.add_argument("--peers", action="store_true", help="time VTK beside CGAL, too; ./run installs it (216 MB)")
    parser.add_argument("--again", action="store_true", help="measure everything again, whatever is there")
    parser.add_argument("--publish", action="store_true", help="write docs/results.md, its pictures and the README's part on results, too")
    parser.add_argument("--programs", type=Path, default=Path("build/release"), help=argparse.SUPPRESS)
    return parser.parse_args()


def run_all(stages: Stages, to_do: list[Stage]) -> None:
    waiting = [stage for stage in to_do if not stages.finished(stage)]
    if len(waiting) < len(to_do):
        print(f"report: {len(to_do) - len(waiting)} of {len(to_do)} stages are there already", file=sys.stderr)
    progress = Progress({stage.name: stage.expected_seconds for stage in waiting})
    for stage in waiting:
        progress.begin(stage.name)
        stages.run(stage, progress)
        progress.end()
    progress.clear()


def main() -> int:
    arguments = parse_arguments()
    extent = QUICK if arguments.quick else FULL if arguments.full else NORMAL
    os.chdir(HERE.parent)
    signal.signal(signal.SIGTERM, signal.default_int_handler)
    stages = Stages(FOLDER / "stages" / extent.name, Programs.in_build(arguments.programs))
    has_vtk = importlib.util.find_spec("vtkmodules") is not None
    if arguments.peers and not has_vtk:
        print("report: VTK is not there; Debian's package is python3-vtk9", file=sys.stderr)
        return 1
    to_do = plan(extent, FOLDER / "models", has_vtk)
    if missing := stages.programs.missing():
        print(f"report: {missing} is not there; `./run report` builds it", file=sys.stderr)
        return 1
    start = time.monotonic()
    try:
        if arguments.again:
            stages.forget()
        run_all(stages, to_do)
        # Which caps are drawn depends on which fans turned out to be the worst.
        pictures = gallery_stages(measurements.load([stages.file(stage) for stage in to_do]))
        run_all(stages, pictures)
        found = measurements.load([stages.file(stage) for stage in to_do + pictures])
        from report.export import Report  # matplotlib takes a second to load, and is not needed until here
        report = Report(found, machine.describe(arguments.programs), extent.name, os.cpu_count() or 1)
        page = report.write(FOLDER)
        if arguments.publish:
            print(f"report: wrote {report.publish(Path('docs'), Path('README.md'))}", file=sys.stderr)
    except StageFailed as error:
        print(f"\nreport: {error}", file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        print("\nreport: interrupted; the same command goes on from here", file=sys.stderr)
        return 130
    print(f"report: done in {time_text(time.monotonic() - start)}", file=sys.stderr)
    print(page.resolve())
    return 0


if __name__ == "__main__":
    sys.exit(main())
