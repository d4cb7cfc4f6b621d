#!/usr/bin/env python3
"""Reads and cuts the meshes in Debian's own packages: files that nobody here wrote.

Each file is read by `kerf info` and by `assimp info`, and cut by `kerf compare`, in processes of their own with limits of
time and memory. What was found is kept at once; run again, it goes on where it stopped. It fails if a file is refused
that Assimp reads, if triangles are counted otherwise, or if a cut is wrong, unless exceptions.py gives the reason.
"""

import argparse
import concurrent.futures
import fnmatch
import gzip
import hashlib
import json
import re
import resource
import shutil
import signal
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

from exceptions import EXCEPTIONS

PACKAGES = ["assimp-testmodels", "cura", "openfoam-examples", "prusa-slicer"]
ENDINGS = {".obj", ".ply", ".stl", ".off", ".glb", ".gltf"}
SECONDS, GIGABYTES = 300, 6  # of one process: none takes a tenth
LARGE_FILE = 4_000_000  # bytes: cut by fewer planes
DOCUMENT = Path("docs/world.md")


@dataclass(frozen=True)
class Ending:
    """How a process ended."""

    status: int  # exit status, or minus the signal
    out: str
    err: str
    in_time: bool = True

    def crashed(self):
        return self.in_time and self.status < 0

    def sentence(self):
        lines = self.err.strip().splitlines()
        return lines[-1].removeprefix("kerf: ") if lines else ""


def bounded():
    resource.setrlimit(resource.RLIMIT_AS, (GIGABYTES << 30, GIGABYTES << 30))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))


def run(*command):
    child = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, stdin=subprocess.DEVNULL,
                             text=True, errors="replace", preexec_fn=bounded)
    try:
        out, err = child.communicate(timeout=SECONDS)
        return Ending(child.returncode, out, err)
    except subprocess.TimeoutExpired:
        child.kill()
        child.communicate()
        return Ending(-signal.SIGKILL, "", "", in_time=False)


def fetch(folder):
    """Downloads the packages and takes them apart below `folder`; nothing is installed."""
    archives = folder / "packages"
    archives.mkdir(parents=True, exist_ok=True)
    for package in PACKAGES:
        files = folder / "files" / package
        if files.exists():
            continue
        print(f"world: fetching {package}", file=sys.stderr, flush=True)
        if not any(archives.glob(f"{package}_*.deb")):
            done = subprocess.run(["apt-get", "download", package], cwd=archives, capture_output=True, text=True)
            if done.returncode != 0:
                sys.exit(f"world: {package} cannot be downloaded: {done.stderr.strip()}\nTry: apt-get update")
        archive = sorted(archives.glob(f"{package}_*.deb"))[-1]
        unpacked = folder / "files" / f"{package}.unpacking"
        shutil.rmtree(unpacked, ignore_errors=True)  # of a run that was stopped
        unpacked.mkdir(parents=True)
        subprocess.run(["dpkg-deb", "-x", archive, unpacked], check=True)
        unpack(unpacked)
        unpacked.rename(files)


def unpack(folder):
    """Puts each packed mesh unpacked beside itself."""
    for packed in folder.rglob("*.gz"):
        mesh = packed.with_suffix("")
        if packed.is_file() and mesh.suffix.lower() in ENDINGS and not mesh.exists():
            mesh.write_bytes(gzip.decompress(packed.read_bytes()))


def meshes(folder):
    """The regular files that end like meshes; links to them are not counted twice."""
    return sorted(path for package in PACKAGES for path in (folder / "files" / package).rglob("*")
                  if path.suffix.lower() in ENDINGS and path.is_file() and not path.is_symlink())


