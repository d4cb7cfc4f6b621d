"""How numbers are shown."""

import math
from typing import Any, Callable

Formatter = Callable[[Any], str]
ABSENT = "–"


WIDE_SPREAD = 0.1  # of the median: repetitions that differ by more leave no third digit


def timed(value: float, spread: float | None = None) -> str:
    """A time, or what follows from times: two digits, three if the first is a 1 and the repetitions differ by little.
    Further digits would say nothing: repetitions differ by some per cent."""
    if value == 0:
        return "0"
    places = 1 - math.floor(math.log10(abs(float(f"{value:.1e}"))))
    if f"{abs(value):.1e}".startswith("1") and not (spread and spread > WIDE_SPREAD):
        places += 1
    return f"{value:.{places}f}" if places > 0 else count(round(value, places))


def quoted(value: float) -> str:
    """A time of the student report, nearly as it is printed there."""
    return f"{value:.3f}" if value < 10 else f"{value:.1f}"


def count(value: float) -> str:
    return f"{value:,.0f}".replace(",", "\u202f")


def rounded(value: float) -> str:
    """Two digits, as a sentence wants them of what is known to no more: 19 354 as "19 000"."""
    if value == 0:
        return "0"
    step = 10 ** (math.floor(math.log10(abs(value))) - 1)
    nearest = round(value / step) * step
    return count(nearest) if nearest >= 10 else f"{nearest:.2g}"


def count_short(value: float) -> str:
    """100000 as "100 k", 4000000 as "4 M"."""
    if value >= 1e6:
        return f"{value / 1e6:.3g} M"
    return f"{value / 1e3:.3g} k" if value >= 1e3 else f"{value:.0f}"


def plain(value: Any) -> str:
    return str(value)


def digits(number: int) -> Formatter:
    return lambda value: f"{value:.{number}f}"


def percent(value: float) -> str:
    """Of a share; rounding errors of doubles are 0."""
    if abs(value) < 1e-9:
        return "0"
    return f"{100 * value:.2g} %" if abs(value) < 0.1 else f"{100 * value:,.0f} %"


def scientific(value: float) -> str:
    return "0" if value == 0 else f"{value:.1e}"


def short(backend: str) -> str:
    """A look-up of the report without its family: "baseline/hash" as "hash"."""
    return backend.removeprefix("baseline/")
