"""The runner over real files: what it takes out of Assimp's answers, and what it makes of results."""

import gzip
import os
import sys
import tempfile
import unittest
from pathlib import Path
from unittest import mock

sys.path.insert(0, str(Path(__file__).resolve().parent))

import world  # noqa: E402  (found through the line above)

INFO = """Memory consumption: 237174 B
Meshes:             3
Faces:              110

Meshes:  (name) [vertices / bones / faces | primitive_types]
    0 (leg (left)): [108 / 0 / 80 | triangle]
    1 (eye): [9 / 0 / 7 | point]
    2 (head): [27 / 0 / 20 | triangle]

Named Materials:
    'x' (prop) [index / bytes | texture semantic]

Node hierarchy:
ROOT
├╴a (mesh 0)
├╴b (mesh 0, 1)
└╴c (mesh 2)
"""


def result(**more):
    return {"name": "package/a.obj", "outcome": "right", "triangles": 12, "degenerate_triangles": 2, "duplicate_triangles": 1,
            "closed": True, "notes": "", "cuts": 3, "missed": 1, "assimp": 12, "assimp_polygons": False, **more}


def refused(**more):
    return {"name": "package/a.obj", "outcome": "refused", "says": "line 3: no", "assimp": 12, "assimp_polygons": False, **more}


class WorldTest(unittest.TestCase):
    def test_triangles_of_assimp_are_counted_as_often_as_nodes_show_them(self):
        self.assertEqual(world.assimp_triangles(INFO), (180, False))
        self.assertEqual(world.assimp_triangles(INFO.replace("triangle", "polygon", 1)), (180, True))
        self.assertEqual(world.assimp_triangles("ERROR: Failed to load file"), (0, False))

    def test_counts_may_differ_by_what_assimp_drops_from_polygons(self):
        self.assertTrue(world.is_counted_alike(result()))
        for assimp in (8, 9, 11, 13):
            self.assertFalse(world.is_counted_alike(result(assimp=assimp)))
            self.assertEqual(world.is_counted_alike(result(assimp=assimp, assimp_polygons=True)), 9 <= assimp <= 12)

    def test_what_is_worse_than_assimp_needs_a_reason(self):
        self.assertFalse(world.needs_reason(result()))
        self.assertIsNone(world.finding(result()))
        for worse in (result(assimp=13), refused(), result(outcome="wrong", says="x"), result(outcome="crashed", says="x"),
                      result(outcome="hung", says="x")):
            self.assertTrue(world.needs_reason(worse))
            self.assertIsNotNone(world.finding(worse))
        for other in (result(assimp=None, assimp_says="no"), refused(assimp=None, assimp_says="no")):
            self.assertFalse(world.needs_reason(other))
            self.assertIsNotNone(world.finding(other))

    def test_reasons_are_found_by_the_name(self):
        with mock.patch.object(world, "EXCEPTIONS", [("*/b.obj", "first"), ("package/*", "second")]):
            self.assertEqual(world.reason(refused()), "second")
            self.assertEqual(world.reason(refused(name="package/b.obj")), "first")
            self.assertIsNone(world.reason(refused(name="other/a.obj")))

    def test_the_table_counts_every_file_once(self):
        rows = [result(), result(name="package/b.stl"), refused(name="package/c.stl"), result(name="other/a.glb", outcome="wrong", says="x"),
                result(name="other/b.gltf", assimp=None, assimp_says="no")]
        lines = world.table(rows)
        self.assertEqual(len(lines), 2 + 3 + 1)
        self.assertEqual(lines[-1], "| **all** |  | 5 | 4 | 1 | 3 | 1 | 0 | 4 | 3 | 1 | 1 |")
        page = world.summary(rows, "commit x")
        self.assertIn("line 3: no", page)
        self.assertIn("**none is known**", page)

    def test_packed_meshes_are_unpacked_and_links_are_not_counted(self):
        with tempfile.TemporaryDirectory() as folder:
            files = Path(folder) / "files" / world.PACKAGES[0]
            files.mkdir(parents=True)
            (files / "a.stl").write_text("solid")
            (files / "b.txt").write_text("no mesh")
            os.symlink("a.stl", files / "c.stl")
            (files / "d.obj.gz").write_bytes(gzip.compress(b"v 0 0 0\n"))
            world.unpack(files)
            self.assertEqual([path.name for path in world.meshes(Path(folder))], ["a.stl", "d.obj"])
            self.assertEqual((files / "d.obj").read_text(), "v 0 0 0\n")

    def test_a_process_that_dies_or_hangs_is_told_from_one_that_fails(self):
        self.assertTrue(world.run("sh", "-c", "kill -SEGV $$").crashed())
        self.assertEqual(world.run("sh", "-c", "echo 'kerf: a: no' >&2; exit 1").sentence(), "a: no")
        with mock.patch.object(world, "SECONDS", 0.2):
            slow = world.run("sleep", "60")
        self.assertFalse(slow.in_time or slow.crashed())


if __name__ == "__main__":
    unittest.main()
