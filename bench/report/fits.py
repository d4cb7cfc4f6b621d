"""How times grow: exponents with their confidence, and the sizes from which on one back end is faster."""

import math
import statistics
from dataclasses import dataclass
from typing import Sequence

from run_bench import fitted_exponent

# Student's t for 97.5 %, by degrees of freedom; beyond, the normal distribution's 1.96 is near enough.
STUDENT = [12.706, 4.303, 3.182, 2.776, 2.571, 2.447, 2.365, 2.306, 2.262, 2.228]
FITTED_FROM = 9_000  # triangles; smaller meshes are dominated by the fixed cost of a cut. Shapes miss their size by a little


@dataclass(frozen=True)
class Exponent:
    """e in time = factor * triangles^e, with the half width of its 95 % confidence interval (None from fewer than 3 points)."""

    value: float
    half_width: float | None
    points: int
    factor: float = 1.0

    def text(self) -> str:
        return f"{self.value:.2f}" + (f" ± {self.half_width:.2f}" if self.half_width is not None else "")


def exponent(points: Sequence[tuple[float, float]]) -> Exponent | None:
    """By least squares in logarithms; None for fewer than two sizes."""
    usable = [(size, value) for size, value in points if size > 0 and value > 0]
    if len({size for size, _ in usable}) < 2:
        return None
    slope, error = fitted_exponent(usable)
    factor = math.exp(statistics.mean(math.log(value) - slope * math.log(size) for size, value in usable))
    degrees = len(usable) - 2
    if degrees < 1:
        return Exponent(slope, None, len(usable), factor)
    t = STUDENT[degrees - 1] if degrees <= len(STUDENT) else 1.96
    return Exponent(slope, t * error, len(usable), factor)


def cuts_to_pay_back(prepare: float, other_prepare: float, cut: float, other_cut: float) -> float | None:
    """After how many cuts the time spent preparing is regained by quicker cuts; None when it never is."""
    if cut >= other_cut:
        return None
    return max(prepare - other_prepare, 0.0) / (other_cut - cut)
