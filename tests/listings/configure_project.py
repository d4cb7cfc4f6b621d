#!/usr/bin/env python3
"""Configures the project of a listing beside a folder `kerf`, which is this project.

    configure_project.py CMAKE GENERATOR COMPILER FOLDER

A line with find_package(kerf ...) is taken for add_subdirectory(kerf): nothing is installed here. Sources that the
listing names are empty programs.
"""

import re
import subprocess
import sys
import tempfile
from pathlib import Path

from listings import ROOT


def main():
    cmake, generator, compiler, listing = sys.argv[1:]
    text = (Path(listing) / "CMakeLists.txt").read_text(encoding="utf-8")
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        (folder / "kerf").symlink_to(ROOT)
        for source in re.findall(r"\b\w+\.cpp\b", text):
            (folder / source).write_text("int main() {}\n")
        text = re.sub(r"^find_package\(kerf [^\n]*", "add_subdirectory(kerf)", text, flags=re.M)
        (folder / "CMakeLists.txt").write_text(text)
        command = [cmake, "-S", folder, "-B", folder / "build", "-G", generator, f"-DCMAKE_CXX_COMPILER={compiler}"]
        return subprocess.run(command).returncode


if __name__ == "__main__":
    sys.exit(main())
