#!/usr/bin/python3
"""Builds and runs the README's program, and the examples, as users of an installed Kerf would.

Ways to Kerf: a staged install of static and of shared libraries, `add_subdirectory`, `FetchContent` from this folder,
and Debian packages, which are installed and purged again. For each way and compiler the program is compiled plainly,
with -ffast-math, with -fno-rtti and -fno-exceptions, with GLM's aligned types, and beside a `common/plane.h` of its
own; always with -Wall -Wextra -Wpedantic -Werror. Shared libraries must show no names but Kerf's and need what
docs/library.md says.

--built FOLDER  installs what was built there, with one compiler, instead of building it (static libraries only)
--debs          looks at the Debian packages only
Exit status: 0 all is well, 1 something is not, 3 all is well but the packages were not installed: only root may.
"""

import argparse
import os
import shutil
import sys
from pathlib import Path

from debs import check_packages
from shared_libraries import check_shared
from users import (COMPILERS, ROOT, VARIANTS, Failed, check_built_parts, check_consumer, check_examples,
                   check_pkg_config, consumer, run, say)

FOLDER = ROOT / "build/package"
LIBRARY_ONLY = [f"-DKERF_BUILD_{part}=OFF" for part in ("TOOLS", "VIEWER", "DATA", "BENCH", "TESTS")]


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


def libraries(built):
    """Those of one build, or all ways but packages."""
    for old in list(FOLDER.glob("use-*")) + list(FOLDER.glob("examples-*")):
        shutil.rmtree(old)
    prefix = FOLDER / "static"
    install(built or build_library("static"), prefix)
    installed("static", prefix, COMPILERS, examples=True)
    if built:
        return
    prefix = FOLDER / "shared"
    install(build_library("shared", "-DBUILD_SHARED_LIBS=ON"), prefix)
    installed("shared", prefix, COMPILERS, examples=True)
    check_shared(prefix / "lib")
    for name, way in (("add_subdirectory", f'add_subdirectory("{ROOT}" kerf)'),
                      ("FetchContent", f'include(FetchContent)\nFetchContent_Declare(kerf SOURCE_DIR "{ROOT}")\n'
                                       "FetchContent_MakeAvailable(kerf)")):
        say(name)
        for compiler in COMPILERS:
            folder = FOLDER / f"use-{name}-{compiler}"
            consumer(folder, way)
            # A project's own flags go before Kerf's, and before those of single programs.
            check_consumer(folder, compiler, "-DCMAKE_CXX_FLAGS=-fno-rtti -fno-exceptions -ffast-math")
            check_built_parts(folder)
            say(f"  {compiler}: the README's program, and {len(VARIANTS)} variants of it, write the same bytes")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--built", type=Path)
    parser.add_argument("--debs", action="store_true")
    arguments = parser.parse_args()
    os.environ.setdefault("CMAKE_CXX_COMPILER_LAUNCHER", "ccache" if shutil.which("ccache") else "")
    # By the same name in all ways: what ccache has kept goes by it.
    os.environ["CXX"] = COMPILERS[0]
    FOLDER.mkdir(parents=True, exist_ok=True)
    try:
        if not arguments.debs:
            libraries(arguments.built.resolve() if arguments.built else None)
        if not arguments.built and not check_packages(FOLDER / "debs"):
            return 3
    except Failed as failure:
        print(failure, file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
