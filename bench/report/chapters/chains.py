"""Cuts in a row."""

from report.measurements import Measurements
from report.sections import Facts, Section, ShownFigure, ShownTable
from report.tables import chain_decades_table, chains_table


def write(found: Measurements, machine: dict[str, str], facts: Facts) -> list[Section]:
    chains, decades = chains_table(found), chain_decades_table(found)
    parts: list = []
    if chains.rows:
        parts += ["A game cuts pieces of pieces. Here always the largest piece is cut through its centre of mass, a hundred "
                  "times. *Worst / predicted* is the cut that costs the most compared with what its crossing triangles "
                  "predict, by a line through all cuts of the chain; each cut is the median of five chains, so that what is "
                  "left is the cut's own.",
                  ShownTable(chains, "Chains of a hundred cuts.", published=True)]
    if decades.rows:
        parts += ["Pieces of the half-edge back end share one index buffer, and each cut leaves a piece in a few more runs of "
                  "it. *Compacted* moves a piece into buffers of its own when it asks for that, off the timed path; what that "
                  "took is in the table.",
                  ShownFigure("chain_times", "Time of a cut in a chain of a thousand."),
                  ShownFigure("chain_ranges", "Draw ranges a piece, mean of all pieces, after so many cuts."),
                  ShownTable(decades, "Chains of a thousand cuts: cut times since the mark before, draw ranges at the mark.",
                             folded=True)]
    return [Section("chains", "A hundred and a thousand cuts in a row", parts)]
