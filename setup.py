"""Builds the module kerf._core by CMake; pyproject.toml has the rest."""

import os
import re
import subprocess
import sys
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = Path(__file__).resolve().parent


def version() -> str:
    """The version stands in one place, which programs include."""
    return re.search(r'^#define KERF_VERSION "([^"]+)"', (ROOT / "include/kerf/version.h").read_text(), re.MULTILINE)[1]


class CMakeBuild(build_ext):
    """The library and the module, and nothing else of the project."""

    def build_extension(self, ext: Extension) -> None:
        target = Path(self.get_ext_fullpath(ext.name)).resolve()
        build = Path(self.build_temp).resolve()
        options = {
            "CMAKE_BUILD_TYPE": "Release",
            "CMAKE_LIBRARY_OUTPUT_DIRECTORY": target.parent,
            "Python_EXECUTABLE": sys.executable,
            "KERF_BUILD_PYTHON": "ON",
            "KERF_PRECOMPILE": "ON",
            # What it links beyond OpenMesh would decide its licence: KERF_CMAKE_OPTIONS=-DKERF_BUILD_CGAL=ON is a choice.
            "KERF_BUILD_CGAL": "OFF",
        }
        for part in ("PROXY", "TOOLS", "VIEWER", "DATA", "BENCH", "TESTS"):
            options[f"KERF_BUILD_{part}"] = "OFF"
        options["KERF_INSTALL"] = "OFF"
        arguments = [f"-D{name}={value}" for name, value in options.items()]
        try:
            import pybind11

            arguments.append(f"-Dpybind11_DIR={pybind11.get_cmake_dir()}")
        except ImportError:
            pass  # Debian's pybind11-dev lies where CMake looks.
        # Words of the user's come last, and count.
        arguments += os.environ.get("KERF_CMAKE_OPTIONS", "").split()
        subprocess.run(["cmake", "-S", ROOT, "-B", build, "-G", "Ninja", *arguments], check=True)
        subprocess.run(["cmake", "--build", build, "--target", "kerf_python"], check=True)


setup(version=version(), ext_modules=[Extension("kerf._core", [])], cmdclass={"build_ext": CMakeBuild})