def assimp_triangles(text):
    """What `assimp info --raw` counts, as often as nodes show it: (triangles, whether there are polygons)."""
    triangles, has_polygons = {}, False
    for number, faces, kinds in re.findall(r"^ +(\d+) \(.*\): \[\d+ / \d+ / (\d+) \| (.*)\]$", text, re.MULTILINE):
        triangles[int(number)] = int(faces) if "triangle" in kinds or "polygon" in kinds else 0
        has_polygons = has_polygons or "polygon" in kinds
    shown = [int(number) for numbers in re.findall(r"\(mesh (\d+(?:, \d+)*)\)$", text, re.MULTILINE)
             for number in numbers.split(", ")]
    return sum(triangles.get(number, 0) for number in shown or triangles), has_polygons


def read_by_assimp(path):
    """Triangles as Assimp has them, or None and what it says."""
    ending = run("assimp", "info", path, "--raw")
    if ending.status == 0:
        triangles, has_polygons = assimp_triangles(ending.out)
        if has_polygons:  # only its post-processing makes triangles of them, which drops some
            ending = run("assimp", "info", path)
            triangles = assimp_triangles(ending.out)[0]
        if ending.status == 0:
            return {"assimp": triangles, "assimp_polygons": has_polygons} if triangles else {
                "assimp": None, "assimp_says": "it has no triangles"}
    if not ending.in_time:
        return {"assimp": None, "assimp_says": f"not done within {SECONDS} s"}
    if ending.crashed():
        return {"assimp": None, "assimp_says": f"died by {signal.Signals(-ending.status).name}"}
    error = re.search(r"ERROR: Failed to load file: *(.*)", ending.out + ending.err)
    return {"assimp": None, "assimp_says": error.group(1).replace(str(path), path.name) if error else "it refuses it"}


def read_by_kerf(kerf, path, name):
    ending = run(kerf, "info", "--json", path)
    if not ending.in_time:
        return {"outcome": "hung", "says": f"kerf info was not done within {SECONDS} s"}
    if ending.crashed():
        return {"outcome": "crashed", "says": f"kerf info died by {signal.Signals(-ending.status).name}"}
    if ending.status != 0:
        return {"outcome": "refused", "says": ending.sentence().replace(f"{path}: ", "").replace(str(path), name)}
    facts = json.loads(ending.out)
    result = {name: facts[name] for name in ("triangles", "closed", "degenerate_triangles", "duplicate_triangles")}
    result["notes"] = ", ".join(f"{note['count']} {note['what']}" for note in facts.get("notes", []))
    return result


def cut_by_kerf(kerf, path, seed):
    few = path.stat().st_size > LARGE_FILE
    ending = run(kerf, "compare", path, "--planes", "4" if few else "8", "--depth", "1" if few else "2", "--seed", str(seed),
                 "--quiet", "--json")
    if not ending.in_time:
        return {"outcome": "hung", "says": f"kerf compare was not done within {SECONDS} s"}
    if ending.crashed():
        return {"outcome": "crashed", "says": f"kerf compare died by {signal.Signals(-ending.status).name}"}
    try:
        found = json.loads(ending.out)
    except ValueError:
        return {"outcome": "wrong", "says": ending.sentence()}
    outcome = {"cuts": found["total"]["cut"], "missed": found["total"]["missed"]}
    if ending.status == 0:
        return {"outcome": "right", **outcome}
    failures = [failure for file in found["files"] for failure in file["failures"]]
    return {"outcome": "wrong", "says": "; ".join([f"{found['total']['failed']} rows of kerf compare failed", *failures]), **outcome}


def look_at(kerf, path, name, seed):
    result = {"name": name, **read_by_kerf(kerf, path, name), **read_by_assimp(path)}
    if "outcome" not in result:
        result.update(cut_by_kerf(kerf, path, seed))
    return result


def is_counted_alike(result):
    """Whether both have the same triangles; Assimp drops degenerate ones, and those given twice, where it makes them of polygons."""
    least = result["triangles"]
    if result["assimp_polygons"]:
        least -= result["degenerate_triangles"] + result["duplicate_triangles"]
    return least <= result["assimp"] <= result["triangles"]


