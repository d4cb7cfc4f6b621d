#!/usr/bin/env python3
"""Holds the public headers to their size, and to including nothing that programs need not have.

    headers_test.py COMPILER
"""

import re
import subprocess
import sys
import unittest
from pathlib import Path

INCLUDE = Path(__file__).resolve().parent.parent.parent / "include"
HEADERS = sorted((INCLUDE / "kerf").glob("*.h"))
COMPILER = sys.argv.pop() if len(sys.argv) > 1 else "c++"
MOST_LINES = 35000


def preprocessed(header):
    command = [COMPILER, "-std=c++20", f"-I{INCLUDE}", "-E", "-x", "c++", "-"]
    return subprocess.run(command, input=f"#include <kerf/{header}>\n", text=True, capture_output=True, check=True).stdout


class HeadersTest(unittest.TestCase):
    def test_the_main_header_is_small(self):
        self.assertLess(len(preprocessed("kerf.h").splitlines()), MOST_LINES)

    def test_no_header_reads_more_than_it_should(self):
        """Neither the heavy headers of the standard library nor any of another project."""
        for header in HEADERS:
            files = set(re.findall(r'^# \d+ "([^"<]+)"', preprocessed(header.name), re.M))
            heavy = [name for name in files if Path(name).name in {"memory", "string", "functional", "filesystem", "vector"}]
            self.assertEqual([], heavy, header.name)
            others = [name for name in files if re.search(r"/(glm|OpenMesh|CGAL|bullet|nlohmann|boost)/", name)]
            self.assertEqual([], others, header.name)

    def test_each_header_stands_alone(self):
        for header in HEADERS:
            command = [COMPILER, "-std=c++20", f"-I{INCLUDE}", "-fsyntax-only", "-Wall", "-Wextra", "-Wpedantic", "-Werror",
                       "-ffast-math", "-fno-rtti", "-fno-exceptions", "-x", "c++", "-"]
            done = subprocess.run(command, input=f"#include <kerf/{header.name}>\nint main() {{}}\n", text=True, capture_output=True)
            self.assertEqual(0, done.returncode, header.name + done.stderr)

    def test_headers_include_each_other_only_by_their_public_names(self):
        for header in HEADERS:
            for name in re.findall(r'^\s*#\s*include (\S+)', header.read_text(), re.M):
                self.assertTrue(name.startswith("<"), f"{header.name} includes {name}")


if __name__ == "__main__":
    unittest.main()
