"""What was run, and every number of it."""

from report.measurements import Measurements
from report.names import Kind
from report.tables.numbers import digits
from report.tables.table import Column, Table


def stages_table(found: Measurements) -> Table:
    """What was run, when, how long, and how busy the machine was."""
    table = Table("stages", [Column("stage", "stage"), Column("date", "when"), Column("commit", "commit"),
                             Column("repetitions", "repetitions"),
                             Column("seconds", "seconds", digits(1)), Column("load_before", "load before", digits(1)),
                             Column("load_after", "load after", digits(1))])
    for stage in found.stages:
        is_bench = Kind(stage["kind"]) == Kind.BENCH
        table.rows.append({"stage": stage["stage"], "date": stage["date"], "commit": stage["commit"],
                           "repetitions": int(stage["command"][2]) if is_bench else None, "seconds": stage["seconds"],
                           "load_before": stage["load"][0], "load_after": stage["load"][1]})
    return table


def numbers_table(found: Measurements) -> Table:
    """Every counter of every benchmark: median, lowest and highest of the repetitions."""
    table = Table("benchmarks", [Column(key, key) for key in ("benchmark", "counter", "median", "lowest", "highest")])
    bookkeeping = {"family_index", "per_family_instance_index", "repetitions", "repetition_index", "threads"}
    for name, counters in found.bench.items():
        for counter, (middle, lowest, highest) in counters.items():
            if counter not in bookkeeping:
                table.rows.append({"benchmark": name, "counter": counter, "median": middle, "lowest": lowest,
                                   "highest": highest})
    return table
