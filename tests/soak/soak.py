#!/usr/bin/env python3
"""Cuts a hundred thousand times with both back ends and keeps what went wrong.

Every task is one run of `kerf compare` in a process of its own, so that a crash or a hang is a finding like any other.
What a task found is kept in a file at once; run again, the soak goes on where it stopped.
"""

import argparse
import concurrent.futures
import hashlib
import json
import os
import shutil
import signal
import subprocess
import sys
import threading
import time
from dataclasses import dataclass
from pathlib import Path

SHAPES = ["asteroid", "bowl", "box", "comb", "cone", "cylinder", "icosphere", "l_step", "menger_sponge", "nested_spheres",
          "overlapping_spheres", "pipe", "sphere_in_sphere", "spiral_wall", "torus", "tray", "two_legs", "uv_sphere"]
SHAPE_SIZES = [60, 700, 5000]  # triangles, one size a round
MESH_ENDINGS = {".obj", ".ply", ".stl", ".off", ".glb", ".gltf"}
LARGE_FILE = 4_000_000  # bytes: cut by fewer planes
DEPTHS = [5, 1, 3]  # cuts in a row, one depth a round
PLANES = {1: 120, 3: 30, 5: 12}
TASK_SECONDS = 900  # a task takes seconds; one that takes this long hangs
COUNTS = ["cut", "missed", "failed", "surfaces_differ", "pieces_differ", "caps_wrong", "not_judged", "open_edges",
          "equal_corners"]


@dataclass(frozen=True)
class Task:
    """One mesh, one seed. `group` is where the summary counts it."""

    group: str
    mesh: str  # a file, or NAME:TRIANGLES:SEED of a generated shape
    planes: int
    depth: int
    seed: int

    def key(self):
        return f"{self.mesh} {self.planes} {self.depth} {self.seed}"


def tasks(models, shared, first_seed):
    """Without end: round after round over all meshes, with new seeds."""
    seed = first_seed
    turn = 0
    while True:
        depth = DEPTHS[turn % len(DEPTHS)]
        for model in models:
            yield Task("the report's models", str(model), PLANES[depth], depth, seed)
        for number, name in enumerate(SHAPES):
            size = SHAPE_SIZES[(turn + number) % len(SHAPE_SIZES)]
            yield Task("generated shapes", f"{name}:{size}:{seed}", PLANES[depth], depth, seed)
        for mesh in shared:
            large = mesh.stat().st_size > LARGE_FILE
            yield Task("meshes from elsewhere", str(mesh), 4 if large else PLANES[depth], 2 if large else depth, seed)
        seed += 1
        turn += 1


class Soak:
    """Runs tasks and keeps their results in `folder`."""

    def __init__(self, kerf, folder):
        self.kerf, self.folder = kerf, folder
        self.build = hashlib.sha256(kerf.read_bytes()).hexdigest()[:16]
        folder.mkdir(parents=True, exist_ok=True)
        self.file = folder / "tasks.jsonl"
        self.lock = threading.Lock()
        self.running = set()
        self.results = {}
        self.of_other_builds = 0
        self.shapes = folder / "shapes"
        shutil.rmtree(self.shapes, ignore_errors=True)  # of a soak that was killed
        self.shapes.mkdir()
        if self.file.exists():
            for line in self.file.read_text().splitlines():
                try:
                    result = json.loads(line)
                    if result["build"] == self.build:
                        self.results[result["key"]] = result
                    else:
                        self.of_other_builds += 1
                except (ValueError, KeyError):
                    pass  # the line under way when the soak was killed: that task is run again

    def cuts(self):
        return sum(result["cut"] for result in self.results.values())

    def process(self, command):
        """Exit status and output; the status is None when it had to be killed for taking too long."""
        child = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        with self.lock:
            self.running.add(child)
        try:
            out, err = child.communicate(timeout=TASK_SECONDS)
            return child.returncode, out, err
        except subprocess.TimeoutExpired:
            child.kill()
            child.communicate()
            return None, "", ""
        finally:
            with self.lock:
                self.running.discard(child)

    def run(self, task):
        mesh = task.mesh
        if task.group == "generated shapes":
            name, triangles, seed = mesh.split(":")
            mesh = str(self.shapes / f"{name}-{triangles}-{seed}.ply")
            status, _, err = self.process([self.kerf, "shape", name, "--triangles", triangles, "--seed", seed, "--out", mesh])
            if status != 0:
                return self.finding(task, f"kerf shape failed: {err.strip()}")
        command = [self.kerf, "compare", mesh, "--planes", str(task.planes), "--depth", str(task.depth), "--seed",
                   str(task.seed), "--quiet", "--json"]
        status, out, err = self.process(command)
        if task.group == "generated shapes":
            Path(mesh).unlink(missing_ok=True)
        if status is None:
            return self.finding(task, f"did not end within {TASK_SECONDS} s")
        if status < 0:
            return self.finding(task, f"died by {signal.Signals(-status).name}: {err.strip()[-300:]}")
        try:
            total = json.loads(out)["total"]
            closed = all(file["closed"] for file in json.loads(out)["files"])
            failures = [failure for file in json.loads(out)["files"] for failure in file["failures"]]
        except (ValueError, KeyError):
            return self.finding(task, f"exit status {status}: {err.strip()[-300:]}")
        result = {"key": task.key(), "group": task.group, "mesh": task.mesh, "closed": closed}
        result.update({name: total[name] for name in ("cut", "missed", "failed", "surfaces_differ", "pieces_differ",
                                                    "caps_wrong")})
        result["build"] = self.build
        result["open_edges"] = total["open_edges"]["halfedge"] + total["open_edges"]["baseline"] if closed else 0
        result["equal_corners"] = total["equal_corners"]["halfedge"] + total["equal_corners"]["baseline"]
        result["not_judged"] = total["sections_that_intersect_themselves"] + total["sections_not_judged"]
        result["volume_error"] = max(total["volume_error"].values()) if closed else 0.0
        if total["failed"] or failures or total["surfaces_differ"]:
            result["finding"] = f"{total['failed']} rows failed {failures}".strip()
            result["command"] = " ".join(str(part) for part in command)
        return result

    def finding(self, task, text):
        return {"key": task.key(), "group": task.group, "mesh": task.mesh, "closed": False, "build": self.build,
                **dict.fromkeys(COUNTS, 0), "failed": 1, "volume_error": 0.0, "finding": text}

    def keep(self, result):
        with self.lock:
            self.results[result["key"]] = result
            with open(self.file, "a") as file:
                file.write(json.dumps(result) + "\n")

    def stop(self):
        with self.lock:
            for child in self.running:
                child.kill()


