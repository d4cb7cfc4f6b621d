"""What the numbers were measured on, and how."""

from report.measurements import Measurements
from report.sections import Facts, Section, ShownTable
from report.tables import Column, Table, numbers_table, stages_table


def write(found: Measurements, machine: dict[str, str], facts: Facts) -> list[Section]:
    facts_table = Table("machine", [Column("what", "what"), Column("value", "value")],
                        [{"what": name, "value": value} for name, value in machine.items()])
    return [Section("method", "How this was measured", [
        "Times are processor time of one thread, so that other load counts as little as it can; loads before and after each "
        "stage are noted below. Every benchmark warms up, is repeated, and is given as the median of its repetitions with "
        "their spread; cutting consumes its input, so each repetition gets a fresh copy, untimed. Results are used, and every "
        "result is checked (closed, volumes and areas add up, nothing on the wrong side) before it is timed. Memory "
        "is kept by the allocator, as a game's does.",
        "Exact counters (triangles touched, nodes, bytes, comparisons) are the same on every run; the tests hold them.",
        "Repeat it with `./run report`; `--quick` takes less than three minutes, `--full` goes up to 16 million triangles, "
        "`--peers` installs VTK and times it, too. `bench/compare REV_A REV_B` times two revisions against each other.",
        ShownTable(facts_table, "Machine, compiler, versions, seeds and commit.", published=True),
        ShownTable(stages_table(found), "What was run, when, and how busy the machine was.", folded=True),
        ShownTable(numbers_table(found), "Every counter of every benchmark.", folded=True)])]
