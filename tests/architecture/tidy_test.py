#!/usr/bin/env python3
"""Which files clang-tidy reads when some differ (.ci/tidy)."""

import importlib.machinery
import importlib.util
import unittest
from pathlib import Path

PROGRAM = Path(__file__).resolve().parents[2] / ".ci/tidy"


def load_program():
    """The program, whose name has no ending, as a module."""
    loader = importlib.machinery.SourceFileLoader("tidy", str(PROGRAM))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader("tidy", loader))
    loader.exec_module(module)
    return module


class Concerned(unittest.TestCase):
    tidy = load_program()
    units = {
        "mesh": ["src/common/mesh/plane.cpp", "src/common/mesh/mass_properties.cpp"],
        "support": ["src/common/support/reason.cpp"],
        "shapes": ["src/common/shapes/asteroid.cpp"],
        "plane test": ["tests/common/mesh/plane_test.cpp"],
    }

    def concerned(self, *differing):
        return self.tidy.concerned(self.units, list(differing))

    def test_a_source_brings_its_target(self):
        self.assertEqual(["mesh"], self.concerned("src/common/mesh/plane.cpp"))

    def test_a_header_brings_the_targets_of_its_folder_that_read_it(self):
        self.assertEqual(["mesh"], self.concerned("src/common/mesh/plane.h"))

    def test_a_header_that_nobody_in_its_folder_reads_brings_another_that_does(self):
        header = "src/common/support/random.h"
        found = self.concerned(header)
        self.assertEqual(1, len(found))
        self.assertIn(header, self.tidy.read_with(self.units[found[0]], {}))

    def test_what_nobody_reads_or_what_decides_brings_all(self):
        self.assertEqual(list(self.units), self.concerned("tests/support/brief.h"))
        self.assertEqual(list(self.units), self.concerned(".clang-tidy"))
        self.assertEqual(list(self.units), self.concerned("cmake/KerfTarget.cmake"))

    def test_nothing_brings_nothing(self):
        self.assertEqual([], self.concerned())


class WhatIsRead(unittest.TestCase):
    tidy = load_program()

    def same(self, name, before, after):
        return self.tidy.what_is_read(name, before) == self.tidy.what_is_read(name, after)

    def test_code_without_lines_that_are_comments(self):
        self.assertTrue(self.same("a.h", "/// Says it.\nint a;\n", "    // Says it\n    // better.\nint a;\n"))
        self.assertFalse(self.same("a.h", "// Says it.\nint a;\n", "// Says it.\nint b;\n"))
        self.assertFalse(self.same("a.h", "int a;  // one\n", "int a;  // two\n"))
        self.assertFalse(self.same("a.cpp", "// NOLINTNEXTLINE(some-check)\nint a;\n", "int a;\n"))

    def test_one_preset_of_all(self):
        presets = (self.tidy.ROOT / "CMakePresets.json").read_text()
        self.assertTrue(self.same("CMakePresets.json", presets, presets.replace('"name": "asan"', '"name": "other"')))
        self.assertFalse(self.same("CMakePresets.json", presets, presets.replace('"name": "tidy"', '"name": "other"')))
        own = self.tidy.what_is_read("CMakePresets.json", presets)
        self.assertEqual(1, len(own))
        self.assertNotIn("inherits", own[0])  # what it inherits would not be compared


if __name__ == "__main__":
    unittest.main()
