"""What the finished stages say, without the programs' own formats: the input of tables and plots."""

import statistics
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Iterator

from report import files
from report.names import ASTEROID, BACKENDS, GALLERY, Kind, UNDRAWN
from report.repetitions import Counters, collect


@dataclass(frozen=True)
class Cut:
    """One cut of the viewer: times in milliseconds."""

    model: str
    backend: str
    triangles: int
    crossing: int
    to_upload_ms: float  # processor time from the hit to the last uploaded byte
    upload_bytes: int


@dataclass(frozen=True)
class Run:
    """The viewer's runs of a model with a back end: all alike but for their times."""

    model: str
    backend: str
    graphics: str
    cuts: list[Cut]
    # frame_ms, simulate_cpu_ms, submit_cpu_ms, cut_to_upload_cpu_ms: each with min, median, ...
    times: dict[str, dict[str, float]]


@dataclass
class Measurements:
    """Everything that was measured. Stages that were not run leave their part empty."""

    bench: dict[str, Counters] = field(default_factory=dict)
    comparisons: dict[str, dict[str, Any]] = field(default_factory=dict)  # plane mix -> the JSON of kerf compare
    runs: list[Run] = field(default_factory=list)
    undrawn_runs: list[Run] = field(default_factory=list)  # of the viewer, without a picture
    peers: list[dict[str, Any]] = field(default_factory=list)  # rows of the peer programs
    slicers: list[dict[str, Any]] = field(default_factory=list)  # rows of the peer programs: sections
    cells: list[dict[str, Any]] = field(default_factory=list)  # rows of the peer programs: cells of a fracture
    drawn_caps: list[dict[str, Any]] = field(default_factory=list)  # rows of kerf compare --caps: the worst fans
    stages: list[dict[str, Any]] = field(default_factory=list)  # the stages' files, without their results

    def growth(self, kind: str, shape: str) -> dict[tuple[str, int], Counters]:
        """`Scale` or `Geometry` benchmarks of a shape, by back end and nominal size (as fits.crossover wants it)."""
        cells = {}
        for name, counters in self.bench.items():
            parts = name.split("/")
            if parts[0] == kind and parts[-2] == shape:
                cells[("/".join(parts[1:-2]), int(parts[-1]))] = counters
        return cells

    def sized(self, kind: str) -> Iterator[tuple[str, int, Counters]]:
        """Benchmarks named KIND/<back end>/<shape>/<size>: back end, size, counters, in order of size."""
        found = []
        for name, counters in self.bench.items():
            parts = name.split("/")
            if parts[0] == kind and parts[-1].isdigit():
                found.append(("/".join(parts[1:-2]), int(parts[-1]), counters))
        return iter(sorted(found, key=lambda row: (row[1], order(row[0]))))

    def of_model(self, kind: str, variant: str, model: str) -> Counters | None:
        return self.bench.get(f"{kind}/{variant}/{model}")

    def run_of(self, model: str, backend: str) -> Run | None:
        return next((run for run in self.runs if run.model == model and run.backend == backend), None)

    def undrawn_run_of(self, model: str, backend: str) -> Run | None:
        return next((run for run in self.undrawn_runs if run.model == model and run.backend == backend), None)

    def viewer_backends(self) -> list[str]:
        return sorted({run.backend for run in self.runs}, key=order)


def order(backend: str) -> int:
    """The place of a back end in tables and legends."""
    return BACKENDS.index(backend) if backend in BACKENDS else len(BACKENDS)


def model_name(file: str) -> str:
    stem = Path(file).stem
    return ASTEROID if stem.startswith(ASTEROID) else stem


def commits(found: Measurements) -> str:
    """At which the stages were run, the first of them first."""
    return ", ".join(dict.fromkeys(str(stage.get("commit", "unknown")) for stage in found.stages))


def load(stage_files: list[Path]) -> Measurements:
    """Reads stages' files; the order of `stage_files` is the order of runs."""
    all_of_them = Measurements()
    benchmarks: list[dict[str, Any]] = []
    for path in stage_files:
        stage = files.read_json(path)
        result = stage.pop("result")
        all_of_them.stages.append(stage)
        kind = Kind(stage["kind"])
        if kind == Kind.BENCH:
            benchmarks += result["benchmarks"]
        elif kind in (Kind.PEERS, Kind.VTK):
            all_of_them.peers += result["peers"]
        elif kind in (Kind.SLICERS, Kind.VTK_SECTIONS, Kind.OPEN3D_SECTIONS):
            all_of_them.slicers += result["sections"]
        elif kind == Kind.CELLS:
            all_of_them.cells += result["cells"]
        elif kind == Kind.COMPARE and stage["stage"].startswith(GALLERY):
            file = result["files"][0]
            all_of_them.drawn_caps.append({"model": model_name(file["file"])} | file["rows"][0])
        elif kind == Kind.COMPARE:
            all_of_them.comparisons[stage["stage"].removeprefix("compare-")] = result
        else:
            model = model_name(stage["command"][1])
            kept = all_of_them.undrawn_runs if stage["stage"].startswith(UNDRAWN) else all_of_them.runs
            for backend in dict.fromkeys(run["backend"] for run in result["runs"]):
                runs = [run for run in result["runs"] if run["backend"] == backend]
                warm = runs[1:] or runs  # the first warms up
                kept.append(viewer_run(model, result["graphics"], warm))
    all_of_them.bench = collect(benchmarks)
    return all_of_them


def viewer_run(model: str, graphics: str, runs: list[dict[str, Any]]) -> Run:
    """Of several alike the medians of their times, and the cuts of the last."""
    run = runs[-1]
    cuts = [Cut(model, run["backend"], cut["triangles"], cut["crossing"], cut["cut_to_upload_cpu_ms"],
                cut["bytes_uploaded"])
            for cut in run["cuts"] if cut["status"] == "cut"]
    times = {name: {what: statistics.median(each[name][what] for each in runs) for what in run[name]}
             for name in ("frame_ms", "simulate_cpu_ms", "submit_cpu_ms", "cut_to_upload_cpu_ms")}
    return Run(model, run["backend"], graphics, cuts, times)
