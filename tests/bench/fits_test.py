"""Exponents and their intervals, crossovers, and what pays back."""

import math
import unittest

from report import fits


class Fits(unittest.TestCase):
    def test_a_power_law_gives_its_exponent_and_factor(self):
        fitted = fits.exponent([(n, 3.0 * n**1.5) for n in (10, 100, 1000, 10000)])
        self.assertAlmostEqual(fitted.value, 1.5)
        self.assertAlmostEqual(fitted.factor, 3.0)
        self.assertLess(fitted.half_width, 1e-6)

    def test_scatter_widens_the_interval_by_students_t(self):
        # Residuals +d, -2d, +d in logarithms around slope 1: worked out by hand.
        d = 0.1
        fitted = fits.exponent([(math.e**x, math.e**(x + r)) for x, r in ((0, d), (1, -2 * d), (2, d))])
        self.assertAlmostEqual(fitted.value, 1.0)
        one_degree = math.tan(0.475 * math.pi)  # Student's distribution is Cauchy's there
        self.assertAlmostEqual(fitted.half_width, one_degree * math.sqrt(6 * d * d / 1 / 2))

    def test_quantiles_of_students_t_are_those_of_printed_tables(self):
        for degrees, t in ((1, 12.706), (2, 4.303), (3, 3.182), (4, 2.776), (10, 2.228), (13, 2.160), (30, 2.042)):
            self.assertAlmostEqual(fits.student_quantile(degrees), t, places=3)

    def test_leaving_out_the_point_that_bends_a_line_gives_it_back(self):
        points = [(n, float(n)) for n in (1, 10, 100)] + [(1000, 5000.0)]
        self.assertAlmostEqual(fits.without_each(points)[3].value, 1.0)
        self.assertGreater(fits.without_each(points)[0].value, 1.1)

    def test_slopes_are_those_between_neighbours(self):
        self.assertEqual([round(slope, 9) for slope in fits.slopes([(100, 1e4), (1, 1.0), (10, 10.0)])], [1.0, 3.0])

    def test_too_few_sizes_give_no_exponent_or_no_interval(self):
        self.assertIsNone(fits.exponent([(10, 1.0)]))
        self.assertIsNone(fits.exponent([(10, 1.0), (10, 2.0)]))
        self.assertIsNone(fits.exponent([(10, 1.0), (100, 2.0)]).half_width)

    def test_preparing_is_paid_back_by_quicker_cuts_only(self):
        self.assertEqual(fits.cuts_to_pay_back(100.0, 0.0, 1.0, 3.0), 50.0)
        self.assertIsNone(fits.cuts_to_pay_back(100.0, 0.0, 3.0, 3.0))

    def test_a_crossover_is_interpolated_between_sizes_in_logarithms(self):
        def cells(faster, slower):
            times = {("new", n): ms for n, ms in zip((10, 1000), faster)} | {("old", n): ms for n,
                                                                             ms in zip((10, 1000), slower)}
            return {key: {"triangles": (key[1],) * 3, "real_time": (ms,) * 3} for key, ms in times.items()}

        self.assertAlmostEqual(fits.crossover(cells((2.0, 0.5), (1.0, 1.0)), "old", "new"), 100.0)
        self.assertEqual(fits.crossover(cells((0.5, 0.5), (1.0, 1.0)), "old", "new"), 10)  # at every size
        self.assertIsNone(fits.crossover(cells((2.0, 2.0), (1.0, 1.0)), "old", "new"))


if __name__ == "__main__":
    unittest.main()
