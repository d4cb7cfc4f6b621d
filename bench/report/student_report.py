"""The student report's Tables 1 and 2, which everything is set beside."""

import csv
from pathlib import Path

TABLES = Path(__file__).resolve().parent.parent / "report_tables.csv"


def report_rows() -> list[dict[str, str]]:
    """One row a model: model, faces, vertices, cut_ms, hull_ms, fps."""
    with open(TABLES, encoding="utf-8") as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))