def finding(result):
    """What is remarkable about a file in words; None if Kerf and Assimp agree and its cuts are right."""
    if result["outcome"] in ("hung", "crashed", "wrong"):
        return f"**{result['outcome']}**: {result['says']}"
    if result["outcome"] == "refused":
        has = f"{result['assimp']:,} triangles" if result["assimp"] is not None else result["assimp_says"]
        return f"refused: {result['says']} (Assimp: {has})"
    if result["assimp"] is None:
        return f"{result['triangles']:,} triangles (Assimp: {result['assimp_says']})"
    if not is_counted_alike(result):
        return f"{result['triangles']:,} triangles (Assimp: {result['assimp']:,})"
    return None


def needs_reason(result):
    """Whether something is worse than in Assimp, or wrong."""
    if result["outcome"] in ("hung", "crashed", "wrong"):
        return True
    return result["assimp"] is not None and (result["outcome"] == "refused" or not is_counted_alike(result))


def reason(result):
    return next((why for pattern, why in EXCEPTIONS if fnmatch.fnmatchcase(result["name"], pattern)), None)


def format_of(name):
    return Path(name).suffix.lower()[1:].replace("glb", "gltf")


def table(results):
    """One row a package and format, as Markdown."""
    lines = ["| package | format | files | read | refused | cut right | wrong | crashed or hung | Assimp reads | counted alike "
             "| read by Assimp alone | read by Kerf alone |", "|---|---|" + "---:|" * 10]
    groups = {}
    for result in results:
        groups.setdefault((result["name"].split("/")[0], format_of(result["name"])), []).append(result)
    for (package, kind), rows in [*sorted(groups.items()), (("**all**", ""), results)]:
        outcomes = [row["outcome"] for row in rows]
        read = [row for row in rows if "triangles" in row]
        numbers = [len(rows), len(read), outcomes.count("refused"), outcomes.count("right"), outcomes.count("wrong"),
                   outcomes.count("crashed") + outcomes.count("hung"), sum(row["assimp"] is not None for row in rows),
                   sum(row["assimp"] is not None and is_counted_alike(row) for row in read),
                   sum(row["assimp"] is not None and "triangles" not in row for row in rows),
                   sum(row["assimp"] is None for row in read)]
        lines.append(f"| {package} | {kind} | " + " | ".join(f"{number:,}" for number in numbers) + " |")
    return lines


def summary(results, version):
    """The page, as Markdown."""
    cuts, missed = (sum(row.get(name, 0) for row in results) for name in ("cuts", "missed"))
    triangles = sum(row.get("triangles", 0) for row in results)
    lines = ["# Files that others wrote", "",
             f"`./run world` reads and cuts the meshes in Debian's packages {', '.join(f'`{package}`' for package in PACKAGES)}, beside "
             "`assimp info`. Each file is looked at by processes of their own, with limits of time and memory. This page is its "
             f"result ({version}).", "",
             f"{len(results):,} files, {triangles:,} triangles, {cuts:,} cuts by `kerf compare` with both back ends ({missed:,} planes missed).",
             "Triangles are counted as nodes of a scene show them. *Counted alike*: Assimp has as many; where a file has polygons, as many "
             "but for degenerate and repeated ones, which Assimp drops when it triangulates.",
             "*Cut right*: `kerf compare` finds nothing wrong. It cuts by eight planes - random ones and ones through vertices, along edges "
             f"and in faces - and each piece once more (files of more than {LARGE_FILE // 1_000_000} MB: by four, not again), reads off what comes out, "
             "and looks whether both back ends make the same surfaces, nothing is opened that was closed, caps have the areas of "
             "their sections or the cut says that they have not, and volumes add up.", "", *table(results), ""]
    for title, chosen in [("Refused, or counted otherwise than by Assimp",
                           [row for row in results if finding(row) and (needs_reason(row) or row["outcome"] == "refused")]),
                          ("Read by Kerf alone",
                           [row for row in results if finding(row) and not needs_reason(row) and row["outcome"] != "refused"])]:
        lines += [f"## {title}", ""] + ([] if chosen else ["None.", ""])
        if not chosen:
            continue
        lines += ["| file | what | reason |", "|---|---|---|"]
        for row in chosen:
            why = reason(row) or ("**none is known**" if needs_reason(row) else "")
            lines.append("| " + " | ".join(escaped(text) for text in (short(row["name"]), finding(row), why)) + " |")
        lines.append("")
    noted = [row for row in results if row.get("notes")]
    lines += ["## Read with notes", "", "What the readers were lenient about (`kerf info`, \"notes\").", "", "| file | notes |", "|---|---|"]
    lines += [f"| {short(row['name'])} | {escaped(row['notes'])} |" for row in noted]
    return "\n".join(lines) + "\n"


