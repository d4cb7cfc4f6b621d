"""The tables of the page, made of measurements. Each is written as CSV as well: the page shows no other numbers."""

from report.tables.core import (ABSENT, Column, Formatter, Table, Value, count, count_short, digits, median, microseconds,
                                milliseconds, percent, rounded, scientific, short, spread_of, worst_spread)
from report.tables.growth import (EXTENTS, ORDERS, counter_exponents_table, counters_table, crossing_table, crossovers_table,
                                  phases_table, scaling_points_table, scaling_table)
from report.tables.prepare import chain_balance_table, prepare_table
from report.tables.method import numbers_table, stages_table
from report.tables.models import cuts_table, frames_table, hulls_table, model_exponents_table, sizes_table, worst_frames_table
from report.tables.peers import peers_by_mesh_table, peers_table, problem_of
from report.tables.pieces import (chain_decades_table, chains_table, distribution_table, proxies_table, swipes_table,
                                  viewer_cuts_table, viewer_distribution_table)

__all__ = [name for name in dir() if not name.startswith("_")]
