"""Which caps are judged, and what their tables say."""

import unittest

from report.chapters.caps import verdict
from report.judged_caps import judged_rows, overlap_share, worst_fans
from report.measurements import Measurements
from report.tables.cap_tables import cap_rows_table, caps_table, least_angles_table


def cut(number, fan_excess, area=1.0, **more):
    """A row of `kerf compare`: a cut whose fan covers so much too much."""
    return {"number": number, "status": "cut", "loops": 1, "covered_area": area, "section_area": area, "kind": "axis",
            "plane": {"normal": [1, 0, 0], "offset": 0.5}, "crossing": 9, "fan_fits": fan_excess == 0, "cap_fits": True,
            "section_intersects_itself": False,
            "baseline": {"cap_excess": fan_excess, "cap_overlap": fan_excess / 2, "cap_least_angle": 1.0},
            "halfedge": {"cap_excess": 0.0, "cap_least_angle": 3.0}} | more


def compared(**rows_of_models):
    summary = {"cut": 2, "missed": 1, "fans_wrong": 1, "worst_fan": 2.0, "caps_wrong": 0, "worst_cap": 0.0,
               "sections_that_intersect_themselves": 0, "surfaces_differ": 0, "failed": 0}
    files = [{"file": f"data/models/{model}.obj", "rows": rows, "summary": summary, "failures": []}
             for model, rows in rows_of_models.items()]
    return Measurements(comparisons={"nasty": {"files": files, "total": {"cut": 2, "failed": 0, "surfaces_differ": 0}}})


class JudgedCaps(unittest.TestCase):
    def judged(self, *rows):
        return [row["number"] for row, _, _ in judged_rows({"rows": rows})]

    def test_missed_planes_and_sections_next_to_nothing_are_not_judged(self):
        self.assertEqual(self.judged(cut(1, 0.0), cut(2, 0.0, status="missed"), cut(3, 0.0, loops=0),
                                     cut(4, 0.0, area=1e-9)), [1])

    def test_errors_are_shares_of_the_section(self):
        (_, fan, cap), = judged_rows({"rows": [cut(1, 3.0, area=2.0)]})
        self.assertEqual((fan, cap), (1.5, 0.0))
        self.assertEqual(overlap_share(cut(1, 3.0, area=2.0)), 0.75)
        self.assertIsNone(overlap_share(cut(1, 3.0, baseline={"cap_excess": 3.0})))

    def test_the_worst_fan_of_each_model_the_worst_model_first(self):
        found = compared(rook=[cut(1, 0.2), cut(2, 0.6), cut(3, 0.4)], car=[cut(4, 2.0)], cube=[cut(5, 0.01)])
        self.assertEqual([(fan.model, fan.number, fan.planes) for fan in worst_fans(found, 4)],
                         [("car", 4, "nasty"), ("rook", 2, "nasty")])
        self.assertEqual(len(worst_fans(found, 1)), 1)

    def test_a_section_that_crosses_itself_makes_no_picture(self):
        self.assertEqual(worst_fans(compared(rook=[cut(1, 2.0, section_intersects_itself=True)]), 4), [])

    def test_a_model_is_a_row_with_the_median_of_its_fans(self):
        row, = caps_table(compared(rook=[cut(1, 0.0), cut(2, 2.0)]), "nasty").rows
        self.assertEqual((row["model"], row["median_fan_error"], row["worst_overlap"]), ("rook", 1.0, 1.0))
        self.assertEqual(caps_table(Measurements(), "nasty").rows, [])

    def test_each_cut_is_a_row_of_the_csv_and_angles_are_medians_of_them(self):
        found = compared(rook=[cut(1, 0.0), cut(2, 2.0)])
        self.assertEqual([row["number"] for row in cap_rows_table(found).rows], [1, 2])
        self.assertEqual(least_angles_table(found).rows,
                         [{"model": "rook", "cuts": 2, "fan": 1.0, "triangulation": 3.0}])

    def test_that_the_back_ends_do_not_agree_cannot_be_overlooked(self):
        found = compared(rook=[cut(1, 0.0)])
        self.assertIn("the same surface, bit for bit", verdict(found))
        found.comparisons["nasty"]["total"]["surfaces_differ"] = 1
        self.assertIn("DO NOT AGREE", verdict(found))
        self.assertEqual(verdict(Measurements()), "The comparison was not run.")


if __name__ == "__main__":
    unittest.main()
