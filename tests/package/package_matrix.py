#!/usr/bin/python3
"""Builds and runs the README's program, and the examples, as users of an installed Kerf would.

Ways to Kerf: a staged install of static and of shared libraries, `add_subdirectory`, `FetchContent` from this folder. For
each way and compiler the program is compiled plainly, with -ffast-math, with -fno-rtti and -fno-exceptions, with GLM's
aligned types, and beside a `common/plane.h` of its own; always with -Wall -Wextra -Wpedantic -Werror. Shared libraries
must show no names but Kerf's and need what docs/library.md says.

--built FOLDER  installs what was built there, with one compiler, instead of building it (static libraries only)
Exit status: 0 all is well, 1 something is not.
"""

import argparse
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
FOLDER = ROOT / "build/package"
COMPILERS = ("g++", "clang++-14")
EXAMPLES = ("ten_lines", "arrays", "thousand_cuts", "game_loop", "bullet_bodies", "draw_ranges", "plugin")
LIBRARY_ONLY = [f"-DKERF_BUILD_{part}=OFF" for part in ("TOOLS", "VIEWER", "DATA", "BENCH", "TESTS")]
WARNINGS = ["-Wall", "-Wextra", "-Wpedantic", "-Werror"]
VARIANTS = {
    "plain": [],
    "fast_math": ["-ffast-math"],
    "no_rtti": ["-fno-rtti", "-fno-exceptions"],
    "aligned_glm": ["-DGLM_FORCE_DEFAULT_ALIGNED_GENTYPES", "-DGLM_FORCE_INTRINSICS", "-msse4.2",
                    "SHELL:-include glm/glm.hpp"],
    "own_header": ["-I${CMAKE_CURRENT_SOURCE_DIR}", "SHELL:-include common/plane.h"],
}
# What each library may need at run time, besides other parts of Kerf.
PLAIN = {"libstdc++.so.6", "libm.so.6", "libgcc_s.so.1", "libc.so.6", "ld-linux-x86-64.so.2"}
NEEDS = {"kerf": set(), "kerf_io": set(), "kerf_shapes": set(), "kerf_halfedge": {"libOpenMeshCore.so"},
         "kerf_proxy": {"libLinearMath.so"}, "kerf_caps_cgal": {"libgmp.so", "libmpfr.so"}}


class Failed(Exception):
    """One sentence."""


def run(*command, cwd=None, env=None):
    done = subprocess.run([str(part) for part in command], cwd=cwd, env=env, capture_output=True, text=True)
    if done.returncode != 0:
        raise Failed(f"{' '.join(str(part) for part in command)}\n{done.stdout[-4000:]}{done.stderr[-4000:]}")
    return done.stdout


def say(text):
    print(text, flush=True)


def listing(language):
    text = (ROOT / "README.md").read_text()
    found = re.search(rf"^```{language}\n(.*?)^```", text, re.M | re.S)
    if not found:
        raise Failed(f"README.md has no listing of {language}")
    return found.group(1)


def consumer(folder, way):
    """A project of a user: the README's listings, and the same program under all variants."""
    shutil.rmtree(folder, ignore_errors=True)
    (folder / "common").mkdir(parents=True)
    (folder / "common/plane.h").write_text("#pragma once\nstruct Plane { int wings = 2; };  // of an airport\n")
    (folder / "slicer.cpp").write_text(listing("cpp"))
    text, count = re.subn(r"^find_package\(kerf [^)]*\).*$", lambda _: way, listing("cmake"), flags=re.M)
    if count != 1:
        raise Failed("README.md's listing of CMake has no line find_package(kerf ...)")
    for name, options in VARIANTS.items():
        quoted = " ".join(f'"{option}"' for option in WARNINGS + options)
        text += (f"add_executable(slicer_{name} slicer.cpp)\ntarget_link_libraries(slicer_{name} PRIVATE kerf::kerf)\n"
                 f"target_compile_options(slicer_{name} PRIVATE {quoted})\n")
    (folder / "CMakeLists.txt").write_text(text)


def check_consumer(folder, compiler, *settings):
    build = folder / "build"
    run("cmake", "-S", folder, "-B", build, "-G", "Ninja", f"-DCMAKE_CXX_COMPILER={compiler}", *settings)
    run("ninja", "-C", build)
    reference = None
    for name in ["slicer"] + [f"slicer_{variant}" for variant in VARIANTS]:
        place = build / f"run-{name}"
        place.mkdir()
        run(build / name, ROOT / "data/models/rook.obj", cwd=place)
        written = (place / "positive.obj").read_bytes()
        reference = reference or written
        if written != reference:
            raise Failed(f"{folder.name}: {name} writes other bytes than slicer")


def check_pkg_config(prefix, folder, compiler):
    """The README's program by a line on a shell."""
    environment = dict(os.environ, PKG_CONFIG_PATH=str(prefix / "lib/pkgconfig"))
    flags = run("pkg-config", "--cflags", "--libs", "kerf", env=environment).split()
    program = folder / "by-pkg-config"
    run(compiler, "-std=c++20", "-O2", folder / "slicer.cpp", *flags, f"-Wl,-rpath,{prefix / 'lib'}", "-o", program)
    run(program, ROOT / "data/models/rook.obj", cwd=folder)
    if (folder / "positive.obj").read_bytes() != (folder / "build/run-slicer/positive.obj").read_bytes():
        raise Failed(f"{folder.name}: built by pkg-config it writes other bytes")


