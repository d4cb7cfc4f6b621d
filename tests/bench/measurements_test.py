"""What stages' files say."""

import json
import tempfile
import unittest
from pathlib import Path

from report import measurements
from report.measurements import Measurements, commits, order


class Loading(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def load(self, *stages):
        files = []
        for number, stage in enumerate(stages):
            files.append(self.folder / f"{number}.json")
            files[-1].write_text(json.dumps(stage))
        return measurements.load(files)

    def test_the_commits_are_those_of_the_stages(self):
        found = Measurements()
        found.stages = [{"commit": "b"}, {"commit": "a"}, {"commit": "b"}]
        self.assertEqual(commits(found), "b, a")

    def test_benchmarks_of_several_stages_are_one_table(self):
        found = self.load(*({"stage": name, "kind": "bench", "result": {"benchmarks": [
            {"run_type": "iteration", "name": f"{name}/manual_time", "real_time": 1.0}]}}
                            for name in ("Cut/a/rook", "Cut/b/rook")))
        self.assertEqual(list(found.bench), ["Cut/a/rook", "Cut/b/rook"])
        self.assertEqual([stage["stage"] for stage in found.stages], ["Cut/a/rook", "Cut/b/rook"])

    def test_a_comparison_is_kept_by_its_mix_of_planes_and_a_drawn_cap_by_its_model(self):
        found = self.load({"stage": "compare-nasty", "kind": "compare", "result": {"files": []}},
                          {"stage": "gallery-car", "kind": "compare",
                           "result": {"files": [{"file": "data/models/car.obj", "rows": [{"number": 7}]}]}})
        self.assertEqual(found.comparisons, {"nasty": {"files": []}})
        self.assertEqual(found.drawn_caps, [{"model": "car", "number": 7}])

    def test_the_last_run_of_a_back_end_counts_and_missed_cuts_are_no_cuts(self):
        def run(backend, status):
            cut = {"status": status, "triangles": 9, "crossing": 3, "cut_to_upload_cpu_ms": 0.5, "bytes_uploaded": 100}
            times = ("frame_ms", "simulate_cpu_ms", "submit_cpu_ms", "cut_to_upload_cpu_ms")
            return {"backend": backend, "cuts": [cut]} | {name: {"median": 1.0} for name in times}

        found = self.load({"stage": "viewer-rook", "kind": "viewer", "command": ["viewer", "data/models/rook.obj"],
                           "result": {"graphics": "a card", "runs": [run("halfedge", "missed"), run("halfedge", "cut"),
                                               run("linear", "cut"), run("linear", "missed")]}})
        self.assertEqual([(each.model, each.backend, each.graphics, len(each.cuts)) for each in found.runs],
                         [("rook", "halfedge", "a card", 1), ("rook", "linear", "a card", 0)])

    def test_times_of_the_viewer_are_medians_of_the_runs_behind_the_first(self):
        def run(ms):
            times = ("frame_ms", "simulate_cpu_ms", "submit_cpu_ms", "cut_to_upload_cpu_ms")
            return {"backend": "halfedge", "cuts": []} | {name: {"max": ms} for name in times}

        found = self.load({"stage": "viewer-rook", "kind": "viewer", "command": ["viewer", "data/models/rook.obj"],
                           "result": {"graphics": "a card", "runs": [run(ms) for ms in (90.0, 1.0, 7.0, 2.0)]}})
        self.assertEqual([each.times["simulate_cpu_ms"]["max"] for each in found.runs], [2.0])

    def test_runs_that_draw_nothing_are_kept_apart(self):
        run = {"backend": "halfedge", "cuts": []} | {name: {"max": 2.0} for name in (
            "frame_ms", "simulate_cpu_ms", "submit_cpu_ms", "cut_to_upload_cpu_ms")}
        found = self.load({"stage": "frames-rook", "kind": "viewer", "command": ["viewer", "data/models/rook.obj"],
                           "result": {"graphics": "a card", "runs": [run, run]}})
        self.assertEqual(found.runs, [])
        self.assertEqual(found.undrawn_run_of("rook", "halfedge").times["simulate_cpu_ms"]["max"], 2.0)
        self.assertIsNone(found.undrawn_run_of("rook", "linear"))

    def test_answers_of_other_libraries_are_rows(self):
        found = self.load(*({"stage": kind, "kind": kind, "result": {"peers": [{"peer": kind}]}}
                            for kind in ("peers", "vtk")))
        self.assertEqual([row["peer"] for row in found.peers], ["peers", "vtk"])


class Looking(unittest.TestCase):
    NAMES = ("Scale/halfedge/asteroid/1000", "Scale/baseline/hash/asteroid/1000", "Scale/halfedge/shuffled/1000",
             "Chain/kept/halfedge/asteroid/30", "Cut/halfedge/rook")

    def setUp(self):
        self.found = Measurements(bench={name: {"ms": (number,) * 3} for number, name in enumerate(self.NAMES)})

    def test_growth_is_found_by_back_end_and_size(self):
        self.assertEqual(list(self.found.growth("Scale", "asteroid")), [("halfedge", 1000), ("baseline/hash", 1000)])

    def test_sized_benchmarks_come_by_size_and_then_by_back_end(self):
        self.assertEqual([(backend, size) for backend, size, _ in self.found.sized("Scale")],
                         [("baseline/hash", 1000), ("halfedge", 1000), ("halfedge", 1000)])
        self.assertEqual([backend for backend, _, _ in self.found.sized("Chain")], ["kept/halfedge"])

    def test_a_benchmark_of_a_model_is_found_by_name(self):
        self.assertEqual(self.found.of_model("Cut", "halfedge", "rook"), {"ms": (4, 4, 4)})
        self.assertIsNone(self.found.of_model("Cut", "halfedge", "car"))

    def test_a_back_end_that_nobody_knows_comes_last(self):
        self.assertEqual(sorted(["new", "halfedge", "baseline/scan"], key=order), ["baseline/scan", "halfedge", "new"])

    def test_models_are_named_without_folder_and_size(self):
        self.assertEqual(measurements.model_name("build/x/asteroid-1000.ply"), "asteroid")


if __name__ == "__main__":
    unittest.main()
