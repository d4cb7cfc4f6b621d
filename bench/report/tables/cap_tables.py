"""Whether caps are right: the fan against the constrained triangulation, from what `kerf compare` found."""

import statistics

from report.judged_caps import judged_rows, overlap_share
from report.measurements import Measurements, model_name
from report.tables.numbers import digits, percent, scientific
from report.tables.table import Column, Table


def caps_table(found: Measurements, mix: str) -> Table:
    """One row a model: how often each cap is wrong, and by how much of the section."""
    table = Table(f"caps_{mix}", [Column("model", "model"), Column("cuts", "cuts"), Column("missed", "missed"),
                                  Column("fans_wrong", "fans wrong"), Column("median_fan_error", "median", percent),
                                  Column("worst_fan_error", "worst", percent),
                                  Column("worst_overlap", "worst overlap", percent),
                                  Column("caps_wrong", "triangulations wrong"),
                                  Column("worst_cap_error", "worst", scientific),
                                  Column("not_judged", "self-crossing sections"),
                                  Column("surfaces_differ", "surfaces that differ"), Column("failed", "checks failed")])
    for file in found.comparisons.get(mix, {"files": []})["files"]:
        summary = file["summary"]
        fans = [fan for _, fan, _ in judged_rows(file)]
        table.rows.append({"model": model_name(file["file"]), "cuts": summary["cut"], "missed": summary["missed"],
                           "fans_wrong": summary["fans_wrong"],
                           "median_fan_error": statistics.median(fans) if fans else None,
                           "worst_fan_error": summary["worst_fan"],
                           "worst_overlap": max((share for row, _, _ in judged_rows(file)
                                                 if (share := overlap_share(row)) is not None), default=None),
                           "caps_wrong": summary["caps_wrong"],
                           "worst_cap_error": summary["worst_cap"],
                           "not_judged": summary["sections_that_intersect_themselves"],
                           "surfaces_differ": summary["surfaces_differ"],
                           "failed": summary["failed"] + len(file["failures"])})
    return table


def cap_rows_table(found: Measurements) -> Table:
    """Each model and plane, one a row: for the CSV and the plot."""
    table = Table("caps_by_plane", [Column(key, key) for key in (
        "planes", "model", "number", "kind", "normal_x", "normal_y", "normal_z", "offset", "crossing", "loops",
        "section_area", "fan_error", "triangulation_error", "fan_overlap", "fan_least_angle",
        "triangulation_least_angle", "fan_fits", "cap_fits", "section_intersects_itself")])
    for mix, result in found.comparisons.items():
        for file in result["files"]:
            for row, fan, cap in judged_rows(file):
                x, y, z = row["plane"]["normal"]
                table.rows.append({"planes": mix, "model": model_name(file["file"]), "number": row["number"],
                                   "kind": row["kind"], "normal_x": x, "normal_y": y, "normal_z": z,
                                   "offset": row["plane"]["offset"], "crossing": row["crossing"], "loops": row["loops"],
                                   "section_area": row["section_area"], "fan_error": fan, "triangulation_error": cap,
                                   "fan_overlap": overlap_share(row),
                                   "fan_least_angle": row["baseline"].get("cap_least_angle"),
                                   "triangulation_least_angle": row["halfedge"].get("cap_least_angle"),
                                   "fan_fits": row["fan_fits"], "cap_fits": row["cap_fits"],
                                   "section_intersects_itself": row["section_intersects_itself"]})
    return table


def least_angles_table(found: Measurements) -> Table:
    """Smallest angles of caps, medians over the cuts of each model."""
    table = Table("least_angles", [Column("model", "model"), Column("cuts", "cuts"), Column("fan", "fan", digits(2)),
                                   Column("triangulation", "triangulation", digits(2))])
    rows = [row for row in cap_rows_table(found).rows if row.get("fan_least_angle") is not None]
    for model in dict.fromkeys(row["model"] for row in rows):
        own = [row for row in rows if row["model"] == model]
        table.rows.append({"model": model, "cuts": len(own),
                           "fan": statistics.median(row["fan_least_angle"] for row in own),
                           "triangulation": statistics.median(row["triangulation_least_angle"] for row in own)})
    return table


def gallery_table(found: Measurements) -> Table:
    """The caps that are drawn."""
    table = Table("gallery", [Column("model", "model"), Column("number", "plane"), Column("kind", "kind"),
                              Column("crossing", "triangles crossed"), Column("loops", "loops"),
                              Column("fan_error", "fan covers too much", percent),
                              Column("fan_overlap", "more than once", percent),
                              Column("fan_least_angle", "its smallest angle, °", digits(2)),
                              Column("triangulation_error", "triangulation's error", scientific),
                              Column("triangulation_least_angle", "its smallest angle, °", digits(2))])
    for row in found.drawn_caps:
        area, fan, cap = row["covered_area"], row["baseline"], row["halfedge"]
        table.rows.append({"model": row["model"], "number": row["number"], "kind": row["kind"],
                           "crossing": row["crossing"],
                           "loops": row["loops"], "fan_error": fan["cap_excess"] / area,
                           "fan_overlap": None if fan["cap_overlap"] is None else fan["cap_overlap"] / area,
                           "fan_least_angle": fan["cap_least_angle"], "triangulation_error": cap["cap_excess"] / area,
                           "triangulation_least_angle": cap["cap_least_angle"]})
    return table
