"""The student report's tables."""

import unittest

from report.student_report import report_rows


class StudentReport(unittest.TestCase):
    def test_fifteen_models_have_all_their_columns(self):
        rows = report_rows()
        self.assertEqual(len(rows), 15)
        self.assertEqual({tuple(row) for row in rows}, {("model", "faces", "vertices", "cut_ms", "hull_ms", "fps")})

    def test_the_cube_has_twelve_faces_and_not_as_printed_twenty_four(self):
        cube = next(row for row in report_rows() if row["model"] == "cube")
        self.assertEqual((cube["faces"], cube["vertices"], cube["cut_ms"]), ("12", "24", "0.099"))


if __name__ == "__main__":
    unittest.main()