def show_progress(soak, wanted, start, cuts_before, last):
    now = time.monotonic()
    terminal = sys.stderr.isatty()
    if now - last < (0.5 if terminal else 30):
        return last
    done = soak.cuts()
    rate = (done - cuts_before) / max(now - start, 1e-3)
    left = f"{(wanted - done) / rate / 60:.0f} min left" if rate > 0 and done < wanted else "ending"
    findings = sum("finding" in result for result in soak.results.values())
    print(f"{chr(13) if terminal else ''}soak: {done:,} of {wanted:,} cuts, {findings} findings, {rate:.0f} cuts/s, {left}    ",
          end="" if terminal else "\n", file=sys.stderr, flush=True)
    return now


def summary(results, first_seed):
    """The table that docs/verification.md shows, as Markdown."""
    lines = ["| | meshes | cuts | missed | rows that failed | surfaces that differ | pieces that differ | "
             "half-edge caps of a wrong area | "
             "caps not judged | open edges on closed input | triangles with equal corners | worst volume error |",
             "|---|" + "---:|" * 11]
    groups = {}
    for result in results:
        groups.setdefault(result["group"], []).append(result)
    for group, members in [*groups.items(), ("**all**", results)]:
        meshes = len({member["mesh"].split(":")[0] for member in members})
        numbers = [sum(member[name] for member in members) for name in COUNTS]
        worst = max((member["volume_error"] for member in members), default=0.0)
        lines.append(f"| {group} | {meshes} | " + " | ".join(f"{number:,}" for number in numbers) + f" | {worst:.1e} |")
    lines += ["", f"First seed {first_seed}, {len(results):,} runs of `kerf compare`, one to five cuts in a row.",
              "A cap is not judged by its area where its section intersects itself."]
    findings = [result for result in results if "finding" in result]
    lines += ["No run crashed, hung or failed."] if not findings else ["Findings:"] + [
        f"* {result['mesh']}: {result['finding']}" + (f" (`{result['command']}`)" if "command" in result else "")
        for result in findings]
    return "\n".join(lines) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--kerf", type=Path, required=True, help=argparse.SUPPRESS)
    parser.add_argument("--cuts", type=int, default=100_000, help="stop after so many cuts (default %(default)s)")
    parser.add_argument("--seed", type=int, default=1, help="the first round's seed")
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), help="processes at once")
    parser.add_argument("--out", type=Path, default=Path("build/soak"), help="where results are kept")
    parser.add_argument("--fresh", action="store_true", help="forget what an earlier run found")
    arguments = parser.parse_args()

    if arguments.fresh and arguments.out.exists():
        (arguments.out / "tasks.jsonl").unlink(missing_ok=True)
    models = sorted(Path("data/models").glob("*.obj"))
    shared = sorted(path for path in Path("../shared/meshes").glob("*") if path.suffix.lower() in MESH_ENDINGS)
    if not shared:
        print("soak: there is no ../shared/meshes; going on without meshes from elsewhere", file=sys.stderr)
    soak = Soak(arguments.kerf.resolve(), arguments.out)
    if soak.of_other_builds:
        print(f"soak: {soak.of_other_builds} runs of other builds are there and do not count", file=sys.stderr)
    start, cuts_before, last = time.monotonic(), soak.cuts(), 0.0
    upcoming = (task for task in tasks(models, shared, arguments.seed) if task.key() not in soak.results)
    with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        pending = set()
        try:
            while True:
                while len(pending) < arguments.jobs and soak.cuts() < arguments.cuts:
                    pending.add(pool.submit(soak.run, next(upcoming)))
                if not pending:
                    break
                done, pending = concurrent.futures.wait(pending, timeout=1, return_when=concurrent.futures.FIRST_COMPLETED)
                for task in done:
                    soak.keep(task.result())
                last = show_progress(soak, arguments.cuts, start, cuts_before, last)
        except KeyboardInterrupt:
            soak.stop()
            sys.exit(f"\nsoak: stopped after {soak.cuts():,} cuts; the same command goes on from here")
    text = summary(list(soak.results.values()), arguments.seed)
    (arguments.out / "summary.md").write_text(text)
    print(("\n" if sys.stderr.isatty() else "") + text)
    print(f"{(time.monotonic() - start) / 60:.1f} min; kept in {arguments.out}/summary.md")
    sys.exit(1 if any("finding" in result for result in soak.results.values()) else 0)


if __name__ == "__main__":
    main()
