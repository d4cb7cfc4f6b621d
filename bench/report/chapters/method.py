"""What the numbers were measured on, and how."""

from report.chapters.section import Facts, Section, ShownTable
from report.measurements import Measurements
from report.tables.run_tables import numbers_table, stages_table
from report.tables.table import Column, Table


def write(found: Measurements, machine: dict[str, str], facts: Facts) -> list[Section]:
    facts_table = Table("machine", [Column("what", "what"), Column("value", "value")],
                        [{"what": name, "value": value} for name, value in machine.items()])
    return [Section("method", "How this was measured", [
        "Times are processor time of one thread, so that other load counts as little as it can; the page's CSV `stages` "
        "has the load before and after each stage. Every result is checked first, which warms up; benchmarks are repeated (tables say how "
        "often) and given as medians of the repetitions with their spread, (highest − lowest) / median. Other libraries cut each "
        "plane once. Cutting consumes its input, so each repetition gets a fresh copy, untimed. Results are used, and "
        "checked (closed, volumes and areas add up, nothing on the wrong side) before it is timed. Memory "
        "is kept by the allocator, as a game's does.",
        "Exact counters (triangles touched, nodes, bytes, comparisons) are the same on every run; tests hold those of fixed cuts to "
        "within three per cent, so that twice the work would fail them.",
        "Repeat it with `./run report`; `--quick` takes less than three minutes, `--full` goes up to 16 million triangles, "
        "`--peers` installs VTK and times it, too. `bench/compare REV_A REV_B` times two revisions against each other.",
        ShownTable(facts_table, "Machine, compiler, versions, seeds and commit.", published=True),
        ShownTable(stages_table(found), "What was run, when, and how busy the machine was.", folded=True),
        ShownTable(numbers_table(found), "Every counter of every benchmark.", folded=True)])]
