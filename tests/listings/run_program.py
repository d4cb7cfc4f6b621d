#!/usr/bin/env python3
"""Runs the program of a listing in an empty folder that has the project's `data`, and compares what it prints.

    run_program.py PROGRAM FILE    FILE: what the page says; there need be none
"""

import subprocess
import sys
import tempfile
from pathlib import Path

from listings import ROOT


def main():
    program, expected = Path(sys.argv[1]), Path(sys.argv[2])
    with tempfile.TemporaryDirectory() as folder:
        (Path(folder) / "data").symlink_to(ROOT / "data")
        done = subprocess.run([program], cwd=folder, capture_output=True, text=True)
    print(done.stdout + done.stderr, end="")
    if done.returncode != 0:
        print(f"exit status {done.returncode}", file=sys.stderr)
        return 1
    if expected.exists() and done.stdout != expected.read_text(encoding="utf-8"):
        print("its page says:\n" + expected.read_text(encoding="utf-8"), file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
