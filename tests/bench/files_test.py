"""Files are there whole or not at all."""

import tempfile
import unittest
from pathlib import Path

from report import files


class Files(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def test_what_is_written_is_read_back_in_folders_that_are_made(self):
        files.write_json(self.folder / "a/b.json", {"ms": [1.5]})
        self.assertEqual(files.read_json(self.folder / "a/b.json"), {"ms": [1.5]})
        self.assertEqual([file.name for file in (self.folder / "a").iterdir()], ["b.json"])

    def test_a_failure_leaves_the_old_file_and_nothing_else(self):
        path = self.folder / "a.txt"
        files.write_text(path, "old")
        with self.assertRaises(UnicodeEncodeError):
            files.write_text(path, "half of it \udc80")
        self.assertEqual(path.read_text(), "old")
        self.assertEqual(list(self.folder.iterdir()), [path])


if __name__ == "__main__":
    unittest.main()
