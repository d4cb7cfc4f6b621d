"""Users of Kerf: the README's program under all variants, and the examples, built as projects of their own."""

import os
import re
import shutil
import subprocess
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
COMPILERS = ("g++", "clang++-14")
MODEL = ROOT / "data/models/rook.obj"
EXAMPLES = ("ten_lines", "arrays", "thousand_cuts", "game_loop", "bullet_bodies", "draw_ranges", "plugin", "c")
WARNINGS = ["-Wall", "-Wextra", "-Wpedantic", "-Werror"]
VARIANTS = {
    "plain": [],
    "fast_math": ["-ffast-math"],
    "no_rtti": ["-fno-rtti", "-fno-exceptions"],
    "aligned_glm": ["-DGLM_FORCE_DEFAULT_ALIGNED_GENTYPES", "-DGLM_FORCE_INTRINSICS", "-msse4.2",
                    "SHELL:-include glm/glm.hpp"],
    "own_header": ["-I${CMAKE_CURRENT_SOURCE_DIR}", "SHELL:-include common/plane.h"],
}


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


def check_consumer(folder, compiler, *settings, model=MODEL):
    build = folder / "build"
    run("cmake", "-S", folder, "-B", build, "-G", "Ninja", f"-DCMAKE_CXX_COMPILER={compiler}", *settings)
    if "CMAKE_BUILD_TYPE:STRING=Release\n" not in (build / "CMakeCache.txt").read_text():
        raise Failed(f"{folder.name}: the README's listing does not build it as Release")
    run("ninja", "-C", build)
    reference = None
    for name in ["slicer"] + [f"slicer_{variant}" for variant in VARIANTS]:
        place = build / f"run-{name}"
        place.mkdir()
        run(build / name, model, cwd=place)
        written = (place / "positive.obj").read_bytes()
        reference = reference or written
        if written != reference:
            raise Failed(f"{folder.name}: {name} writes other bytes than slicer")


def check_built_parts(folder):
    """A project that has Kerf in a folder builds the library, none of what only Kerf's own programs need, and no CGAL."""
    places = (folder / "build/kerf", folder / "build/_deps/kerf-build")
    built = {"CGAL" if "caps_cgal" in str(path) else "/".join(path.relative_to(place).parts[:2]) for place in places for path in place.rglob("*.o")
             if "kerf_precompiled" not in str(path)}
    wanted = {f"src/{room}" for room in ("api", "back_ends", "common", "halfedge", "linear")}
    if built != wanted:
        raise Failed(f"{folder.name}: it builds {', '.join(sorted(built))}, not {', '.join(sorted(wanted))}")


def check_pkg_config(prefix, folder, compiler, model=MODEL):
    """The README's program by a line on a shell; without a prefix, where pkg-config and the loader look anyway."""
    environment = dict(os.environ, PKG_CONFIG_PATH=str(prefix / "lib/pkgconfig")) if prefix else None
    flags = run("pkg-config", "--cflags", "--libs", "kerf", env=environment).split()
    if prefix:
        flags.append(f"-Wl,-rpath,{prefix / 'lib'}")
    program = folder / "by-pkg-config"
    run(compiler, "-std=c++20", "-O2", folder / "slicer.cpp", *flags, "-o", program)
    run(program, model, cwd=folder)
    if (folder / "positive.obj").read_bytes() != (folder / "build/run-slicer/positive.obj").read_bytes():
        raise Failed(f"{folder.name}: built by pkg-config it writes other bytes")


def check_examples(prefix, folder, compiler):
    for name in EXAMPLES:
        build = folder / f"{name}-{compiler}"
        run("cmake", "-S", ROOT / "examples" / name, "-B", build, "-G", "Ninja", f"-DCMAKE_CXX_COMPILER={compiler}",
            "-DCMAKE_BUILD_TYPE=Release", f"-DCMAKE_PREFIX_PATH={prefix}",
            "-DCMAKE_CXX_FLAGS=" + " ".join(WARNINGS), "-DCMAKE_C_FLAGS=" + " ".join(WARNINGS))
        run("ninja", "-C", build)
        command = [build / name] + ([ROOT / "data/models/rook.obj"] if name in ("ten_lines", "c") else [])
        if name == "draw_ranges":
            command = ["xvfb-run", "-a"] + command
        say(f"    {name}: " + run(*command, cwd=build).strip().splitlines()[-1])
        if name == "plugin":
            check_plugin(build / "libcutter.so")


def check_plugin(library):
    """It shows its own function and nothing of the Kerf inside it, but the compiler's and C++ library's own names."""
    shown = [line.split(maxsplit=2) for line in run("nm", "-DC", "--defined-only", library).splitlines()]
    kerf = [name for _, _, name in shown if "kerf" in name]
    unique = [name for _, kind, name in shown if kind == "u"]
    if kerf or unique or "cut_in_two" not in [name for _, _, name in shown]:
        raise Failed(f"{library.name} shows {len(kerf)} names of Kerf, and {len(unique)} that keep it loaded: "
                     f"{(kerf + unique)[:3]}")
