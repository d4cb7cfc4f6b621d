"""Kerf's Debian packages: what is in them, and what becomes of them on this machine.

They are installed, used in a folder elsewhere and purged again, whatever fails; then no file is left that was not there
before. That needs root.
"""

import contextlib
import gzip
import json
import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile
from pathlib import Path

from shared_libraries import check_shared
from users import COMPILERS, ROOT, VARIANTS, Failed, check_consumer, check_pkg_config, consumer, run, say

BUILD = ROOT / "build/debs"
ABI = ".".join(re.findall(r"define KERF_VERSION_M\w+ (\d+)", (ROOT / "include/kerf/version.h").read_text()))
LIBRARY, CAPS, PROGRAMS = f"libkerf{ABI}", f"libkerf-caps-cgal{ABI}", ("kerf", "kerf-viewer")
PACKAGES = {LIBRARY, "libkerf-dev", CAPS, "libkerf-caps-cgal-dev", *PROGRAMS, "kerf-data", "python3-kerf"}
COMMANDS = ("info", "cut", "compare", "repair", "convert", "shape", "section", "dice", "fracture", "completion")
# What compilers leave in a program of the code of others: in the names of types, or of a library that is linked.
TRACES = {"CGAL": ("cgal", rb"libgmp\.so|Delaunay_triangulation_2"), "OpenMesh": ("OpenMesh", rb"N8OpenMesh|libOpenMeshCore"),
          "Bullet": ("bullet", rb"libLinearMath|libBullet"), "JSON": ("nlohmann", rb"8nlohmann"),
          "CLI11": ("CLI", rb"N3CLI"), "Dear ImGui": ("imgui", rb"Dear ImGui")}
# Written by others when packages come and go: caches of all menu entries, pictures, libraries and pages.
CACHES = re.compile(r"/usr/share/applications/mimeinfo\.cache|/usr/share/icons/.*icon-theme\.cache|/etc/ld\.so\.cache")


def build_debs():
    for old in BUILD.glob("*.deb"):
        old.unlink()
    run(ROOT / "run", "debs")
    debs = {run("dpkg-deb", "-f", path, "Package").strip(): path for path in sorted(BUILD.glob("*.deb"))}
    if set(debs) != PACKAGES:
        raise Failed(f"./run debs makes the packages {', '.join(sorted(debs))}, not {', '.join(sorted(PACKAGES))}")
    return debs


def programs_in(folder):
    for path in sorted(folder.rglob("*")):
        if path.is_file() and not path.is_symlink() and path.read_bytes()[:4] == b"\x7fELF":
            yield path


def bytes_of(path):
    return gzip.decompress(path.read_bytes()) if path.suffix == ".gz" else path.read_bytes()


def check_links(package, path, depends):
    """A program or library asks for no folder of ours, and the package depends on what it links."""
    dynamic = run("readelf", "-d", path)
    if re.search(r"R(UN)?PATH", dynamic):
        raise Failed(f"{package}: {path.name} looks for libraries in a folder of its own")
    for library in re.findall(r"NEEDED.*\[(.+)\]", dynamic):
        if library.startswith("libkerf"):
            owners = [CAPS if "caps_cgal" in library else LIBRARY]
        else:
            owners = [line.split(":")[0] for line in run("dpkg", "-S", f"*/{library}").splitlines()]
        if not any(owner in depends + [package] for owner in owners):
            raise Failed(f"{package}: {path.name} needs {library}, and the package depends on none of {owners}")


def check_notices(package, programs, text):
    """The copyright file names whose code is in the programs; it says GPL-3+ where CGAL's is, and nowhere else."""
    header = text.split("\n\n")[0]
    linked = set()
    for name, (folder, trace) in TRACES.items():
        found = any(re.search(trace, path.read_bytes()) for path in programs)
        noted = f"/{folder}/*".lower() in text.lower()
        if found != noted:
            raise Failed(f"{package}: {name} is {'' if found else 'not '}in it, its copyright file says otherwise")
        linked |= {name} if found else set()
    if ("\nLicense: GPL-3+" in header) != ("CGAL" in linked) or ("GPL" in text) != ("CGAL" in linked):
        raise Failed(f"{package}: its copyright file must say GPL-3+ if CGAL is linked, and only then")
    return linked


def check_page(path):
    """man finds nothing to complain of, and shows a name, a synopsis and options."""
    shown = subprocess.run(["man", "--warnings", "-E", "UTF-8", "-l", str(path)], capture_output=True, text=True,
                           env=dict(os.environ, LC_ALL="C.UTF-8", MANWIDTH="80", MANROFFSEQ=""))
    if shown.returncode != 0 or shown.stderr:
        raise Failed(f"man says of {path.name}: {shown.stderr}")
    missing = [title for title in ("NAME", "SYNOPSIS", "OPTIONS") if f"\n{title}\n" not in "\n" + shown.stdout]
    if missing:
        raise Failed(f"{path.name} has no section {', '.join(missing)}")


