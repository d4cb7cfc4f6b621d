"""How times grow: exponents with their confidence, and the sizes from which on one back end is faster."""

import math
import statistics
from dataclasses import dataclass
from typing import Sequence

from report.repetitions import Counters

# Triangles. Smaller meshes are dominated by the fixed cost of a cut; shapes miss their size by a little.
FITTED_FROM = 9_000


@dataclass(frozen=True)
class Exponent:
    """e in time = factor * triangles^e, with the half width of its 95 % confidence interval (None from fewer than 3
    points)."""

    value: float
    half_width: float | None
    points: int
    factor: float = 1.0

    def text(self) -> str:
        return f"{self.value:.2f}" + (f" ± {self.half_width:.2f}" if self.half_width is not None else "")


def slope_and_error(points: Sequence[tuple[float, float]]) -> tuple[float, float]:
    """Slope of log(time) over log(size) by least squares, and its standard error."""
    x = [math.log(size) for size, _ in points]
    y = [math.log(value) for _, value in points]
    n, mx, my = len(x), statistics.mean(x), statistics.mean(y)
    sxx = sum((a - mx) ** 2 for a in x)
    slope = sum((a - mx) * (b - my) for a, b in zip(x, y)) / sxx
    residual = sum((b - my - slope * (a - mx)) ** 2 for a, b in zip(x, y))
    return slope, math.sqrt(residual / max(n - 2, 1) / sxx)


def exponent(points: Sequence[tuple[float, float]]) -> Exponent | None:
    """By least squares in logarithms; None for fewer than two sizes."""
    usable = [(size, value) for size, value in points if size > 0 and value > 0]
    if len({size for size, _ in usable}) < 2:
        return None
    slope, error = slope_and_error(usable)
    factor = math.exp(statistics.mean(math.log(value) - slope * math.log(size) for size, value in usable))
    degrees = len(usable) - 2
    if degrees < 1:
        return Exponent(slope, None, len(usable), factor)
    return Exponent(slope, student_quantile(degrees) * error, len(usable), factor)


def student_share(t: float, degrees: int) -> float:
    """The share of Student's distribution that lies within ±t: Abramowitz and Stegun, "Handbook of Mathematical
    Functions" (1964), 26.7.3 and 26.7.4, exact sums for whole degrees of freedom."""
    angle = math.atan(t / math.sqrt(degrees))
    cosine = math.cos(angle)
    term, total = 1.0, 0.0
    if degrees % 2 == 0:
        for step in range(degrees // 2):
            total += term
            term *= cosine**2 * (2 * step + 1) / (2 * step + 2)
        return math.sin(angle) * total
    term = cosine
    for step in range((degrees - 1) // 2):
        total += term
        term *= cosine**2 * (2 * step + 2) / (2 * step + 3)
    return 2 / math.pi * (angle + math.sin(angle) * total)


def student_quantile(degrees: int, share: float = 0.95) -> float:
    """The t within which this share of Student's distribution lies, by bisection."""
    low, high = 0.0, 1e3
    for _ in range(80):
        middle = (low + high) / 2
        low, high = (middle, high) if student_share(middle, degrees) < share else (low, middle)
    return (low + high) / 2


def without_each(points: Sequence[tuple[float, float]]) -> list[Exponent | None]:
    """The exponents that are fitted when one of the points is left out, in the order of the points."""
    return [exponent([*points[:left_out], *points[left_out + 1:]]) for left_out in range(len(points))]


def slopes(points: Sequence[tuple[float, float]]) -> list[float]:
    """Exponents between neighbouring sizes, smallest first."""
    ordered = sorted(point for point in points if point[0] > 0 and point[1] > 0)
    return [math.log(b / a) / math.log(m / n) for (n, a), (m, b) in zip(ordered, ordered[1:]) if m > n]


def cuts_to_pay_back(prepare: float, other_prepare: float, cut: float, other_cut: float) -> float | None:
    """After how many cuts the time spent preparing is regained by quicker cuts; None when it never is."""
    if cut >= other_cut:
        return None
    return max(prepare - other_prepare, 0.0) / (other_cut - cut)


def crossover(cells: dict[tuple[str, int], Counters], slower: str, faster: str) -> float | None:
    """Triangles from which on `faster` takes less time than `slower`, by interpolation between sizes; None if it never
    does."""
    sizes = sorted(size for backend, size in cells if backend == faster and (slower, size) in cells)
    ratios = [(cells[(faster, size)]["triangles"][0],
               cells[(faster, size)]["real_time"][0] / cells[(slower, size)]["real_time"][0]) for size in sizes]
    result = None
    for (n0, r0), (n1, r1) in reversed(list(zip(ratios, ratios[1:]))):
        if r1 >= 1:
            return result
        if r0 >= 1:
            share = math.log(r0) / (math.log(r0) - math.log(r1))
            return math.exp(math.log(n0) + share * (math.log(n1) - math.log(n0)))
        result = n0
    return result
