"""Stages are run once, and what they gave is kept."""

import contextlib
import io
import json
import os
import tempfile
import unittest
from pathlib import Path

from report.names import Kind
from report.plan import Stage
from report.progress import Progress
from report.stages import Programs, StageFailed, Stages


class Resuming(unittest.TestCase):
    """Stages are run by a program that counts how often it is called."""

    def setUp(self):
        self.before = Path.cwd()
        self.folder = tempfile.TemporaryDirectory()
        os.chdir(self.folder.name)
        self.program = Path("program")
        self.write_program('echo call >> calls; echo "{\\"rows\\": 1}"')
        self.stage = Stage("compare-x", Kind.COMPARE, ("--planes", "1"), 1.0)

    def tearDown(self):
        os.chdir(self.before)
        self.folder.cleanup()

    def write_program(self, text):
        self.program.write_text("#!/bin/sh\n" + text + "\n")
        self.program.chmod(0o755)

    def stages(self):
        program = self.program.absolute()
        return Stages(Path("stages"), Programs(*[program] * 7))

    def run_stage(self, stage):
        stages = self.stages()
        if not stages.finished(stage):
            stages.run(stage, Progress({stage.name: 1.0}, stream=io.StringIO()))

    def calls(self):
        return len(Path("calls").read_text().splitlines())

    def test_a_finished_stage_is_not_run_again(self):
        self.run_stage(self.stage)
        self.run_stage(self.stage)
        self.assertEqual(self.calls(), 1)
        self.assertEqual(json.loads(self.stages().file(self.stage).read_text())["result"], {"rows": 1})

    def test_other_arguments_and_another_program_make_it_run_again(self):
        self.run_stage(self.stage)
        self.run_stage(Stage("compare-x", Kind.COMPARE, ("--planes", "2"), 1.0))
        self.assertEqual(self.calls(), 2)
        self.write_program('echo call >> calls; echo "{\\"rows\\": 2}"')
        self.run_stage(self.stage)
        self.assertEqual(self.calls(), 3)

    def test_half_a_file_counts_as_nothing(self):
        self.run_stage(self.stage)
        file = self.stages().file(self.stage)
        file.write_text(file.read_text()[:40])
        self.run_stage(self.stage)
        self.assertEqual(self.calls(), 2)

    def test_a_program_that_fails_leaves_nothing_behind(self):
        self.write_program("echo it is broken >&2; exit 3")
        with self.assertRaisesRegex(StageFailed, "exit status 3.*\nit is broken"):
            self.run_stage(self.stage)
        self.assertFalse(self.stages().finished(self.stage))
        self.assertEqual(list(Path("stages").glob("*")) if Path("stages").exists() else [], [])

    def test_a_comparison_that_finds_differences_is_a_result(self):
        self.write_program('echo "{\\"rows\\": 1}"; exit 1')
        self.run_stage(self.stage)
        self.assertTrue(self.stages().finished(self.stage))

    def test_all_stages_are_run_that_are_not_there(self):
        other = Stage("compare-y", Kind.COMPARE, ("--planes", "1"), 1.0)
        self.run_stage(self.stage)
        with contextlib.redirect_stderr(io.StringIO()) as said:
            self.stages().run_all([self.stage, other])
        self.assertEqual(self.calls(), 2)
        self.assertIn("1 of 2 stages are there already", said.getvalue())

    def test_forgotten_stages_are_run_again(self):
        self.run_stage(self.stage)
        self.stages().forget()
        self.run_stage(self.stage)
        self.assertEqual(self.calls(), 2)

    def test_a_model_is_made_before_the_stage_that_needs_it(self):
        self.write_program('echo "$@" >> calls; echo "{}"')
        self.run_stage(Stage("compare-x", Kind.COMPARE, ("--planes", "1"), 1.0,
                             shape=("asteroid", "--out", "made/asteroid.ply")))
        self.assertEqual(Path("calls").read_text().splitlines(),
                         ["shape asteroid --out made/asteroid.ply", "compare --planes 1"])
        self.assertTrue(Path("made").is_dir())

    def test_the_first_program_that_is_missing_is_named(self):
        self.assertIsNone(self.stages().programs.missing())
        gone = Path("gone")
        program = self.program.absolute()
        self.assertEqual(Programs(program, program, gone, program, program, program, program).missing(), gone)


if __name__ == "__main__":
    unittest.main()