def check_viewer(folder):
    """What a desktop shows of it."""
    entry = folder / "usr/share/applications/kerf-viewer.desktop"
    run("desktop-file-validate", entry)
    values = dict(re.findall(r"^(\w+)=(.*)$", entry.read_text(), re.M))
    for path in (f"bin/{values['Exec']}", f"share/icons/hicolor/scalable/apps/{values['Icon']}.svg"):
        if not (folder / "usr" / path).exists():
            raise Failed(f"kerf-viewer: its menu entry names {path}, which is not there")


def check_contents(package, deb, folder):
    run("dpkg-deb", "-x", deb, folder)
    fields = dict(re.findall(r"^([\w-]+): (.*)$", run("dpkg-deb", "-f", deb), re.M))
    depends = re.findall(r"(?:^|[,|] *)([\w.+-]+)", fields.get("Depends", ""))
    for name, exactly in re.findall(r"((?:lib)?kerf[\w.-]*)( \(= [^)]*\))?", fields.get("Depends", "")):
        if exactly != f" (= {fields['Version']})":
            raise Failed(f"{package}: it depends on {name}, of any version")
    scripts = folder.parent / f"{package}.control"
    run("dpkg-deb", "-e", deb, scripts)
    wanted = {"control", "md5sums"} | ({"shlibs", "triggers"} if package in (LIBRARY, CAPS) else set())
    # What Python compiled beside its files goes before they go.
    wanted |= {"prerm"} if package == "python3-kerf" else set()
    if {path.name for path in scripts.iterdir()} != wanted:
        raise Failed(f"{package}: for dpkg it has {sorted(path.name for path in scripts.iterdir())}")
    documents = folder / "usr/share/doc" / package
    if sorted(path.name for path in documents.iterdir()) != ["changelog.Debian.gz", "changelog.gz", "copyright"]:
        raise Failed(f"{package}: its documents are {sorted(path.name for path in documents.iterdir())}")
    programs = list(programs_in(folder))
    for path in programs:
        check_links(package, path, depends)
    linked = check_notices(package, programs, (documents / "copyright").read_text())
    for path in folder.rglob("*"):
        if path.is_file() and str(ROOT).encode() in bytes_of(path):
            raise Failed(f"{package}: {path.name} has the path of the folder that it was built in")
    pages = sorted(path.name for path in folder.glob("usr/share/man/man1/*"))
    wanted = [f"{package}.1.gz"] if package in PROGRAMS else []
    if package == "kerf":
        wanted += [f"kerf-{command}.1.gz" for command in COMMANDS]
    if pages != sorted(wanted):
        raise Failed(f"{package}: its man pages are {pages}")
    for page in pages:
        check_page(folder / "usr/share/man/man1" / page)
    if package == "kerf-viewer":
        check_viewer(folder)
    count = sum(path.is_file() or path.is_symlink() for path in folder.rglob("*"))
    own = [name for name in depends if "kerf" in name]
    facts = [f"{deb.stat().st_size // 1000} kB, {count} files", "GPL-3+" if "CGAL" in linked else "MIT"]
    if linked:
        facts.append(f"has code of {', '.join(sorted(linked))}")
    if own:
        facts.append(f"needs {', '.join(own)}")
    say(f"  {deb.name}: {'; '.join(facts)}")


def check_debs(debs, folder):
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    for package, deb in debs.items():
        check_contents(package, deb, folder / package)
    libraries = folder / "libraries"
    libraries.mkdir()
    for package in (LIBRARY, CAPS):
        for path in (folder / package).glob("usr/lib/*/*.so.*"):
            shutil.copy(path, libraries / path.name, follow_symlinks=False)
    check_shared(libraries)


def files_of_the_system():
    return {os.path.join(place, name) for root in ("/usr", "/etc", "/opt") for place, folders, names in os.walk(root)
            for name in folders + names}


def is_owned(path):
    """Of a package that somebody installed meanwhile."""
    return subprocess.run(["dpkg", "-S", path], capture_output=True).returncode == 0


@contextlib.contextmanager
def installed(names):
    """Purges what was installed meanwhile, and looks whether a file is left."""
    status = subprocess.run(["dpkg-query", "-W", "-f", "${Package} ${db:Status-Status}\n", *sorted(names)],
                            capture_output=True, text=True).stdout
    present = [line.split()[0] for line in status.splitlines() if not line.endswith(" not-installed")]
    if present:
        raise Failed(f"{', '.join(present)}: installed here already, and the test would remove it")
    before = files_of_the_system()
    # Whoever ends the test waits until they are gone.
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(1))
    try:
        yield
    finally:
        run("dpkg", "--purge", *sorted(names))
    left = sorted(path for path in files_of_the_system() - before if not CACHES.fullmatch(path) and not is_owned(path))
    if left:
        raise Failed(f"purging the packages leaves {', '.join(left[:5])}")
    say(f"  purged: no file is left of {len(names)} packages")


