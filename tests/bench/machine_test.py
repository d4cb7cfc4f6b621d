"""What the numbers were measured on."""

import os
import tempfile
import unittest
from pathlib import Path

from report import machine


class Machine(unittest.TestCase):
    def test_a_program_that_fails_or_is_not_there_says_nothing(self):
        self.assertEqual(machine.output_of(["/bin/false"]), "")
        self.assertEqual(machine.output_of(["/no/such/program"]), "")
        self.assertEqual(machine.output_of(["/bin/echo", "something"]), "something")

    def test_entries_of_a_cmake_cache_are_found_whatever_their_type(self):
        cache = "CMAKE_BUILD_TYPE:STRING=Release\nCMAKE_CXX_COMPILER:FILEPATH=/usr/bin/c++\n"
        self.assertEqual(machine.cache_entry(cache, "CMAKE_BUILD_TYPE"), "Release")
        self.assertEqual(machine.cache_entry(cache, "CMAKE_CXX"), "")

    def test_flags_are_those_that_the_cutting_path_is_compiled_with(self):
        rules = ("build a/other.cpp.o: CXX a/other.cpp\n  FLAGS = -O0\n\n"
                 "build src/halfedge/CMakeFiles/k.dir/cut/cutter.cpp.o: CXX cutter.cpp || x\n"
                 "  DEFINES = -DX\n  FLAGS = -O3 -DNDEBUG -ffp-contract=off -fpch-preprocess -Wall -std=c++20 -include pch.h\n"
                 "  INCLUDES = -Isrc\n")
        self.assertEqual(machine.cutting_flags(rules), "-O3 -ffp-contract=off -std=c++20")
        self.assertEqual(machine.cutting_flags(""), "not known")

    def test_seeds_are_read_from_the_sources_and_a_build_that_is_not_there_is_no_error(self):
        before = Path.cwd()
        with tempfile.TemporaryDirectory() as folder:
            os.chdir(folder)
            self.addCleanup(os.chdir, before)
            Path("bench").mkdir()
            Path("bench/x.cpp").write_text("constexpr std::uint64_t kPlaneSeed = 7;\n")
            said = machine.describe(Path("build"))
            os.chdir(before)
        self.assertEqual(said["x.cpp, kPlaneSeed"], "7")
        self.assertEqual(said["compiler"], "not known")
        self.assertEqual(said["commit"], "not under version control")
        self.assertTrue(said["processor"])


if __name__ == "__main__":
    unittest.main()
