#!/usr/bin/env python3
"""Checks that two builds of `kerf` write the same bytes.

Every model, every generated shape and every mesh of a folder is cut by seeded planes with both back ends, whole and in
pieces; the PLY files, the exit statuses and all that is said but times must be equal. For changes that are to change no
result: build the commit before in a folder of its own, then

    tests/soak/same_bytes.py OLD/build/release/tools/kerf NEW/build/release/tools/kerf --meshes ../shared/meshes
"""

import argparse
import concurrent.futures
import json
import os
import random
import re
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
ENDINGS = {".obj", ".ply", ".stl", ".off", ".glb", ".gltf"}
SHAPE_TRIANGLES = 3000
WAYS = [("--backend", "halfedge"), ("--lookup", "hash"), ("--lookup", "remap")]
TIMES = {"ms", "times", "phases"}  # what JSON says of a run and not of its result


def run(*command):
    return subprocess.run([str(word) for word in command], capture_output=True, text=True, errors="replace")


def shapes_of(kerf):
    """The names of all shapes that a build makes, from its help."""
    listed = re.search(r"^Shapes: (.*?)\.$", run(kerf, "shape", "--help").stdout, re.M | re.S)
    return re.findall(r"\w+", listed.group(1)) if listed else []


def without_times(value):
    """JSON without what differs from run to run: values whose name says that they are times."""
    if isinstance(value, dict):
        return {name: without_times(item) for name, item in value.items()
                if name not in TIMES and not name.endswith("_ms")}
    return [without_times(item) for item in value] if isinstance(value, list) else value


def said(text, folder):
    """What a program printed, without its times and without where it ran."""
    text = text.replace(str(folder), "")
    try:
        return without_times(json.loads(text))
    except json.JSONDecodeError:
        return text


def result_of(kerf, folder, mesh, plane, way, pieces):
    """All that one cut gives: exit status, what is said, and the bytes of every file by name."""
    done = run(kerf, "cut", mesh, *plane, *way, *pieces, "--format", "ply", "--out", folder / "cut", "--json")
    files = {}
    for path in sorted(folder.iterdir()):
        files[path.name] = path.read_bytes()
        path.unlink()
    return done.returncode, said(done.stdout, folder), said(done.stderr, folder), files


def planes_of(info, count, seed):
    """Options of `kerf cut`: across the three axes through the middle, which meets vertices and faces, then any plane."""
    lo, hi = info["bounds"]["min"], info["bounds"]["max"]
    middle = [(a + b) / 2 for a, b in zip(lo, hi)]
    dice = random.Random(seed)
    for number in range(count):
        normal = [float(axis == number) for axis in range(3)]
        point = middle
        if number >= 3:
            normal = [dice.uniform(-1, 1) for _ in range(3)]
            point = [m + dice.uniform(-0.3, 0.3) * (b - a) for m, a, b in zip(middle, lo, hi)]
        yield [f"--point={','.join(map(repr, point))}", f"--normal={','.join(map(repr, normal))}"]


def compare(job):
    """Cuts one mesh with both builds. Returns the number of cuts, of files and the differences."""
    old, new, mesh, count, seed = job
    cuts, files, differences = 0, 0, []
    infos = [run(kerf, "info", mesh, "--json") for kerf in (old, new)]
    if len({(info.returncode, info.stdout, info.stderr) for info in infos}) > 1:
        differences.append(f"{mesh.name}: kerf info says something else")
    if infos[0].returncode != 0:
        return cuts, files, differences
    with tempfile.TemporaryDirectory() as scratch:
        for number, plane in enumerate(planes_of(json.loads(infos[0].stdout), count, seed)):
            for way in WAYS:
                for pieces in ([], ["--components"]):
                    before, after = (result_of(kerf, Path(scratch), mesh, plane, way, pieces) for kerf in (old, new))
                    cuts += 1
                    files += len(before[3])
                    if before != after:
                        words = " ".join([*plane, *way, *pieces])
                        differences.append(f"{mesh.name} plane {number}: kerf cut {mesh} {words}")
    return cuts, files, differences


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("old", type=Path, help="the program kerf of one build")
    parser.add_argument("new", type=Path, help="that of another")
    parser.add_argument("--meshes", type=Path, action="append", default=[], help="a folder of more meshes")
    parser.add_argument("--planes", type=int, default=20, help="how many cut each mesh (%(default)s)")
    parser.add_argument("--seed", type=int, default=1, help="another seed gives other planes")
    arguments = parser.parse_args()
    old, new = arguments.old.resolve(), arguments.new.resolve()
    for kerf in (old, new):
        if not os.access(kerf, os.X_OK):
            sys.exit(f"same_bytes: there is no program {kerf}")

    with tempfile.TemporaryDirectory() as folder:
        names = shapes_of(new)
        if not names or not set(shapes_of(old)) <= set(names):
            sys.exit("same_bytes: a build lists no shapes, or fewer than before")
        shapes = [Path(folder) / f"{name}.ply" for name in shapes_of(old)]
        for shape in shapes:
            made = []
            for kerf in (old, new):
                if run(kerf, "shape", shape.stem, "-n", SHAPE_TRIANGLES, "-o", shape).returncode != 0:
                    sys.exit(f"same_bytes: {kerf} does not make the shape {shape.stem}")
                made.append(shape.read_bytes())
            if made[0] != made[1]:
                sys.exit(f"same_bytes: the shape {shape.stem} differs")
        folders = [ROOT / "data" / "models", ROOT / "data" / "fruit", *arguments.meshes]
        meshes = shapes + [path for where in folders for path in sorted(where.iterdir()) if path.suffix.lower() in ENDINGS]
        jobs = [(old, new, mesh, arguments.planes, arguments.seed) for mesh in meshes]
        cuts, files, differences = 0, 0, []
        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            for mesh, found in zip(meshes, pool.map(compare, jobs)):
                cuts, files, differences = cuts + found[0], files + found[1], differences + found[2]
                print(f"{mesh.name}: {found[0]} cuts, {found[1]} files, {len(found[2])} differ", flush=True)
    print(*differences, sep="\n", end="\n" if differences else "")
    print(f"{len(meshes)} meshes, {cuts} cuts, {files} files: {len(differences)} differ")
    return 1 if differences or cuts == 0 or files == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
