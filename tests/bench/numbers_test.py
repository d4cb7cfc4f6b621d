"""How numbers are shown."""

import unittest

from report.tables.numbers import count_short, percent, quoted, rounded, scientific, short, timed


class Numbers(unittest.TestCase):
    def test_times_have_two_digits_and_three_if_the_first_is_a_1(self):
        for ms, shown in ((7.813, "7.8"), (52.2, "52"), (1.178, "1.18"), (15.13, "15.1"), (0.0123, "0.0123"),
                          (0.0357, "0.036"),
                          (0.00014, "0.000140"), (405.1, "410"), (165.0, "165"), (2133.1, "2\u202f100"),
                          (1931.0, "1\u202f930"), (0, "0")):
            self.assertEqual(timed(ms), shown)

    def test_what_rounds_up_to_a_1_counts_as_one(self):
        self.assertEqual([timed(ms) for ms in (9.96, 0.0996, 99.6, 1.996)], ["10.0", "0.100", "100", "2.0"])

    def test_what_repetitions_disagree_about_has_no_third_digit(self):
        self.assertEqual([timed(1.178, spread) for spread in (None, 0.1, 0.11)], ["1.18", "1.18", "1.2"])
        self.assertEqual(timed(52.2, 0.5), "52")

    def test_a_loss_keeps_its_sign(self):
        self.assertEqual(timed(-3.241), "-3.2")

    def test_the_reports_times_are_quoted(self):
        self.assertEqual([quoted(ms) for ms in (747.159, 0.099)], ["747.2", "0.099"])

    def test_sizes_and_shares_are_shown_as_people_write_them(self):
        self.assertEqual([count_short(n) for n in (12, 3_000, 100_000, 4_000_000)], ["12", "3 k", "100 k", "4 M"])
        self.assertEqual([percent(share) for share in (0.0, 1e-16, 0.012, 0.25, 5.82)],
                         ["0", "0", "1.2 %", "25 %", "582 %"])
        self.assertEqual([rounded(n).replace("\u202f", " ") for n in (19354, 308138, 47, 0.123, 0)],
                         ["19 000", "310 000", "47", "0.12", "0"])

    def test_errors_are_powers_of_ten(self):
        self.assertEqual([scientific(error) for error in (0, 4.06e-9)], ["0", "4.1e-09"])

    def test_a_back_end_is_named_without_its_family(self):
        self.assertEqual([short(name) for name in ("baseline/hash", "halfedge")], ["hash", "halfedge"])


if __name__ == "__main__":
    unittest.main()
