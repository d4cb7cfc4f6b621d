"""Which stages a report has."""

import re
import unittest
from pathlib import Path

from report.judged_caps import WorstFan
from report.names import Kind, UNDRAWN
from report.plan import FULL, NORMAL, QUICK, VIEWER_OPPONENTS, VIEWER_RUNS, gallery_stages, plan, text_plan


class Plans(unittest.TestCase):
    def test_stages_have_names_of_their_own_and_sizes_within_the_extent(self):
        for extent in (QUICK, NORMAL, FULL):
            stages = plan(extent, Path("scratch"), with_vtk=True, with_open3d=True)
            names = [stage.name for stage in stages]
            self.assertEqual(len(names), len(set(names)))
            sizes = [int(name.split("-")[1]) for name in names if name.startswith("growth-")]
            self.assertEqual(max(sizes), extent.most_triangles)

    def test_quadratic_lookups_are_left_out_above_their_limit(self):
        patterns = {stage.name: re.compile(stage.arguments[0]) for stage in plan(NORMAL, Path("scratch"))
                    if stage.kind == Kind.BENCH}
        self.assertTrue(patterns["growth-30000"].search("Scale/baseline/scan/asteroid/30000/manual_time"))
        self.assertFalse(patterns["growth-100000"].search("Scale/baseline/scan/asteroid/100000/manual_time"))
        self.assertTrue(patterns["growth-100000"].search("Scale/baseline/hash/shuffled/100000/manual_time"))
        self.assertFalse(patterns["growth-10000"].search("Scale/halfedge/asteroid/100000/manual_time"))

    def test_every_other_back_end_is_measured_at_every_size(self):
        for stage in plan(FULL, Path("scratch")):
            kind, _, size = stage.name.partition("-")
            if kind == "growth":
                for name in ("baseline/hash", "baseline/remap", "linear", "halfedge"):
                    self.assertRegex(f"Scale/{name}/asteroid/{size}/manual_time", stage.arguments[0])

    def test_vtk_has_a_stage_only_if_it_is_there(self):
        for with_vtk in (False, True):
            self.assertEqual(any(stage.kind == Kind.VTK for stage in plan(QUICK, Path("scratch"), with_vtk)), with_vtk)

    def test_open3d_has_a_stage_only_if_it_is_there(self):
        for with_open3d in (False, True):
            stages = plan(QUICK, Path("scratch"), with_open3d=with_open3d)
            self.assertEqual(any(stage.kind == Kind.OPEN3D_SECTIONS for stage in stages), with_open3d)

    def test_each_back_end_of_the_viewer_has_a_run_that_warms_up(self):
        for stage in plan(NORMAL, Path("scratch")):
            if stage.kind == Kind.VIEWER and not stage.name.startswith(UNDRAWN):
                names = stage.arguments[-1].split(",")
                each, more = names[:2 * len(set(names))], names[2 * len(set(names)):]
                self.assertEqual(each[0::2], each[1::2], stage.name)
                self.assertEqual(len(set(each)), len(each) // 2, stage.name)
                self.assertEqual(more, list(VIEWER_OPPONENTS * (VIEWER_RUNS - 1)), stage.name)

    def test_frames_that_are_not_drawn_are_run_by_turns_the_one_or_the_other_first(self):
        undrawn = [stage for stage in plan(NORMAL, Path("scratch")) if stage.name.startswith(UNDRAWN)]
        drawn = [stage for stage in plan(NORMAL, Path("scratch")) if stage.name.startswith("viewer-")]
        self.assertEqual([stage.arguments[0] for stage in undrawn], [stage.arguments[0] for stage in drawn])
        for stage in undrawn:
            self.assertEqual(stage.arguments[-2:], ("--draw", "0"))
            names = stage.arguments[stage.arguments.index("--backend") + 1].split(",")
            pairs = [tuple(names[i:i + 2]) for i in range(0, len(names), 2)]
            self.assertEqual(len(pairs), 1 + VIEWER_RUNS)  # the first warms up
            self.assertEqual({frozenset(pair) for pair in pairs}, {frozenset(VIEWER_OPPONENTS)})
            self.assertEqual(sum(pair == VIEWER_OPPONENTS for pair in pairs), len(pairs) // 2 + 1)

    def test_a_quick_report_runs_each_back_end_of_the_viewer_once(self):
        for stage in plan(QUICK, Path("scratch")):
            if stage.kind == Kind.VIEWER:
                self.assertEqual(len(stage.arguments[-1].split(",")), 2 * len(QUICK.viewer_backends), stage.name)

    def test_text_is_made_of_benchmarks_that_the_page_has_too(self):
        stages = text_plan(NORMAL)
        self.assertEqual({stage.kind for stage in stages}, {Kind.BENCH})
        self.assertLess({stage.name for stage in stages}, {stage.name for stage in plan(NORMAL, Path("scratch"))})
        self.assertEqual(stages[0].name, "cuts")

    def test_a_worst_fan_is_drawn_from_the_planes_that_it_was_found_in(self):
        random, nasty = gallery_stages([WorstFan("car", "random", 7, 2.0), WorstFan("rook", "nasty", 8, 1.0)])
        self.assertEqual(random.arguments, ("--json", "--caps", "--only", "7", "--random-only", "data/models/car.obj"))
        self.assertEqual(nasty.arguments, ("--json", "--caps", "--only", "8", "data/models/rook.obj"))


if __name__ == "__main__":
    unittest.main()
