"""Which cuts have caps worth judging, by how much the fans are wrong, and which are the worst."""

from dataclasses import dataclass
from typing import Any, Iterator

from report.measurements import Measurements, model_name

SMALLEST_SECTION = 1e-6  # of the model's largest section: below, a relative error says nothing
LEAST_SHOWN = 0.05  # of the section: fans that are less wrong make no picture


@dataclass(frozen=True)
class WorstFan:
    """Which cut of a model its worst fan closes, and the fan's error as a share of the section."""

    model: str
    planes: str  # the mix that the plane is of
    number: int  # of the plane
    error: float


def judged_rows(file: dict[str, Any]) -> Iterator[tuple[dict[str, Any], float, float]]:
    """Rows of cuts with a section worth judging: row, and the relative area errors of fan and triangulation."""
    rows = [row for row in file["rows"] if row["status"] == "cut" and row["loops"] > 0]
    largest = max((row["covered_area"] for row in rows), default=0.0)
    for row in rows:
        if row["covered_area"] > SMALLEST_SECTION * largest:
            yield (row, row["baseline"]["cap_excess"] / row["covered_area"],
                   row["halfedge"]["cap_excess"] / row["covered_area"])


def overlap_share(row: dict[str, Any]) -> float | None:
    """Of the section: the area that the fan covers more than once; None where that was not looked for."""
    overlap = row["baseline"].get("cap_overlap")
    return None if overlap is None else overlap / row["covered_area"]


def worst_fans(found: Measurements, most: int) -> list[WorstFan]:
    """The worst fan of each model where it is wrong, the worst first; at most so many."""
    worst: dict[str, WorstFan] = {}
    for planes, result in found.comparisons.items():
        for file in result["files"]:
            model = model_name(file["file"])
            for row, error, _ in judged_rows(file):
                least = worst[model].error if model in worst else LEAST_SHOWN
                if not row["section_intersects_itself"] and error > least:
                    worst[model] = WorstFan(model, planes, row["number"], error)
    return sorted(worst.values(), key=lambda fan: -fan.error)[:most]