def escaped(text):
    return text.replace("|", "\\|")


def short(name):
    """Without the folders that all files of a package are in."""
    parts = name.split("/")
    return "/".join([parts[0], *(part for part in parts[1:-1] if part not in ("usr", "share", "doc", "models", parts[0])), parts[-1]])


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--kerf", type=Path, required=True, help=argparse.SUPPRESS)
    parser.add_argument("--jobs", type=int, default=2, help="files at once (default %(default)s)")
    parser.add_argument("--seed", type=int, default=1, help="of the planes")
    parser.add_argument("--only", default="*", help="files whose name fits this pattern, for example '*.off'")
    parser.add_argument("--fresh", action="store_true", help="forget what an earlier run found")
    parser.add_argument("--publish", action="store_true", help=f"write the result to {DOCUMENT}")
    parser.add_argument("--out", type=Path, default=Path("build/world"), help="where packages and results are kept")
    arguments = parser.parse_args()
    if arguments.publish and arguments.only != "*":
        sys.exit("world: only a run of all files can be published; leave --only out")

    fetch(arguments.out)
    kerf = arguments.kerf.resolve()
    build = hashlib.sha256(kerf.read_bytes()).hexdigest()[:16]
    kept = arguments.out / f"results-{build}-{arguments.seed}.jsonl"
    if arguments.fresh:
        kept.unlink(missing_ok=True)
    results = {}
    for line in kept.read_text().splitlines() if kept.exists() else []:
        try:
            result = json.loads(line)
            results[result["name"]] = result
        except ValueError:
            pass  # the line under way when the run was killed: that file is looked at again
    root = (arguments.out / "files").resolve()
    paths = {str(path.resolve().relative_to(root)): path for path in meshes(arguments.out)}
    paths = {name: path for name, path in paths.items() if fnmatch.fnmatch(name, arguments.only)}
    left = [name for name in paths if name not in results]
    with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool, open(kept, "a") as file:
        pending = [pool.submit(look_at, kerf, paths[name], name, arguments.seed) for name in left]
        try:
            for done, future in enumerate(concurrent.futures.as_completed(pending), 1):
                result = future.result()
                results[result["name"]] = result
                file.write(json.dumps(result) + "\n")
                file.flush()
                if done % 50 == 0:
                    print(f"world: {done} of {len(left)} files", file=sys.stderr, flush=True)
        except KeyboardInterrupt:
            pool.shutdown(cancel_futures=True)
            sys.exit("\nworld: stopped; the same command goes on from here")

    chosen = [results[name] for name in paths]
    print("\n".join(table(chosen)))
    for row in chosen:
        if finding(row) and (needs_reason(row) or row["outcome"] == "refused"):
            print(f"* {row['name']}: {finding(row)}" + (f" [{reason(row)}]" if reason(row) else ""))
    if arguments.publish:
        version = subprocess.run(["git", "rev-parse", "--short", "HEAD"], capture_output=True, text=True).stdout.strip()
        DOCUMENT.write_text(summary(chosen, f"commit {version}" if version else "no commit"))
        print(f"world: wrote {DOCUMENT}")
    unexplained = [row for row in chosen if needs_reason(row) and reason(row) is None]
    if unexplained:
        sys.exit(f"world: {len(unexplained)} files without a reason")


if __name__ == "__main__":
    main()