def install(debs):
    """These and no others: whatever else they need is there, by the lists of packages that a build needs."""
    command = ["apt-get", "install", "--yes", "--no-install-recommends", *debs]
    others = set(re.findall(r"^Inst (\S+)", run(*command, "--simulate"), re.M)) - PACKAGES
    if others:
        raise Failed(f"the packages need {', '.join(sorted(others))}, too, which a build does not")
    run(*command, env=dict(os.environ, DEBIAN_FRONTEND="noninteractive"))


def check_program_without_caps(folder):
    """What is not installed is said to be missing, by name."""
    (folder / "CMakeLists.txt").write_text("cmake_minimum_required(VERSION 3.25)\nproject(caps LANGUAGES CXX)\n"
                                           "find_package(kerf CONFIG REQUIRED COMPONENTS linear caps_cgal)\n")
    done = subprocess.run(["cmake", "-S", folder, "-B", folder / "build"], capture_output=True, text=True)
    if done.returncode == 0 or "component caps_cgal of Kerf is not installed" not in " ".join(done.stderr.split()):
        raise Failed(f"without {CAPS} CMake does not say that caps_cgal is missing: {done.stderr}")


def check_program_with_caps(folder, model):
    shutil.rmtree(folder)
    consumer(folder, "find_package(kerf CONFIG REQUIRED COMPONENTS halfedge io caps_cgal)")
    check_consumer(folder, COMPILERS[0], model=model)
    needed = re.findall(r"NEEDED.*\[(lib.+)\]", run("readelf", "-d", folder / "build/slicer"))
    if not {f"libkerf_caps_cgal.so.{ABI}", f"libkerf_halfedge.so.{ABI}"} <= set(needed):
        raise Failed(f"a program that names caps_cgal and halfedge links {needed}")


def check_installed_programs(folder, data):
    model = data / "models/rook.obj"
    run("kerf", "info", model, cwd=folder)
    run("kerf", "cut", model, "--plane", "y=0", "--out", folder / "rook", cwd=folder)
    for side in ("positive", "negative"):
        if json.loads(run("kerf", "info", folder / f"rook.{side}.obj", "--json"))["open_edges"] != 0:
            raise Failed(f"kerf cut: the {side} side of the rook is open")
    say("  kerf info, kerf cut: two closed halves of an installed rook")
    halves = run("/usr/bin/python3", "-c", "import kerf, sys; rook = kerf.read(sys.argv[1]).prepare(); "
                 "print(*(half.mesh().is_closed for half in kerf.cut(rook, origin=(0, 0, 0), normal='y')))", model, cwd=folder)
    if halves.split() != ["True", "True"]:
        raise Failed(f"python3-kerf: the halves of the rook are closed: {halves}")
    say("  python3-kerf: the same")
    play = ["--frames", "30", "--size", "320x180", "--seed", "3", "--autopilot"]
    report = json.loads(run("kerf-viewer", "--headless", "--scene", "classic", *play, cwd=folder))
    if report["gl_errors"] != 0 or report["messages"]:
        raise Failed(f"kerf-viewer says {report['messages']}")
    run("xvfb-run", "-a", "kerf-viewer", "--scene", "report", *play, cwd=folder)
    say("  kerf-viewer: 30 frames of the game without a window, 30 of the report's models with one")


def check_installed(debs):
    elsewhere = Path(tempfile.mkdtemp(prefix="kerf-packages-"))
    os.environ.pop("CMAKE_PREFIX_PATH", None)
    data = Path("/usr/share/kerf")
    model = data / "models/rook.obj"
    try:
        with installed(PACKAGES):
            install([debs[name] for name in (LIBRARY, "libkerf-dev", "kerf-data")])
            say("  installed: the libraries, development files and models")
            for compiler in COMPILERS:
                folder = elsewhere / compiler
                consumer(folder, "find_package(kerf CONFIG REQUIRED)")
                check_consumer(folder, compiler, model=model)
                if "kerf_DIR:PATH=/usr/lib/" not in (folder / "build/CMakeCache.txt").read_text():
                    raise Failed("CMake finds another Kerf than the installed one")
                check_pkg_config(None, folder, compiler, model)
                say(f"  {compiler}: the README's program, {len(VARIANTS)} variants of it, and by pkg-config: "
                    "the same bytes")
            folder = elsewhere / "caps"
            folder.mkdir()
            check_program_without_caps(folder)
            install(debs.values())
            say("  installed: CGAL's caps and the programs, too")
            check_program_with_caps(folder, model)
            say("  the component caps_cgal: named as missing before, linked now")
            check_installed_programs(elsewhere, data)
    finally:
        shutil.rmtree(elsewhere, ignore_errors=True)


def check_packages(folder):
    """Whether the packages could be installed, which only root may do."""
    say("Debian packages")
    debs = build_debs()
    check_debs(debs, folder)
    if os.geteuid() != 0:
        say("  not installed: only root may do that")
        return False
    check_installed(debs)
    return True
