"""Runs the stages of a plan and keeps what each gave, so that an interrupted report goes on where it was.

A stage's file holds its command, a fingerprint of everything that decides its result, the machine's load before and
after, and the program's JSON. A stage is run again when its fingerprint has changed.
"""

import hashlib
import json
import os
import subprocess
import sys
import time
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from report import files, machine
from report.benchmarks import BenchmarkFailed, run_benchmarks
from report.names import Kind
from report.plan import Stage
from report.progress import Progress

FORMAT = 1  # of a stage's file


# Scripts, and how `kerf_peers` is asked for what they read.
SCRIPTS = {Kind.VTK: "export", Kind.VTK_SECTIONS: "export-sections", Kind.OPEN3D_SECTIONS: "export-sections"}


class StageFailed(Exception):
    """A program failed; the text says which and why."""


@dataclass(frozen=True)
class Programs:
    """The built programs, relative to the project's folder (where everything is run)."""

    bench: Path
    kerf: Path
    viewer: Path
    peers: Path
    vtk: Path
    vtk_sections: Path
    open3d_sections: Path

    @staticmethod
    def in_build(build: Path) -> "Programs":
        return Programs(build / "bench/kerf_bench", build / "tools/kerf", build / "viewer/app/kerf-viewer",
                        build / "bench/kerf_peers", Path("bench/peers/vtk_peer.py"),
                        Path("bench/peers/vtk_sections.py"), Path("bench/peers/open3d_sections.py"))

    def missing(self) -> Path | None:
        """The first of them that is not there."""
        return next((path for path in (self.of(kind) for kind in Kind) if not path.exists()), None)

    def of(self, kind: Kind) -> Path:
        return {Kind.BENCH: self.bench, Kind.COMPARE: self.kerf, Kind.VIEWER: self.viewer, Kind.PEERS: self.peers,
                Kind.VTK: self.vtk, Kind.SLICERS: self.peers, Kind.CELLS: self.peers, Kind.VTK_SECTIONS: self.vtk_sections,
                Kind.OPEN3D_SECTIONS: self.open3d_sections}[kind]


class Stages:
    """The stages' files in a folder."""

    def __init__(self, folder: Path, programs: Programs):
        self.folder, self.programs = folder, programs
        self.digests: dict[Path, str] = {}

    def file(self, stage: Stage) -> Path:
        return self.folder / f"{stage.name}.json"

    def forget(self) -> None:
        """Removes all stages' files."""
        for file in self.folder.glob("*.json"):
            file.unlink()

    def digest(self, path: Path) -> str:
        if path not in self.digests:
            self.digests[path] = hashlib.sha256(path.read_bytes()).hexdigest()
        return self.digests[path]

    def fingerprint(self, stage: Stage) -> str:
        """Of the program, its arguments and the models it reads."""
        parts = [str(FORMAT), self.digest(self.programs.of(stage.kind)), *stage.arguments, *stage.shape]
        if stage.shape:
            parts.append(self.digest(self.programs.kerf))
        if stage.kind in SCRIPTS:
            parts.append(self.digest(self.programs.peers))
        parts += [self.digest(model) for model in sorted(Path("data/models").glob("*.obj"))]
        return hashlib.sha256("\n".join(parts).encode()).hexdigest()

    def finished(self, stage: Stage) -> bool:
        """Whether the stage's file is there, whole, and still right."""
        try:
            return files.read_json(self.file(stage))["fingerprint"] == self.fingerprint(stage)
        except (OSError, ValueError, KeyError, TypeError):
            return False

    def run_all(self, to_do: list[Stage]) -> None:
        """Runs those that are not there yet, and says on the standard error how far it is. Raises StageFailed."""
        waiting = [stage for stage in to_do if not self.finished(stage)]
        if len(waiting) < len(to_do):
            print(f"report: {len(to_do) - len(waiting)} of {len(to_do)} stages are there already", file=sys.stderr)
        progress = Progress({stage.name: stage.expected_seconds for stage in waiting})
        for stage in waiting:
            progress.begin(stage.name)
            self.run(stage, progress)
            progress.end()
        progress.clear()

    def run(self, stage: Stage, progress: Progress) -> None:
        """Raises StageFailed; then nothing is kept of this stage."""
        before, start = os.getloadavg()[0], time.monotonic()
        make_model(self.programs.kerf, stage)
        result = self.run_program(stage, progress)
        files.write_json(self.file(stage), {
            "stage": stage.name, "kind": stage.kind.value,
            "command": [str(self.programs.of(stage.kind)), *stage.arguments],
            "fingerprint": self.fingerprint(stage), "commit": machine.commit(), "date": time.strftime("%Y-%m-%d %H:%M"),
            "seconds": round(time.monotonic() - start, 2), "load": [before, os.getloadavg()[0]], "result": result})

    def run_program(self, stage: Stage, progress: Progress) -> Any:
        program = self.programs.of(stage.kind)
        if stage.kind == Kind.BENCH:
            return run_bench(program, stage, progress, self.folder)
        if stage.kind == Kind.COMPARE:
            # Exit status 1 with JSON says that the back ends do not agree: a result, and the page shows it.
            return run_for_json([program, "compare", *stage.arguments], accepted=(0, 1))
        if stage.kind == Kind.PEERS:
            return run_for_json([program, "cgal", *stage.arguments], accepted=(0,))
        if stage.kind == Kind.SLICERS:
            return run_for_json([program, "sections", *stage.arguments], accepted=(0,))
        if stage.kind == Kind.CELLS:
            return run_for_json([program, "cells", *stage.arguments], accepted=(0,))
        if stage.kind in SCRIPTS:
            return run_script(self.programs.peers, SCRIPTS[stage.kind], program, stage)
        return run_for_json([program, *stage.arguments], accepted=(0,))


def run_bench(program: Path, stage: Stage, progress: Progress, folder: Path) -> Any:
    pattern, repetitions, min_time = stage.arguments
    folder.mkdir(parents=True, exist_ok=True)
    out = folder / (stage.name + files.PARTIAL)
    try:
        result = run_benchmarks(program, pattern, repetitions, min_time, progress.update, out)
    except BenchmarkFailed as error:
        raise StageFailed(str(error)) from None
    finally:
        out.unlink(missing_ok=True)
    for private in ("host_name", "executable"):
        result["context"].pop(private, None)
    return result


def run_script(peers: Path, export: str, script: Path, stage: Stage) -> Any:
    """Writes the inputs, then lets another library have them."""
    budget, folder, *sizes = stage.arguments
    inputs = Path(folder) / f"{export}.json"
    files.write_json(inputs, run_for_json([peers, export, folder, *sizes], accepted=(0,)))
    return run_for_json(["/usr/bin/python3", script, inputs, "--seconds", budget], accepted=(0,))


def run_for_json(command: list[Any], accepted: tuple[int, ...]) -> Any:
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    try:
        if done.returncode in accepted:
            return json.loads(done.stdout)
    except ValueError:
        pass
    raise StageFailed(f"{command[0]} failed with exit status {done.returncode}:\n{done.stderr.strip()}")


def make_model(kerf: Path, stage: Stage) -> None:
    if not stage.shape:
        return
    Path(stage.shape[-1]).parent.mkdir(parents=True, exist_ok=True)
    done = subprocess.run([kerf, "shape", *stage.shape], capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise StageFailed(f"{kerf} shape failed:\n{done.stderr.strip()}")
