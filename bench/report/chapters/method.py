"""What the numbers were measured on, and how."""

from report.chapters.section import Facts, Section, ShownTable
from report.measurements import Measurements
from report.tables.run_tables import numbers_table, stages_table
from report.tables.table import Column, Table


def write(found: Measurements, machine: dict[str, str], facts: Facts) -> list[Section]:
    facts_table = Table("machine", [Column("what", "what"), Column("value", "value")],
                        [{"what": name, "value": value} for name, value in machine.items()])
    return [Section("method", "How this was measured", [
        "Times are processor time of one thread, so that other load counts as little as it can. They are medians of "
        "repetitions (tables say how many), shown with two digits, or three if the first is a 1 and the spread is at "
        "most 10 %. Spread is (highest − lowest) / median. Other libraries cut each plane once.",
        "Every result is checked before it is timed, which warms up: closed, volumes and areas add up, nothing on the "
        "wrong side. Cutting consumes its input: each repetition gets a fresh copy, which is not timed. Memory is "
        "kept by the allocator, as a game's does.",
        "Exact counters (triangles touched, nodes, bytes, comparisons) are the same on every run. Tests hold those of "
        "fixed cuts to within three per cent: twice the work would fail them.",
        "`./run report` repeats it: `--quick` takes less than three minutes, `--full` goes up to 16 million triangles, "
        "`--peers` installs VTK and Open3D and times them, too. `./run compare-speed REV` times an older revision beside this one.",
        ShownTable(facts_table, "Machine, compiler, versions, seeds and commit.", published=True, folded=True),
        ShownTable(stages_table(found), "What was run, when, and how busy the machine was.", listing=True),
        ShownTable(numbers_table(found), "Every counter of every benchmark.", listing=True)])]