def check_examples(prefix, folder, compiler):
    for name in EXAMPLES:
        build = folder / f"{name}-{compiler}"
        run("cmake", "-S", ROOT / "examples" / name, "-B", build, "-G", "Ninja", f"-DCMAKE_CXX_COMPILER={compiler}",
            "-DCMAKE_BUILD_TYPE=Release", f"-DCMAKE_PREFIX_PATH={prefix}",
            "-DCMAKE_CXX_FLAGS=" + " ".join(WARNINGS))
        run("ninja", "-C", build)
        command = [build / name] + ([ROOT / "data/models/rook.obj"] if name == "ten_lines" else [])
        if name == "draw_ranges":
            command = ["xvfb-run", "-a"] + command
        say(f"    {name}: " + run(*command, cwd=build).strip().splitlines()[-1])


def install(build, prefix):
    shutil.rmtree(prefix, ignore_errors=True)
    run("cmake", "--install", build, "--prefix", prefix)
    headers = sorted(path.name for path in (prefix / "include/kerf").iterdir())
    own = sorted(path.name for path in (ROOT / "include/kerf").iterdir())
    if headers != own or any((prefix / "include").glob("[!k]*")):
        raise Failed(f"other headers than those of include/kerf are installed: {headers}")


def build_library(kind, *settings):
    build = FOLDER / f"build-{kind}"
    run("cmake", "-S", ROOT, "-B", build, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release", *LIBRARY_ONLY, *settings)
    run("ninja", "-C", build)
    return build


def check_shared(prefix):
    """Names and needs of shared libraries."""
    allowed = re.compile(r"(kerf::|kerf_component_|(typeinfo|typeinfo name|vtable|guard variable|non-virtual thunk) (for|to) kerf::)")
    for name, needs in NEEDS.items():
        library = next((prefix / "lib").glob(f"lib{name}.so"))
        symbols = run("nm", "-DC", "--defined-only", library).splitlines()
        foreign = [line for line in symbols if not allowed.match(line.split(maxsplit=2)[2])]
        if foreign or not symbols:
            raise Failed(f"{library.name} shows names that are not Kerf's: {foreign[:3]}")
        needed = set(re.findall(r"NEEDED.*\[(.+)\]", run("readelf", "-d", library)))
        rest = {one for one in needed - PLAIN if not one.startswith("libkerf")}
        if {re.sub(r"\.so\..*", ".so", one) for one in rest} - needs:
            raise Failed(f"{library.name} needs {sorted(rest)}")
        say(f"    {library.name}: {len(symbols)} names, all Kerf's; needs {', '.join(sorted(needed))}")


def installed(kind, prefix, compilers, examples):
    say(f"{kind} libraries, installed")
    for compiler in compilers:
        folder = FOLDER / f"use-{kind}-{compiler}"
        consumer(folder, "find_package(kerf CONFIG REQUIRED)")
        check_consumer(folder, compiler, f"-DCMAKE_PREFIX_PATH={prefix}")
        check_pkg_config(prefix, folder, compiler)
        say(f"  {compiler}: the README's program, {len(VARIANTS)} variants of it, and by pkg-config: the same bytes")
        if examples:
            check_examples(prefix, FOLDER / f"examples-{kind}", compiler)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--built", type=Path)
    arguments = parser.parse_args()
    os.environ.setdefault("CMAKE_CXX_COMPILER_LAUNCHER", "ccache" if shutil.which("ccache") else "")
    FOLDER.mkdir(parents=True, exist_ok=True)
    for old in list(FOLDER.glob("use-*")) + list(FOLDER.glob("examples-*")):
        shutil.rmtree(old)
    try:
        prefix = FOLDER / "static"
        install(arguments.built.resolve() if arguments.built else build_library("static"), prefix)
        installed("static", prefix, COMPILERS, examples=True)
        if arguments.built:
            return 0
        prefix = FOLDER / "shared"
        install(build_library("shared", "-DBUILD_SHARED_LIBS=ON"), prefix)
        installed("shared", prefix, COMPILERS, examples=True)
        check_shared(prefix)
        for name, way in (("add_subdirectory", f'add_subdirectory("{ROOT}" kerf)'),
                          ("FetchContent", f'include(FetchContent)\nFetchContent_Declare(kerf SOURCE_DIR "{ROOT}")\n'
                                           "FetchContent_MakeAvailable(kerf)")):
            say(name)
            for compiler in COMPILERS:
                folder = FOLDER / f"use-{name}-{compiler}"
                consumer(folder, way)
                check_consumer(folder, compiler)
                say(f"  {compiler}: the README's program, and {len(VARIANTS)} variants of it, write the same bytes")
    except Failed as failure:
        print(failure, file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
