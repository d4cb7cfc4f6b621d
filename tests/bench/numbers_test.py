"""How numbers are shown."""

import unittest

from report.tables.numbers import count_short, microseconds, milliseconds, percent, rounded, scientific, short


class Numbers(unittest.TestCase):
    def test_numbers_are_shown_as_people_write_them(self):
        self.assertEqual([count_short(n) for n in (12, 3_000, 100_000, 4_000_000)], ["12", "3 k", "100 k", "4 M"])
        self.assertEqual([percent(share) for share in (0.0, 1e-16, 0.012, 0.25, 5.82)], ["0", "0", "1.2 %", "25 %", "582 %"])
        self.assertEqual([rounded(n).replace("\u202f", " ") for n in (19354, 308138, 47, 0.123, 0)], ["19 000", "310 000", "47", "0.12", "0"])
        self.assertEqual([milliseconds(ms) for ms in (0.0123, 9.9994, 123.4)], ["0.012", "9.999", "123.4"])

    def test_times_of_less_than_ten_microseconds_have_more_digits(self):
        self.assertEqual([microseconds(ms) for ms in (0.00152, 0.5)], ["0.00152", "0.500"])

    def test_errors_are_powers_of_ten(self):
        self.assertEqual([scientific(error) for error in (0, 4.06e-9)], ["0", "4.1e-09"])

    def test_a_back_end_is_named_without_its_family(self):
        self.assertEqual([short(name) for name in ("baseline/hash", "halfedge")], ["hash", "halfedge"])


if __name__ == "__main__":
    unittest.main()
